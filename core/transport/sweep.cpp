// sweep.cpp: the sweep along one direction, and its distribution over threads.
//
// The source is interpolated as emission, extinction times source function: where there is no
// extinction a source function is not defined. A segment is two pieces with a point between the
// slices, its depth after Simpson.
#include "core/transport/sweep.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/parallel.h"
#include "core/transport/slice.h"

namespace neph {
namespace {

struct LightSlice {
    std::vector<float> radiance, emission, extinction;
};

/// Rows of what a slice is fed with.
struct UpwindRows {
    std::vector<float> radiance, emission, extinction, midEmission, midExtinction, scratch;
};

/// The sweep along one direction. `kMoments` is kBroadMoments or kAlignedMoments.
template <int kMoments>
class DirectionSweep {
  public:
    DirectionSweep(const SweepInput& input, const LightDirection& direction, LightField& sum);
    void run();

  private:
    static constexpr int kDegrees = degreeOf(kMoments - 1) + 1;

    int sliceAt(int step) const {
        return travel_[axis_] > 0.0f ? step : grid_.nodes[axis_] - 1 - step;
    }
    std::size_t nodeAt(int slice, int c) const {
        return static_cast<std::size_t>(slice) * step_[static_cast<std::size_t>(axis_)] +
               static_cast<std::size_t>(c) * step_[static_cast<std::size_t>(axisC_)];
    }
    /// The horizontal plane of the ground is row 0 of a slice, or a slice of its own.
    bool onGround(int slice, int c) const { return axis_ == 2 ? slice == 0 : c == 0; }
    float emissionOf(std::size_t node) const;
    void load(int slice, LightSlice& into) const;
    void enter(int slice);
    void feed(int slice);
    void interpolate(int c);
    void integrate(float* radiance, const float* emission, const float* extinction) const;
    void setBoundaries(int slice, int c, float* radiance) const;
    void advance(int step, bool keep);
    void collect(int slice);
    void settle();

