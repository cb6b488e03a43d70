// blue_noise.cpp: void and cluster [Ulichney93]: of a pattern of points, the one in the tightest
// cluster goes first and the next one comes into the largest void. Energies are integers, so that
// adding and taking away leaves no trace and every compiler ranks alike.
#include "core/optics/blue_noise.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>

namespace neph {
namespace {

constexpr int kSide = kBlueNoiseSize;
constexpr int kCount = kSide * kSide;
constexpr double kSigma = 1.5;       // places; [Ulichney93]
constexpr double kUnit = 1LL << 48;  // energy at a point
constexpr int kReach = 12;           // e^-32 of a point: a unit of 2^48 tells it from nothing
constexpr int kFirst = kCount / 10;  // points of the initial pattern; any minority does

using Energy = std::int64_t;
// Sets points apart from empty places, beyond any sum of energies.
constexpr Energy kPoint = 1LL << 60;

/// Points on a torus and what they add up to at each place.
class Points {
  public:
    Points() {
        for (int dy = -kReach; dy <= kReach; ++dy) {
            for (int dx = -kReach; dx <= kReach; ++dx) {
                kernel_[at(dy + kReach, dx + kReach, kWidth)] =
                    std::llround(kUnit * std::exp(-(dx * dx + dy * dy) / (2.0 * kSigma * kSigma)));
            }
        }
    }

    bool has(std::size_t place) const { return energy_[place] >= kPoint; }

    void flip(std::size_t place) {
        const Energy sign = has(place) ? -1 : 1;
        energy_[place] += sign * kPoint;
        const int x = static_cast<int>(place) % kSide, y = static_cast<int>(place) / kSide;
        for (int dy = -kReach; dy <= kReach; ++dy) {
            for (int dx = -kReach; dx <= kReach; ++dx) {
                energy_[at((y + dy + kSide) % kSide, (x + dx + kSide) % kSide, kSide)] +=
                    sign * kernel_[at(dy + kReach, dx + kReach, kWidth)];
            }
        }
    }

    std::size_t tightestCluster() const { return placeOfLeast(-1); }
    std::size_t largestVoid() const { return placeOfLeast(1); }

  private:
    static constexpr int kWidth = 2 * kReach + 1;

    static std::size_t at(int row, int column, int width) {
        return static_cast<std::size_t>(row * width + column);
    }

    /// Where the energy, times a sign, is least; the first such place.
    std::size_t placeOfLeast(Energy sign) const {
        std::size_t found = 0;
        Energy least = sign * energy_[0];
        for (std::size_t place = 1; place < kCount; ++place) {
            if (sign * energy_[place] >= least) continue;
            least = sign * energy_[place];
            found = place;
        }
        return found;
    }

    std::array<Energy, kWidth * kWidth> kernel_{};
    std::array<Energy, kCount> energy_{};
};

/// Random points, moved from clusters to voids until none gains by it.
Points initialPoints() {
    Points points;
    std::mt19937 random(1);  // the standard pins its numbers, not those of distributions
    for (int placed = 0; placed < kFirst;) {
        const std::size_t place = random() % kCount;
        if (points.has(place)) continue;
        points.flip(place);
        ++placed;
    }
    for (;;) {
        const std::size_t from = points.tightestCluster();
        points.flip(from);
        const std::size_t to = points.largestVoid();
        points.flip(to);
        if (to == from) return points;
    }
}

std::vector<float> makeBlueNoise() {
    const auto valueOf = [](int rank) { return (static_cast<float>(rank) + 0.5f) / kCount; };
    const Points initial = initialPoints();
    std::vector<float> values(kCount);
    Points points = initial;
    for (int rank = kFirst - 1; rank >= 0; --rank) {
        const std::size_t place = points.tightestCluster();
        values[place] = valueOf(rank);
        points.flip(place);
    }
    // Beyond half, the paper takes the tightest cluster of empty places; as the energies of points
    // and of empty places add up to a constant, that is the largest void still.
    points = initial;
    for (int rank = kFirst; rank < kCount; ++rank) {
        const std::size_t place = points.largestVoid();
        values[place] = valueOf(rank);
        points.flip(place);
    }
    return values;
}

}  // namespace

const std::vector<float>& blueNoise() {
    static const std::vector<float> values = makeBlueNoise();
    return values;
}

}  // namespace neph
