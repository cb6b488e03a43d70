// air_columns_test.cpp: how much air there is along a ray, and how much it bends it.
#include "core/sky/air_columns.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "core/sky/atmosphere.h"
#include "core/sky/solar_position.h"

using namespace neph;

namespace {

constexpr double kRad = std::numbers::pi / 180.0;

double sine(double deg) {
    return std::sin(deg * kRad);
}
double degrees(double up) {
    return std::asin(up) / kRad;
}

/// Against the light, by the equation of rays in space: d(n t)/ds = grad n. Euler's midpoint steps
/// of 20 m, with Cartesian coordinates and a gradient by differences.
BentRay followed(double altitudeM, double apparentDeg) {
    using glm::dvec2, glm::dvec3;
    constexpr double kStepM = 20.0;
    const auto altitudeAt = [](dvec2 at) { return glm::length(at) - kEarthRadiusM; };
    const auto turning = [&](dvec2 at) {  // grad n
        const double h = altitudeAt(at);
        return (refractivity(h + 1.0) - refractivity(h - 1.0)) / 2.0 * glm::normalize(at);
    };
    dvec2 at{0.0, kEarthRadiusM + altitudeM};
    dvec2 optical = (1.0 + refractivity(altitudeM)) *
                    dvec2(std::cos(apparentDeg * kRad), std::sin(apparentDeg * kRad));
    BentRay ray;
    while (altitudeAt(at) < kAtmosphereTopM) {
        const dvec2 half = optical + 0.5 * kStepM * turning(at);
        const dvec2 middle = at + 0.5 * kStepM * glm::normalize(optical);
        ray.columnsM += kStepM * airDensity(altitudeAt(middle));
        at += kStepM * glm::normalize(half);
        optical += kStepM * turning(middle);
    }
    ray.bending = apparentDeg * kRad - std::atan2(optical.y, optical.x);
    return ray;
}

}  // namespace

TEST_CASE("Air thins as the standard atmosphere does") {
    // [USSA76] table III: altitude, km, and density, kg/m³, which is 1.2250 at the sea.
    constexpr std::array<std::array<double, 2>, 6> kPublished{{{1.0, 1.1117},
                                                               {5.0, 0.73643},
                                                               {10.0, 0.41351},
                                                               {20.0, 0.088910},
                                                               {30.0, 0.018410},
                                                               {50.0, 0.0010269}}};
    for (const auto& row : kPublished) {
        CAPTURE(row[0]);
        CHECK(airDensity(1e3 * row[0]).x == doctest::Approx(row[1] / 1.2250).epsilon(1e-3));
    }
}

TEST_CASE("Relative optical air mass is that of the published table") {
    // F. Kasten, A. T. Young, Applied Optics 28, 4735 (1989): apparent elevation, relative mass.
    constexpr std::array<std::array<double, 2>, 5> kPublished{
        {{90.0, 1.0}, {60.0, 1.1540}, {20.0, 2.9032}, {5.0, 10.306}, {1.0, 26.31}}};
    const double vertical = bentRay(0.0, 1.0).columnsM.x;
    for (const auto& row : kPublished) {
        const double elevation = row[0], mass = row[1];
        CAPTURE(elevation);
        CHECK(bentRay(0.0, sine(elevation)).columnsM.x / vertical ==
              doctest::Approx(mass).epsilon(0.01));
        // As sunlight is looked up.
        CHECK(sunAir(0.0, trueSunUp(sine(elevation))).columnsM.x / vertical ==
              doctest::Approx(mass).epsilon(0.01));
    }
}

TEST_CASE("Vertical columns are the integrals of the profiles") {
    const glm::dvec3 columns = bentRay(0.0, 1.0).columnsM;
    CHECK(columns.x == doctest::Approx(kMoleculesHeightM).epsilon(1e-3));
    CHECK(columns.y == doctest::Approx(1200.0).epsilon(4e-3));
    CHECK(columns.z == doctest::Approx(15e3).epsilon(4e-3));
}

TEST_CASE("Refraction at sea level is that of the almanac") {
    // G. G. Bennett, J. Navigation 35, 255 (1982): within 0.07' of the almanac's tables, for
    // 1010 hPa and 10 degrees Celsius; ours is 1013.25 hPa and 15. Near the horizon it matters how
    // fast air cools with height, which the tables have otherwise: 33.0' for 34.0'.
    const double denser = 1013.25 / 1010.0 * 283.15 / 288.15;
    for (const double elevation : {0.0, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 45.0}) {
        CAPTURE(elevation);
        const double minutes = denser / std::tan((elevation + 7.31 / (elevation + 4.4)) * kRad);
        const double ours = 60.0 * bentRay(0.0, sine(elevation)).bending / kRad;
        CHECK(std::abs(ours - minutes) < (elevation < 1.0 ? 0.03 : 0.02) * minutes + 0.07);
    }
}

