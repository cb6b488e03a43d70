// camera_path.cpp: between the keys, every number of the pose is a cubic that is smooth at the keys
// and stays between their values; the eye is placed so that what both keys share does not move.
//
// [FC80] F. N. Fritsch, R. E. Carlson: Monotone piecewise cubic interpolation, 1980.
#include "core/camera/camera_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace neph {
namespace {

/// The numbers of a pose that are interpolated. Azimuths may exceed 360°.
enum Channel { azimuth, elevation, distance, fov, targetX, targetY, targetZ, eyeX, eyeY, eyeZ };
constexpr std::size_t kChannels = 10;
using Values = std::array<double, kChannels>;

/// The grid that poses are relative to, for conversion to metres.
struct Frame {
    const RegularGrid& grid;
    glm::dvec3 targetM(const CameraPose& pose) const {
        return grid.originM + grid.extentM() * glm::dvec3(pose.target);
    }
    double unitM() const { return std::max(grid.extentM().x, grid.extentM().y); }
};

/// The angle equivalent to `deg` that is nearest to `nearDeg`.
double unwound(double deg, double nearDeg) {
    return deg - 360.0 * std::round((deg - nearDeg) / 360.0);
}

/// Azimuths are unwound, so that the camera turns the short way round.
std::vector<Values> valuesOf(const CameraPath& path, const Frame& frame) {
    std::vector<Values> all;
    for (const PathKey& key : path.keys) {
        const CameraPose& pose = key.pose;
        const glm::dvec3 target = frame.targetM(pose);
        const glm::dvec3 eye = placeCamera(pose, frame.grid, 1.0).eyeWorld;
        const auto turned = static_cast<double>(pose.azimuthDeg);
        all.push_back({all.empty() ? turned : unwound(turned, all.back()[azimuth]),
                       static_cast<double>(pose.elevationDeg), static_cast<double>(pose.distance),
                       static_cast<double>(pose.fovDeg), target.x, target.y, target.z, eye.x, eye.y,
                       eye.z});
    }
    return all;
}

/// Slope at a key between two others, per second: zero at an extremum, and never so steep that the
/// cubic leaves the range between its ends; Brodlie's mean, [FC80] sec. 4.
double slopeBetween(double before, double here, double after, double stepBeforeS,
                    double stepAfterS) {
    const double in = (here - before) / stepBeforeS, out = (after - here) / stepAfterS;
    if (in * out <= 0.0) return 0.0;
    const double weightIn = 2.0 * stepAfterS + stepBeforeS;
    const double weightOut = stepAfterS + 2.0 * stepBeforeS;
    return (weightIn + weightOut) / (weightIn / in + weightOut / out);
}

glm::dvec3 awayOf(const Values& v) {
    return compassDirWorld(static_cast<float>(v[azimuth]), static_cast<float>(v[elevation]));
}

/// The cubics of one path on one grid.
class Spline {
  public:
    Spline(const CameraPath& path, const Frame& frame)
        : path_(path), frame_(frame), values_(valuesOf(path, frame)) {
        for (std::size_t k = 0; k < values_.size(); ++k) slopes_.push_back(slopesAt(k));
        // At a key the velocity of the eye is continuous; it is zero if the eye rests on either
        // side.
        for (std::size_t k = 0; k < values_.size(); ++k) {
            const bool inside = k > 0 && k + 1 < values_.size() && moves(k - 1) && moves(k);
            velocities_.push_back(inside ? (velocity(k - 1, 1.0) + velocity(k, 0.0)) / 2.0
                                         : glm::dvec3(0.0));
        }
    }

    /// The pose at a fraction of the step from key `k` to the next.
    CameraPose pose(std::size_t k, double share) const {
        const Values v = between(k, share);
        const glm::dvec3 eye = heldEye(k, share) + correction(k, share);
        const glm::dvec3 target = eye - awayOf(v) * v[distance] * frame_.unitM();
        CameraPose pose;
        pose.fixedToGround = path_.keys.front().pose.fixedToGround;
        pose.target = TargetLimits{}.nearest(
            glm::vec3((target - frame_.grid.originM) / frame_.grid.extentM()));
        pose.distance = static_cast<float>(v[distance]);
        pose.azimuthDeg = static_cast<float>(v[azimuth] - 360.0 * std::floor(v[azimuth] / 360.0));
        pose.elevationDeg = static_cast<float>(v[elevation]);
        pose.fovDeg = static_cast<float>(v[fov]);
        return pose;
    }

  private:
    double stepS(std::size_t k) const { return path_.keys[k + 1].atS - path_.keys[k].atS; }

