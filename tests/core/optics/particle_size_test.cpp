// particle_size_test.cpp: size distributions against docs/physics.md §7 and against sums over
// sizes.
#include "core/optics/particle_size.h"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <numbers>

using namespace neph;
using doctest::Approx;

namespace {

/// A moment of N λ^(μ+1)/Γ(μ+1) D^μ e^(-λD), by the midpoint rule to 60 mean sizes.
double moment(double order, double number, double slope, double mu) {
    constexpr int kSteps = 200'000;
    const double step = 60.0 * (mu + 1.0) / slope / kSteps;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double d = (i + 0.5) * step;
        sum += std::pow(d, order + mu) * std::exp(-slope * d) * step;
    }
    return number * std::pow(slope, mu + 1.0) / std::tgamma(mu + 1.0) * sum;
}

constexpr double kContent = 1e-3;  // kg/m³

}  // namespace

TEST_CASE(
    "A gamma distribution weighs what it should, and has the radius and extinction of its "
    "moments") {
    for (const double mu : {0.0, 2.0, 4.83, 12.0}) {
        CAPTURE(mu);
        const double number = 3e7, density = 700.0;
        const double slope = gammaSlopePerM(kContent, number, density, mu);
        const double m2 = moment(2.0, number, slope, mu), m3 = moment(3.0, number, slope, mu);
        CHECK(std::numbers::pi / 6.0 * density * m3 == Approx(kContent).epsilon(1e-6));
        const double radiusM = effectiveRadiusM(slope, mu);
        CHECK(radiusM == Approx(0.5 * m3 / m2).epsilon(1e-6));
        // Twice the area of shadows: Q = 2.
        CHECK(geometricExtinctionPerM(kContent, radiusM, density) ==
              Approx(2.0 * std::numbers::pi / 4.0 * m2).epsilon(1e-6));
        // Closed form: (π/2) N (μ+1) (μ+2) / λ².
        CHECK(geometricExtinctionPerM(kContent, radiusM, density) ==
              Approx(std::numbers::pi / 2.0 * number * (mu + 1.0) * (mu + 2.0) / (slope * slope)));
    }
}

TEST_CASE("An exponential distribution of fixed intercept has extinction pi N0 / slope cubed") {
    const double slope = interceptSlopePerM(kContent, 8e6, 1000.0);
    CHECK(std::numbers::pi / 6.0 * 1000.0 * moment(3.0, 8e6 / slope, slope, 0.0) ==
          Approx(kContent).epsilon(1e-6));
    const double extinction =
        geometricExtinctionPerM(kContent, effectiveRadiusM(slope, 0.0), 1000.0);
    CHECK(extinction == Approx(std::numbers::pi * 8e6 / (slope * slope * slope)));
    CHECK(extinction / kContent == Approx(2.24).epsilon(2e-3));
}

TEST_CASE("Extinction of a fixed intercept goes as content to the power of three quarters") {
    const auto extinction = [](double content) {
        const double slope = interceptSlopePerM(content, 4e6, 500.0);
        return geometricExtinctionPerM(content, effectiveRadiusM(slope, 0.0), 500.0);
    };
    CHECK(extinction(16e-4) / extinction(1e-4) == Approx(8.0));
}

TEST_CASE("Equal spheres of 1 g per m3 in 300 per cm3 have a radius of 9.3 um") {
    CHECK(equalSpheresRadiusM(kContent, 3e8, 1000.0) == Approx(9.3e-6).epsilon(5e-3));
}

TEST_CASE("Mass extinction of the radii of the paper's table 3 and of model ice") {
    CHECK(geometricExtinctionPerM(1.0, 10e-6, 1000.0) == Approx(150.0));
    CHECK(geometricExtinctionPerM(1.0, 1e-3, 917.0) == Approx(1.636).epsilon(3e-4));
    CHECK(geometricExtinctionPerM(1.0, 20e-6, 917.0) == Approx(82.0).epsilon(5e-3));
    CHECK(geometricExtinctionPerM(1.0, 50e-6, 917.0) == Approx(33.0).epsilon(1e-2));
}

TEST_CASE("Snow of 1 g per m3 at -20 degrees has an effective radius of 480 um") {
    const double second = kContent / 0.069;
    CHECK(0.5 * snowThirdMoment(second, 253.15) / second == Approx(480e-6).epsilon(2e-3));
}

TEST_CASE("Snow grows as it gets warmer, up to freezing") {
    const double second = kContent / 0.069;
    double before = 0.0;
    for (double kelvin = 213.15; kelvin < 273.0; kelvin += 5.0) {
        CAPTURE(kelvin);
        const double third = snowThirdMoment(second, kelvin);
        CHECK(third > before);
        before = third;
    }
    CHECK(snowThirdMoment(second, 280.0) == snowThirdMoment(second, 273.15));
}
