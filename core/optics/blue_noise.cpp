// blue_noise.cpp: the void-and-cluster method [Ulichney93]: of a pattern of points, the one in the
// tightest cluster is removed first, and the next one is placed in the largest void. Energies are
// integers, so that adding and subtracting leaves no residue and every compiler computes the same
// ranks.
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
constexpr double kSigma = 1.5;       // in places; [Ulichney93]
constexpr double kUnit = 1LL << 48;  // energy at a point
constexpr int kReach = 12;  // beyond, a point adds less than e^-32, which 2^48 still resolves
constexpr int kFirst = kCount / 10;  // points of the initial pattern; any minority will do

using Energy = std::int64_t;
// Marks the places of points: larger than any sum of energies.
constexpr Energy kPoint = 1LL << 60;

/// Points on a torus, and the sum of their energies at each place.
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

    /// The first place where the energy times a sign is smallest.
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

/// Random points, moved from clusters to voids until no move improves the pattern.
Points initialPoints() {
    Points points;
    std::mt19937 random(1);  // the standard fixes its output, but not that of distributions
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
    // Beyond half, the paper removes the tightest cluster of empty places. The energies of points
    // and of empty places add up to a constant, so that is still the largest void.
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
