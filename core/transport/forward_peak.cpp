// forward_peak.cpp: Legendre series on the angles of the table.
#include "core/transport/forward_peak.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "shaders/lib/glsl_cpp.h"

namespace neph {
namespace {

// Degrees resolve about 0.3 degrees, half the sun's disc; the highest fade out, so that nothing
// rings where a peak is finer.
constexpr int kDegrees = 600;
constexpr int kPointsPerEntry = 4;  // of the integrals, midpoints
constexpr double kLeastShare = 1e-3;
constexpr double kPi = std::numbers::pi;
constexpr auto kWidestRad = static_cast<float>(kPi / 3.0);
constexpr int kWavelengths = 3, kMiddle = 1;

using Moments = std::array<std::vector<double>, kWavelengths>;

/// The Legendre polynomials at many angles, degree after degree.
class LegendreRows {
  public:
    explicit LegendreRows(std::vector<double> cosines)
        : cosines_(std::move(cosines)), before_(cosines_.size(), 0.0), row_(cosines_.size(), 1.0) {}
    const std::vector<double>& row() const { return row_; }
    void next() {
        const double ofRow = (2.0 * degree_ + 1.0) / (degree_ + 1.0);
        const double ofBefore = degree_ / (degree_ + 1.0);
        for (std::size_t i = 0; i < row_.size(); ++i) {
            const double above = ofRow * cosines_[i] * row_[i] - ofBefore * before_[i];
            before_[i] = row_[i];
            row_[i] = above;
        }
        degree_ += 1.0;
    }

  private:
    double degree_ = 0.0;
    std::vector<double> cosines_, before_, row_;
};

/// Integrals of the table times each polynomial over the sphere.
Moments momentsOf(const PhaseTable& phase) {
    const std::size_t points = (phase.size() - 1) * kPointsPerEntry;
    std::vector<double> cosines(points);
    std::array<std::vector<double>, kWavelengths> weighted;
    for (auto& values : weighted) values.resize(points);
    for (std::size_t i = 0; i < points; ++i) {
        const double entry = (static_cast<double>(i) + 0.5) / kPointsPerEntry;
        const auto below = static_cast<std::size_t>(entry);
        const double x = entry / static_cast<double>(phase.size() - 1);
        const double theta = kPi * x * x;
        cosines[i] = std::cos(theta);
        const auto share = static_cast<float>(entry - static_cast<double>(below));
        const glm::vec3 value = glm::mix(phase[below], phase[below + 1], share);
        for (int w = 0; w < kWavelengths; ++w) {
            weighted[static_cast<std::size_t>(w)][i] =
                x * std::sin(theta) * static_cast<double>(value[w]);
        }
    }
    Moments moments;
    LegendreRows legendre(std::move(cosines));
    for (int l = 0; l < kDegrees; ++l, legendre.next()) {
        for (std::size_t w = 0; w < weighted.size(); ++w) {
            double sum = 0.0;
            for (std::size_t i = 0; i < points; ++i) sum += weighted[w][i] * legendre.row()[i];
            moments[w].push_back(4.0 * kPi * kPi / static_cast<double>(points) * sum);
        }
    }
    return moments;
}

/// Times 1, or less for the highest degrees.
double faded(int l) {
    const double share = static_cast<double>(l) / kDegrees;
    return std::exp(-4.0 * share * share);
}

/// 1 forward, 0 from the first ring on, or from kWidestRad on.
float insideRings(int entry, int entries, int degree) {
    const float endRad = std::min(static_cast<float>(kPi / degree), kWidestRad);
    return 1.0f - glm::smoothstep(0.5f * endRad, endRad, glsl::phaseTableTheta(entry, entries));
}

}  // namespace

std::vector<PhaseTable> peaksOf(const PhaseTable& phase, int degree,
                                std::span<const double> times) {
    std::vector<PhaseTable> peaks(times.size(), PhaseTable(phase.size(), glm::vec3(0.0f)));
    const Moments moments = momentsOf(phase);
    const double share =
        moments[kMiddle][static_cast<std::size_t>(degree)] / moments[kMiddle].front();
    if (share < kLeastShare) return peaks;
    const int entries = static_cast<int>(phase.size());
    std::vector<double> cosines;
    for (int i = 0; i < entries; ++i) {
        cosines.push_back(static_cast<double>(std::cos(glsl::phaseTableTheta(i, entries))));
    }
    LegendreRows legendre(std::move(cosines));
    std::vector<std::vector<glm::dvec3>> sums(times.size(), std::vector<glm::dvec3>(phase.size()));
    for (int l = 0; l < kDegrees; ++l, legendre.next()) {
        for (std::size_t n = 0; n < times.size(); ++n) {
            glm::dvec3 moment(share * faded(l) * (2.0 * l + 1.0) / (4.0 * kPi));
            for (int w = 0; w < kWavelengths; ++w) {
                const auto& ofColour = moments[static_cast<std::size_t>(w)];
                const double peak = ofColour[static_cast<std::size_t>(l)] / (share * ofColour[0]);
                moment[w] *= ofColour[0] * std::pow(std::clamp(peak, 0.0, 1.0), times[n]);
            }
            for (std::size_t i = 0; i < phase.size(); ++i) sums[n][i] += moment * legendre.row()[i];
        }
    }
    for (std::size_t n = 0; n < times.size(); ++n) {
        for (int i = 0; i < entries; ++i) {
            const auto at = static_cast<std::size_t>(i);
            peaks[n][at] =
                insideRings(i, entries, degree) * glm::vec3(glm::max(sums[n][at], glm::dvec3(0.0)));
        }
    }
    return peaks;
}

}  // namespace neph