    const SweepInput& input_;
    const TransportLevel& level_;
    const TransportGrid& grid_;
    LightField& sum_;
    glm::vec3 travel_;
    float weight_;
    Harmonics value_{}, weighted_{};
    std::array<float, kDegrees>
        ofBeam_{};  ///< scattering of the beam into the direction, by degree
    int axis_ = 0, axisB_ = 1, axisC_ = 2;
    std::array<std::size_t, 3> step_{};
    float lengthM_ = 0.0f, offsetB_ = 0.0f, offsetC_ = 0.0f, inflow_ = 0.0f;
    SliceShape shape_;
    SliceTaps taps_, midTaps_;
    LightSlice before_, now_;
    UpwindRows rows_;
};

template <int kMoments>
DirectionSweep<kMoments>::DirectionSweep(const SweepInput& input, const LightDirection& direction,
                                         LightField& sum)
    : input_(input),
      level_(*input.level),
      grid_(level_.grid),
      sum_(sum),
      travel_(direction.travel),
      weight_(static_cast<float>(direction.weightSr)) {
    const glm::vec3 perNode = glm::abs(travel_) / glm::vec3(grid_.spacingM);
    for (int axis = 1; axis < 3; ++axis) {
        if (perNode[axis] > perNode[axis_]) axis_ = axis;
    }
    axisB_ = axis_ == 0 ? 1 : 0;
    axisC_ = axis_ == 2 ? 1 : 2;
    step_ = {1, static_cast<std::size_t>(grid_.nodes.x), grid_.columnCount()};
    lengthM_ = 1.0f / perNode[axis_];
    const glm::vec3 offset = -travel_ / glm::vec3(grid_.spacingM) * lengthM_;
    offsetB_ = offset[axisB_];
    offsetC_ = offset[axisC_];
    taps_ = SliceTaps(offsetB_, offsetC_);
    midTaps_ = SliceTaps(offsetB_ / 2.0f, offsetC_ / 2.0f);
    shape_ = {grid_.nodes[axisB_], grid_.nodes[axisC_], grid_.periodic(axisB_),
              grid_.periodic(axisC_)};
    inflow_ = travel_.z < 0.0f ? static_cast<float>(input.sky.radianceAt(-direction.travel.z))
                               : input.farGroundRadiance;
    value_ = harmonicsAt(direction.travel, input.sunTravel);
    for (std::size_t q = 0; q < value_.size(); ++q) weighted_[q] = weight_ * value_[q];
    const auto legendre = legendreAt<kAlignedDegrees>(glm::dot(direction.travel, input.sunTravel));
    for (std::size_t l = 0; l < ofBeam_.size(); ++l) {
        ofBeam_[l] = static_cast<float>((2.0 * static_cast<double>(l) + 1.0) * legendre[l] /
                                        (4.0 * std::numbers::pi));
    }
    for (LightSlice* slice : {&before_, &now_}) {
        for (auto* values : {&slice->radiance, &slice->emission, &slice->extinction}) {
            values->assign(shape_.size(), 0.0f);
        }
    }
    for (auto* row : {&rows_.radiance, &rows_.emission, &rows_.extinction, &rows_.midEmission,
                      &rows_.midExtinction, &rows_.scratch}) {
        row->assign(static_cast<std::size_t>(shape_.nb), 0.0f);
    }
}

template <int kMoments>
float DirectionSweep<kMoments>::emissionOf(std::size_t node) const {
    const auto place = static_cast<std::size_t>(level_.place[node]);
    const float* m = &input_.field->moments[place * kMoments];
    const float* scattering = &level_.scatteringPerM[place * kDegrees];
    const float beam = input_.beam != nullptr ? input_.beam[node] : 0.0f;
    const Harmonics& y = value_;
    float sum = scattering[0] * (m[0] * y[0] + beam * ofBeam_[0]);
    sum += scattering[1] * (m[1] * y[1] + m[2] * y[2] + m[3] * y[3] + beam * ofBeam_[1]);
    sum += scattering[2] * (m[4] * y[4] + m[5] * y[5] + m[6] * y[6] + m[7] * y[7] + m[8] * y[8] +
                            beam * ofBeam_[2]);
    for (std::size_t l = kBroadDegrees; l < kDegrees; ++l) {
        sum += scattering[l] * (m[l + 6] * y[l + 6] + beam * ofBeam_[l]);
    }
    return sum;
}

/// Emission and extinction of a slice; its radiance is left.
template <int kMoments>
void DirectionSweep<kMoments>::load(int slice, LightSlice& into) const {
    const std::size_t stepB = step_[static_cast<std::size_t>(axisB_)];
    for (int c = 0; c < shape_.nc; ++c) {
        const auto first = static_cast<std::size_t>(shape_.at(0, c));
        std::size_t node = nodeAt(slice, c);
        for (int b = 0; b < shape_.nb; ++b, node += stepB) {
            const float extinction = level_.extinctionPerM[node];
            const auto at = first + static_cast<std::size_t>(b);
            into.extinction[at] = extinction;
            into.emission[at] = extinction > 0.0f ? emissionOf(node) : 0.0f;
        }
    }
    shape_.fillBorder(into.emission);
    shape_.fillBorder(into.extinction);
}

/// The first slice of a sweep, through which light enters.
template <int kMoments>
void DirectionSweep<kMoments>::enter(int slice) {
    std::ranges::fill(now_.radiance, inflow_);
    for (int c = 0; c < shape_.nc; ++c) {
        setBoundaries(slice, c, &now_.radiance[static_cast<std::size_t>(shape_.at(0, c))]);
    }
}

/// What the nodes of row `c` see upwind of them.
template <int kMoments>
void DirectionSweep<kMoments>::interpolate(int c) {
    const int n = shape_.nb, stride = shape_.stride();
    const auto at = static_cast<std::size_t>(shape_.at(taps_.b, c + taps_.c));
    const auto mid = static_cast<std::size_t>(shape_.at(midTaps_.b, c + midTaps_.c));
    taps_.linearRow(&before_.radiance[at], stride, n, rows_.radiance.data());
    taps_.linearRow(&before_.emission[at], stride, n, rows_.emission.data());
    taps_.linearRow(&before_.extinction[at], stride, n, rows_.extinction.data());
    const auto middle = [&](const std::vector<float>& before, const std::vector<float>& now,
                            std::vector<float>& out) {
        midTaps_.linearRow(&before[mid], stride, n, out.data());
        midTaps_.linearRow(&now[mid], stride, n, rows_.scratch.data());
        for (std::size_t i = 0; i < out.size(); ++i) out[i] = 0.5f * (out[i] + rows_.scratch[i]);
    };
    middle(before_.emission, now_.emission, rows_.midEmission);
    middle(before_.extinction, now_.extinction, rows_.midExtinction);
    const bool inside = shape_.periodicC || (c + taps_.c >= 1 && c + taps_.c + 2 < shape_.nc);
    if (!input_.cubic || !inside) return;
    const int from = shape_.periodicB ? 0 : 1 - taps_.b;
    const int to = shape_.periodicB ? n : n - 2 - taps_.b;
    if (from < std::min(to, n)) {
        taps_.cubicRow(&before_.radiance[at] + from, stride, std::min(to, n) - from,
                       rows_.radiance.data() + from);
    }
}

template <int kMoments>
void DirectionSweep<kMoments>::integrate(float* radiance, const float* emission,
                                         const float* extinction) const {
    constexpr float kNone = 1e-30f, kLeast = 0.02f;
    const float* upRadiance = rows_.radiance.data();
    const float* upEmission = rows_.emission.data();
    const float* upExtinction = rows_.extinction.data();
    const float* midEmission = rows_.midEmission.data();
    const float* midExtinction = rows_.midExtinction.data();
    for (int i = 0; i < shape_.nb; ++i) {
        const float up = upExtinction[i], mid = midExtinction[i], at = extinction[i];
        const float depth = lengthM_ / 6.0f * (up + 4.0f * mid + at);
        const float half = lengthM_ / 24.0f * (5.0f * up + 8.0f * mid - at);
        const float first = std::min(std::max(half, kLeast * depth), (1.0f - kLeast) * depth);
        const float midSource = midEmission[i] / std::max(mid, kNone);
        const float upSource = up > kNone ? upEmission[i] / std::max(up, kNone) : midSource;
        const float atSource = at > kNone ? emission[i] / std::max(at, kNone) : midSource;
        const float between = throughPiece(upRadiance[i], upSource, midSource, first);
        radiance[i] = throughPiece(between, midSource, atSource, depth - first);
    }
}

/// Light that enters upwards at the ground, and through open sides beside a slice.
template <int kMoments>
void DirectionSweep<kMoments>::setBoundaries(int slice, int c, float* radiance) const {
    const int n = shape_.nb;
    const auto outside = [](float at, int nodes) {
        return at < 0.0f || at > static_cast<float>(nodes - 1);
    };
    if (travel_.z > 0.0f && onGround(slice, c)) {
        const int row = axis_ == 2 ? c : axis_ == 1 ? slice : 0;
        for (int b = 0; b < n; ++b) {
            const int x = axis_ == 0 ? slice : b, y = axis_ == 0 ? b : row;
            radiance[b] = input_.groundRadiance[grid_.index(x, y, 0)];
        }
        return;
    }
    const bool wholeRow = !shape_.periodicC && outside(static_cast<float>(c) + offsetC_, shape_.nc);
    for (int b = 0; b < n; ++b) {
        if (wholeRow || (!shape_.periodicB && outside(static_cast<float>(b) + offsetB_, n))) {
            radiance[b] = inflow_;
        }
    }
}

template <int kMoments>
void DirectionSweep<kMoments>::feed(int slice) {
    for (int c = 0; c < shape_.nc; ++c) {
        const auto at = static_cast<std::size_t>(shape_.at(0, c));
        interpolate(c);
        integrate(&now_.radiance[at], &now_.emission[at], &now_.extinction[at]);
        setBoundaries(slice, c, &now_.radiance[at]);
    }
}

template <int kMoments>
void DirectionSweep<kMoments>::advance(int step, bool keep) {
    const int slice = sliceAt(step);
    load(slice, now_);
    if (step == 0 && !grid_.periodic(axis_)) {
        enter(slice);
    } else {
        feed(slice);
    }
    shape_.fillBorder(now_.radiance);
    if (keep) collect(slice);
    std::swap(before_, now_);
}

template <int kMoments>
void DirectionSweep<kMoments>::collect(int slice) {
    const std::size_t stepB = step_[static_cast<std::size_t>(axisB_)];
    for (int c = 0; c < shape_.nc; ++c) {
        const float* radiance = &now_.radiance[static_cast<std::size_t>(shape_.at(0, c))];
        const bool arrives = travel_.z < 0.0f && onGround(slice, c);
        std::size_t node = nodeAt(slice, c);
        for (int b = 0; b < shape_.nb; ++b, node += stepB) {
            // The plane of the ground comes first among nodes: node is the column there.
            if (arrives) sum_.groundFlux[node] += weight_ * -travel_.z * radiance[b];
            const std::int32_t place = level_.place[node];
            if (place < 0) continue;
            float* moments = &sum_.moments[static_cast<std::size_t>(place) * kMoments];
            for (std::size_t q = 0; q < kMoments; ++q) moments[q] += radiance[b] * weighted_[q];
        }
    }
}

/// Goes round between periodic sides until what enters is what leaves.
template <int kMoments>
void DirectionSweep<kMoments>::settle() {
    constexpr int kMostLaps = 500;
    constexpr float kClose = 1e-4f;
    const int slices = grid_.nodes[axis_];
    load(sliceAt(slices - 1), before_);
    std::ranges::fill(before_.radiance, inflow_);
    for (int lap = 0; lap < kMostLaps; ++lap) {
        const std::vector<float> entered = before_.radiance;
        for (int step = 0; step < slices; ++step) advance(step, false);
        float change = 0.0f, most = 0.0f;
        for (std::size_t i = 0; i < entered.size(); ++i) {
            change = std::max(change, std::abs(before_.radiance[i] - entered[i]));
            most = std::max(most, std::abs(before_.radiance[i]));
        }
        if (change <= kClose * most) break;
    }
}

template <int kMoments>
void DirectionSweep<kMoments>::run() {
    if (grid_.periodic(axis_)) settle();
    for (int step = 0; step < grid_.nodes[axis_]; ++step) advance(step, true);
}

void addField(const LightField& from, LightField& to) {
    for (std::size_t i = 0; i < to.moments.size(); ++i) to.moments[i] += from.moments[i];
    for (std::size_t i = 0; i < to.groundFlux.size(); ++i) to.groundFlux[i] += from.groundFlux[i];
}

/// A random set has not quite the right flux through a horizontal plane.
void scaleGroundFlux(const SkyLight& sky, const LightDirections& directions, LightField& field) {
    const bool dark = sky == SkyLight{0.0, 0.0};
    double downward = 0.0;
    for (const LightDirection& d : directions) {
        const double up = -d.travel.z;
        if (up > 0.0) downward += d.weightSr * up * (dark ? 1.0 : sky.radianceAt(up));
    }
    const auto scale =
        static_cast<float>((dark ? std::numbers::pi : sky.irradiance()) / downward);
    for (float& flux : field.groundFlux) flux *= scale;
}

}  // namespace

LightField swept(const SweepInput& input, const LightDirections& directions, int threads) {
    constexpr std::size_t kWorthAThread = 4096;
    const TransportLevel& level = *input.level;
    const std::size_t groups =
        level.grid.nodeCount() < kWorthAThread ? 1 : static_cast<std::size_t>(std::max(threads, 1));
    std::vector<LightField> sums(groups);
    shareOut(groups, groups, [&](std::size_t group, std::size_t, const Progress&) {
        sums[group] = level.emptyField();
        for (std::size_t i = group; i < directions.size(); i += groups) {
            if (level.momentCount == kBroadMoments) {
                DirectionSweep<kBroadMoments>(input, directions[i], sums[group]).run();
            } else {
                DirectionSweep<kAlignedMoments>(input, directions[i], sums[group]).run();
            }
        }
    });
    for (std::size_t group = 1; group < groups; ++group) addField(sums[group], sums[0]);
    scaleGroundFlux(input.sky, directions, sums[0]);
    return std::move(sums[0]);
}

}  // namespace neph