    /// Zero at both ends: the path starts and ends at rest.
    Values slopesAt(std::size_t k) const {
        Values slopes{};
        if (k == 0 || k + 1 == values_.size()) return slopes;
        for (std::size_t c = 0; c < kChannels; ++c) {
            slopes[c] = slopeBetween(values_[k - 1][c], values_[k][c], values_[k + 1][c],
                                     stepS(k - 1), stepS(k));
        }
        return slopes;
    }

    /// Cubic Hermite interpolation.
    Values between(std::size_t k, double u) const {
        const double rest = 1.0 - u, step = stepS(k);
        Values v{};
        for (std::size_t c = 0; c < kChannels; ++c) {
            v[c] = values_[k][c] * (1.0 + 2.0 * u) * rest * rest +
                   values_[k + 1][c] * u * u * (3.0 - 2.0 * u) +
                   step * u * rest * (slopes_[k][c] * rest - slopes_[k + 1][c] * u);
        }
        return v;
    }

    /// Blends an eye that moves on its own with one that moves around the target, according to
    /// which of the two points moves more.
    glm::dvec3 heldEye(std::size_t k, double u) const {
        const Values v = between(k, u);
        const glm::dvec3 eye{v[eyeX], v[eyeY], v[eyeZ]};
        const glm::dvec3 round = glm::dvec3(v[targetX], v[targetY], v[targetZ]) +
                                 awayOf(v) * v[distance] * frame_.unitM();
        const double eyeM2 = wayM2(k, eyeX), targetM2 = wayM2(k, targetX);
        return eyeM2 > 0.0 ? glm::mix(eye, round, eyeM2 / (eyeM2 + targetM2)) : eye;
    }

    /// Squared distance that a point, whose coordinates start at channel `x`, moves from key k to
    /// the next.
    double wayM2(std::size_t k, std::size_t x) const {
        double sum = 0.0;
        for (std::size_t c = x; c < x + 3; ++c) {
            const double way = values_[k + 1][c] - values_[k][c];
            sum += way * way;
        }
        return sum;
    }
    bool moves(std::size_t k) const {
        constexpr double kRest = 1e-6;  // of the domain: below the resolution of a pose in floats
        return std::sqrt(wayM2(k, eyeX)) > kRest * frame_.unitM();
    }

    /// Velocity of heldEye, metres per second.
    glm::dvec3 velocity(std::size_t k, double u) const {
        constexpr double kStep = 1e-4;  // of the step: balances rounding and curvature
        return (heldEye(k, u + kStep) - heldEye(k, u - kStep)) / (2.0 * kStep * stepS(k));
    }

    /// Offset of heldEye that gives it the required velocities at both ends.
    glm::dvec3 correction(std::size_t k, double u) const {
        const double rest = 1.0 - u;
        return stepS(k) * u * rest *
               ((velocities_[k] - velocity(k, 0.0)) * rest -
                (velocities_[k + 1] - velocity(k, 1.0)) * u);
    }

    const CameraPath& path_;
    Frame frame_;
    std::vector<Values> values_, slopes_;
    std::vector<glm::dvec3> velocities_;
};

}  // namespace

double durationS(const CameraPath& path) {
    return path.keys.empty() ? 0.0 : path.keys.back().atS;
}

namespace {

CameraPose between(const CameraPath& path, const RegularGrid& grid, double atS) {
    const auto after = std::ranges::upper_bound(path.keys, atS, {}, &PathKey::atS);
    if (after == path.keys.begin()) return path.keys.front().pose;
    const auto before = std::prev(after);
    if (after == path.keys.end() || before->atS == atS) return before->pose;
    const double share = (atS - before->atS) / (after->atS - before->atS);
    return Spline(path, {grid}).pose(static_cast<std::size_t>(before - path.keys.begin()), share);
}

}  // namespace

CameraPose poseAt(const CameraPath& path, const RegularGrid& grid, double atS) {
    if (path.keys.empty()) return {};
    CameraPose pose = between(path, grid, atS);
    pose.fixedToGround = path.keys.front().pose.fixedToGround;
    return pose;
}

void keepOnGround(CameraPath& path, const RegularGrid& grid, glm::dvec2 movedM) {
    if (path.keys.empty() || !path.keys.front().pose.fixedToGround) return;
    for (PathKey& key : path.keys) {
        key.pose.fixedToGround = true;
        keepOnGround(key.pose, grid, movedM);
    }
}

std::optional<int> timeAt(const CameraPath& path, double atS, int count) {
    const double whole = durationS(path);
    if (!path.withTime || whole <= 0.0 || count <= 0) return {};
    return std::clamp(static_cast<int>(std::floor(atS / whole * count)), 0, count - 1);
}

}  // namespace neph
