// spectrum.h: visible light by wavelength, and what of it an eye makes.
//
// Eight wavelengths stand for 380 ... 720 nm. Between them what is scattered and absorbed in air
// varies so slowly that colours are right to a few thousandths.
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>

namespace neph {

inline constexpr std::size_t kSpectrumSize = 8;
inline constexpr std::array<double, kSpectrumSize> kSpectrumNm{400.0, 440.0, 480.0, 520.0,
                                                               560.0, 600.0, 640.0, 680.0};

/// One value for each of these wavelengths.
struct Spectrum {
    std::array<float, kSpectrumSize> at{};

    Spectrum() = default;
    explicit Spectrum(float everywhere) { at.fill(everywhere); }
    bool operator==(const Spectrum&) const = default;

    Spectrum& operator+=(const Spectrum& b) {
        for (std::size_t i = 0; i < kSpectrumSize; ++i) at[i] += b.at[i];
        return *this;
    }
    Spectrum& operator*=(const Spectrum& b) {
        for (std::size_t i = 0; i < kSpectrumSize; ++i) at[i] *= b.at[i];
        return *this;
    }
    Spectrum& operator*=(float b) {
        for (float& value : at) value *= b;
        return *this;
    }
};

inline Spectrum operator+(Spectrum a, const Spectrum& b) {
    return a += b;
}
inline Spectrum operator*(Spectrum a, const Spectrum& b) {
    return a *= b;
}
inline Spectrum operator*(float a, Spectrum b) {
    return b *= a;
}

/// e^-x for x >= 0, within 3e-7 of the value. A loop that compilers turn into vector code.
inline Spectrum expMinus(const Spectrum& x) {
    constexpr float kLog2E = 1.44269504f, kMost = 126.0f;
    Spectrum y;
    for (std::size_t i = 0; i < kSpectrumSize; ++i) {
        const float exponent = std::min(x.at[i] * kLog2E, kMost);
        const auto whole = static_cast<std::int32_t>(exponent + 0.5f);
        const float f = static_cast<float>(whole) - exponent;  // within 1/2 of 0
        // Taylor series of 2^f.
        float p = 1.5403530e-4f;
        p = p * f + 1.3333558e-3f;
        p = p * f + 9.6181291e-3f;
        p = p * f + 5.5504109e-2f;
        p = p * f + 2.4022651e-1f;
        p = p * f + 6.9314718e-1f;
        p = p * f + 1.0f;
        y.at[i] = p * std::bit_cast<float>((127 - whole) << 23);
    }
    return y;
}

/// Irradiance of the sun outside the atmosphere as the eye weighs it, by V(lambda), W/m²; 683 times
/// this are lux. [Bruneton17] has the spectrum.
double solarIrradianceWPerM2();

/// What a value of 1 of an image stands for: the radiance that isotropic scatter has in the light
/// of the sun outside the atmosphere, weighed likewise, W m⁻² sr⁻¹; 683 times this are cd/m².
double imageUnitWPerM2Sr();
inline constexpr double kLumensPerW = 683.0;

/// Linear sRGB (IEC 61966-2-1, white D65) of light whose spectrum is that of the sun times `share`,
/// by the CIE 1931 matching functions [Wyman13]. Its luminance is 1 for a share of 1. Colours that
/// sRGB lacks are brought to its edge.
glm::dvec3 rgbOfSunlight(const Spectrum& share);

}  // namespace neph
