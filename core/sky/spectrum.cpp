// spectrum.cpp: matching functions, the sun, and the weights of eight wavelengths.
#include "core/sky/spectrum.h"

#include <cmath>
#include <numbers>

namespace neph {
namespace {

using glm::dmat3, glm::dvec3;

constexpr double kFirstNm = 380.0, kLastNm = 720.0, kStepNm = 5.0;

/// Irradiance outside the atmosphere at 360, 370, ... 720 nm, W m⁻² nm⁻¹. [Bruneton17]
constexpr std::array<double, 37> kSolar{
    1.11776, 1.14259, 1.01249, 1.14716, 1.72765, 1.73054, 1.6887,  1.61253, 1.91198, 2.03474,
    2.02042, 2.02212, 1.93377, 1.95809, 1.91686, 1.8298,  1.8685,  1.8931,  1.85149, 1.8504,
    1.8341,  1.8345,  1.8147,  1.78158, 1.7533,  1.6965,  1.68194, 1.64654, 1.6048,  1.52143,
    1.55622, 1.5113,  1.474,   1.4482,  1.41018, 1.36775, 1.34188};

double solarAt(double nm) {
    const double place = (nm - 360.0) / 10.0;
    const auto i = static_cast<std::size_t>(place);
    if (i + 1 >= kSolar.size()) return kSolar.back();
    return std::lerp(kSolar[i], kSolar[i + 1], place - static_cast<double>(i));
}

double lobe(double nm, double peak, double below, double above) {
    const double x = (nm - peak) / (nm < peak ? below : above);
    return std::exp(-0.5 * x * x);
}

/// CIE 1931, 2 degrees; the fit of several lobes. [Wyman13]
dvec3 matching(double nm) {
    return {1.056 * lobe(nm, 599.8, 37.9, 31.0) + 0.362 * lobe(nm, 442.0, 16.0, 26.7) -
                0.065 * lobe(nm, 501.1, 20.4, 26.2),
            0.821 * lobe(nm, 568.8, 46.9, 40.5) + 0.286 * lobe(nm, 530.9, 16.3, 31.1),
            1.217 * lobe(nm, 437.0, 11.8, 36.0) + 0.681 * lobe(nm, 459.0, 26.0, 13.8)};
}

/// IEC 61966-2-1
dvec3 srgbOf(const dvec3& xyz) {
    const dmat3 rows{{3.2404542, -1.5371385, -0.4985314},
                     {-0.9692660, 1.8760108, 0.0415560},
                     {0.0556434, -0.2040259, 1.0572252}};
    return xyz * rows;
}

/// Calls `take` with each wavelength and the XYZ of the sunlight around it, W m⁻².
template <typename Take>
void forEachWavelength(const Take& take) {
    for (double nm = kFirstNm; nm <= kLastNm; nm += kStepNm) {
        take(nm, kStepNm * solarAt(nm) * matching(nm));
    }
}

double solarLuminance() {
    double sum = 0.0;
    forEachWavelength([&](double, const dvec3& xyz) { sum += xyz.y; });
    return sum;
}

/// RGB that a share of 1 at one wavelength gives, with shares that are linear in between.
std::array<dvec3, kSpectrumSize> makeWeights() {
    std::array<dvec3, kSpectrumSize> weights{};
    const double all = solarLuminance();
    const double apartNm = kSpectrumNm[1] - kSpectrumNm[0];
    forEachWavelength([&](double nm, const dvec3& xyz) {
        const double last = static_cast<double>(kSpectrumSize - 1);
        const double place = std::clamp((nm - kSpectrumNm[0]) / apartNm, 0.0, last);
        const auto i = std::min(static_cast<std::size_t>(place), kSpectrumSize - 2);
        const double share = place - static_cast<double>(i);
        const dvec3 rgb = srgbOf(xyz) / all;
        weights[i] += (1.0 - share) * rgb;
        weights[i + 1] += share * rgb;
    });
    return weights;
}

/// Towards grey of the same luminance, until no channel is negative.
dvec3 withinGamut(const dvec3& rgb) {
    const double grey = glm::dot(rgb, dvec3(0.2126729, 0.7151522, 0.0721750));
    const double least = std::min({rgb.r, rgb.g, rgb.b});
    if (least >= 0.0 || grey <= 0.0) return glm::max(rgb, dvec3(0.0));
    return glm::max(glm::mix(dvec3(grey), rgb, grey / (grey - least)), dvec3(0.0));
}

}  // namespace

double solarIrradianceWPerM2() {
    return solarLuminance();
}

double imageUnitWPerM2Sr() {
    return solarIrradianceWPerM2() / (4.0 * std::numbers::pi);
}

dvec3 rgbOfSunlight(const Spectrum& share) {
    static const std::array<dvec3, kSpectrumSize> weights = makeWeights();
    dvec3 rgb(0.0);
    for (std::size_t i = 0; i < kSpectrumSize; ++i) {
        rgb += static_cast<double>(share.at[i]) * weights[i];
    }
    return withinGamut(rgb);
}

}  // namespace neph
