// particle_size.cpp: moments of gamma distributions, and the moment relation of snow.
#include "core/optics/particle_size.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace neph {
namespace {

constexpr double kPi = std::numbers::pi;

/// A polynomial of temperature (°C) and order of the moment, [Field05] table 2.
double fieldPolynomial(const std::array<double, 10>& c, double t, double n) {
    return c[0] + c[1] * t + c[2] * n + c[3] * t * n + c[4] * t * t + c[5] * n * n +
           c[6] * t * t * n + c[7] * t * n * n + c[8] * t * t * t + c[9] * n * n * n;
}

}  // namespace

double gammaSlopePerM(double contentKgPerM3, double numberPerM3, double densityKgPerM3, double mu) {
    const double momentRatio = (mu + 1.0) * (mu + 2.0) * (mu + 3.0);  // Γ(μ+4) / Γ(μ+1)
    return std::cbrt(kPi / 6.0 * densityKgPerM3 * numberPerM3 * momentRatio / contentKgPerM3);
}

double interceptSlopePerM(double contentKgPerM3, double interceptPerM4, double densityKgPerM3) {
    return std::sqrt(std::sqrt(kPi * densityKgPerM3 * interceptPerM4 / contentKgPerM3));
}

double effectiveRadiusM(double slopePerM, double mu) {
    return (mu + 3.0) / (2.0 * slopePerM);
}

double equalSpheresRadiusM(double contentKgPerM3, double numberPerM3, double densityKgPerM3) {
    return std::cbrt(3.0 * contentKgPerM3 / (4.0 * kPi * densityKgPerM3 * numberPerM3));
}

double geometricExtinctionPerM(double contentKgPerM3, double radiusM, double densityKgPerM3) {
    return 1.5 * contentKgPerM3 / (densityKgPerM3 * radiusM);
}

double snowThirdMoment(double secondMoment, double temperatureK) {
    constexpr std::array kA{5.065339, -0.062659, -3.032362, 0.029469, -0.000285,
                            0.312550, 0.000204,  0.003199,  0.0,      -0.015952};
    constexpr std::array kB{0.476221, -0.015896, 0.165977, 0.007468, -0.000141,
                            0.060366, 0.000079,  0.000594, 0.0,      -0.003577};
    // The fit is valid for snow below freezing.
    const double celsius = std::min(temperatureK - 273.15, -0.1);
    return std::pow(10.0, fieldPolynomial(kA, celsius, 3.0)) *
           std::pow(secondMoment, fieldPolynomial(kB, celsius, 3.0));
}

}  // namespace neph