TEST_CASE("Bent rays are those that follow from the gradient of the refractive index") {
    constexpr std::array<std::array<double, 2>, 6> kRays{
        {{0.0, 30.0}, {0.0, 1.0}, {0.0, 0.0}, {3e3, 0.5}, {12e3, -1.5}, {12e3, -3.2}}};
    for (const auto& each : kRays) {
        const double altitudeM = each[0], elevation = each[1];
        CAPTURE(altitudeM);
        CAPTURE(elevation);
        const BentRay expected = followed(altitudeM, elevation);
        const BentRay ray = bentRay(altitudeM, sine(elevation));
        CHECK(ray.bending == doctest::Approx(expected.bending).epsilon(0.01));
        for (int k = 0; k < 3; ++k) {
            CHECK(ray.columnsM[k] ==
                  doctest::Approx(expected.columnsM[k]).epsilon(0.005).scale(100.0));
        }
    }
}

TEST_CASE("The table agrees with the integral, down to the horizon") {
    for (const double altitudeM : {0.0, 300.0, 1500.0, 7000.0, 20e3}) {
        const double lowest = apparentHorizonUp(altitudeM);
        for (double up = lowest + 1e-4; up < 1.0; up += up < lowest + 0.05 ? 0.0013 : 0.021) {
            CAPTURE(altitudeM);
            CAPTURE(up);
            const BentRay exact = bentRay(altitudeM, up);
            const SunAir looked = sunAir(altitudeM, std::sin(std::asin(up) - exact.bending));
            // Of a column that stops light at all: a hundred metres of either.
            for (int k = 0; k < 3; ++k) {
                CHECK(looked.columnsM[k] ==
                      doctest::Approx(exact.columnsM[k]).epsilon(0.01).scale(100.0));
            }
        }
    }
}

TEST_CASE("The sun at sea level is where its date puts it, with and without air") {
    // What follows from a date is apparent, by the almanac's refraction, which is 1' more at the
    // horizon.
    for (const double truly : {-12.0, -5.0, -2.0, -0.7, 0.0, 3.0, 40.0}) {
        CAPTURE(truly);
        const double apparent = truly + refractionDeg(truly);
        CHECK(std::abs(degrees(trueSunUp(sine(apparent))) - truly) < 0.03);
    }
    CHECK(degrees(trueSunUp(0.0)) == doctest::Approx(-34.0 / 60.0).epsilon(0.03));
}

TEST_CASE("An anvil sees the sun that has set for the ground") {
    // Air above 12 km bends light less than all of it, and bends it twice on its way past the
    // Earth.
    const double trulyDeg = degrees(trueSunUp(sine(-2.0)));
    for (const double altitudeM : {0.0, 4e3, 12e3, 40e3}) {
        CAPTURE(altitudeM);
        const double seen = apparentSunUp(altitudeM, sine(trulyDeg));
        const bool hidden = seen < apparentHorizonUp(altitudeM);
        CHECK(hidden == (altitudeM == 0.0));
        CHECK(hidden == (sine(trulyDeg) < sunAir(altitudeM, sine(trulyDeg)).lowestUp));
        if (hidden) continue;
        const BentRay ray = followed(altitudeM, degrees(seen));
        CHECK(std::abs(degrees(seen) - ray.bending / kRad - trulyDeg) < 0.005);
    }
}

TEST_CASE("The horizon dips by what a sphere has, and by less through air") {
    CHECK(horizonUp(0.0) == 0.0);
    // acos(R / (R + h)): 3.21 degrees from 10 km, 19.8 from 400 km.
    CHECK(horizonUp(10e3) == doctest::Approx(-sine(3.2086)).epsilon(1e-3));
    CHECK(horizonUp(400e3) == doctest::Approx(-sine(19.785)).epsilon(1e-3));
    // The Nautical Almanac has 1.76' sqrt(h / m).
    for (const double heightM : {10.0, 40.0}) {
        CHECK(apparentHorizonUp(heightM) ==
              doctest::Approx(-sine(1.76 / 60.0 * std::sqrt(heightM))).epsilon(0.01));
    }
}
