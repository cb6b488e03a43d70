// atmosphere_test.cpp: the light of clear air.
#include "core/sky/atmosphere.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <span>

using namespace neph;

namespace {

constexpr double kHalfTurn = std::numbers::pi;

double upOf(double deg) {
    return std::sin(deg * kHalfTurn / 180.0);
}

/// Of pure air: no haze, no ozone, black ground.
Atmosphere pureAir() {
    return Atmosphere({.visibilityM = 1e9, .ozoneDobson = 0.0, .groundAlbedo = 0.0});
}

/// Irradiance of the sky on level ground, per that of the sun.
double skyIrradiance(const Atmosphere& air, double sunUp) {
    constexpr int kUps = 24, kAzimuths = 24;
    double sum = 0.0;
    for (int i = 0; i < kUps; ++i) {
        for (int j = 0; j < kAzimuths; ++j) {
            const double up = std::sqrt((i + 0.5) / kUps);
            const double azimuth = kHalfTurn * (j + 0.5) / kAzimuths;
            sum += static_cast<double>(air.along({0.0, up, azimuth, sunUp}).radiance.at[4]);
        }
    }
    return kHalfTurn * sum / (kUps * kAzimuths);
}

}  // namespace

TEST_CASE("Pure air has the optical depth of the measured Rayleigh atmosphere") {
    // A. Bucholtz, Applied Optics 34, 2765 (1995), at sea level: 0.3641 at 400 nm, 0.0981 at 550
    // nm, which is 0.0912 at 560 nm by the law of the fourth power.
    const Spectrum clear = pureAir().transmittance(0.0, 1.0);
    CHECK(-std::log(clear.at[0]) == doctest::Approx(0.3641).epsilon(0.02));
    CHECK(-std::log(clear.at[4]) == doctest::Approx(0.0912).epsilon(0.02));
}

TEST_CASE("A visibility is the distance at which 2 percent of the contrast is left") {
    const Atmosphere air({.visibilityM = 20e3, .ozoneDobson = 0.0});
    const AirLight level = [&] {
        AirLight light;
        const std::array<double, 1> distanceM{20e3};
        // Level, and straight for so short a way that the air does not thin.
        air.along({0.0, 1e-6, 0.0, 0.5}, distanceM, std::span(&light, 1));
        return light;
    }();
    const double at550 = std::lerp(std::log(level.clear.at[3]), std::log(level.clear.at[4]), 0.75);
    CHECK(at550 == doctest::Approx(std::log(0.02)).epsilon(0.03));
}

TEST_CASE("Light scattered once in thin air is what the formula of a slab has") {
    // At 680 nm pure air is thin: downward radiance of a slab, docs/physics.md, with the sun in the
    // zenith and the eye at 60 degrees from it: P E (mu0 / (mu0 - mu)) (e^-tau/mu0 - e^-tau/mu).
    const Atmosphere air = pureAir();
    const double tau = -std::log(static_cast<double>(air.transmittance(0.0, 1.0).at[7]));
    const double mu = upOf(30.0);
    const double phase = 3.0 / (16.0 * kHalfTurn) * (1.0 + mu * mu);
    const double once = phase / (1.0 - mu) * (std::exp(-tau) - std::exp(-tau / mu));
    const double all = static_cast<double>(air.along({0.0, mu, 0.0, 1.0}).radiance.at[7]);
    CHECK(all > once);
    CHECK(all == doctest::Approx(once).epsilon(0.08));  // the rest is scattered more often
}

TEST_CASE("Pure air sends half of what it scatters down") {
    // Molecules send as much forward as back, and air that is thin scatters little of it again:
    // mu0 (1 - e^-tau/mu0) / 2, to second order.
    const Atmosphere air = pureAir();
    const double mu0 = 0.8;
    const double tau = -std::log(static_cast<double>(air.transmittance(0.0, 1.0).at[4]));
    const double expected = 0.5 * mu0 * (1.0 - std::exp(-tau / mu0));
    CHECK(skyIrradiance(air, mu0) == doctest::Approx(expected).epsilon(0.05));
}

TEST_CASE("Haze scatters forwards without darkening what is behind it") {
    // Radiance at 560 nm over ground of albedo 0.2 at a visibility of 14 km, by adding-doubling.
    // As if all that haze scatters were lost to the beam it was 16 to 41 % darker.
    constexpr std::array<std::array<double, 4>, 4> kExact{{{10.0, 10.0, 45.0, 0.0504},
                                                           {10.0, 25.0, 45.0, 0.0353},
                                                           {20.0, 10.0, 45.0, 0.0950},
                                                           {40.0, 10.0, 0.0, 0.2326}}};
    const Atmosphere air({.visibilityM = 14e3, .groundAlbedo = 0.2});
    for (const auto& each : kExact) {
        const double sun = each[0], elevation = each[1], azimuth = each[2], radiance = each[3];
        CAPTURE(sun);
        CAPTURE(elevation);
        const SkyRay ray{0.0, upOf(elevation), azimuth * kHalfTurn / 180.0, upOf(sun)};
        CHECK(air.along(ray).radiance.at[4] == doctest::Approx(radiance).epsilon(0.15));
    }
}

TEST_CASE("The horizon hides the sun by and by") {
    const Atmosphere air({});
    const auto light = [&](double elevation) { return air.sunlight(0.0, upOf(elevation)).at[7]; };
    CHECK(light(0.3) > light(0.0));
    CHECK(light(0.0) > 0.0f);
    CHECK(light(-0.2) > 0.0f);
    CHECK(light(-0.3) == 0.0f);
    // From 12 km the horizon is 3.3 degrees lower, and light from there is bent by a degree.
    CHECK(air.sunlight(12e3, upOf(-4.3)).at[7] > 0.0f);
    CHECK(air.sunlight(12e3, upOf(-4.6)).at[7] == 0.0f);
}

TEST_CASE("The sky is blue overhead, red towards a setting sun, and dark at night") {
    const Atmosphere air({});
    const Spectrum zenith = air.along({0.0, 1.0, 0.0, upOf(40.0)}).radiance;
    CHECK(zenith.at[1] > 2.0f * zenith.at[7]);
    const Spectrum sunset = air.along({0.0, upOf(2.0), 0.0, upOf(-1.0)}).radiance;
    CHECK(sunset.at[7] > 2.0f * sunset.at[1]);
    const Spectrum night = air.along({0.0, 1.0, 0.0, upOf(-30.0)}).radiance;
    CHECK(night.at[1] < 1e-6f * zenith.at[1]);
}

TEST_CASE("Air up to distances adds up to all the air") {
    const Atmosphere air({});
    const SkyRay ray{500.0, 0.02, 0.4, 0.3};
    const std::array<double, 3> distancesM{10e3, 100e3, 1e7};
    std::array<AirLight, 3> parts;
    air.along(ray, distancesM, parts);
    const AirLight all = air.along(ray);
    for (std::size_t i = 0; i < kSpectrumSize; ++i) {
        CHECK(parts[0].radiance.at[i] < parts[1].radiance.at[i]);
        CHECK(parts[1].radiance.at[i] < parts[2].radiance.at[i]);
        CHECK(parts[2].radiance.at[i] == doctest::Approx(all.radiance.at[i]).epsilon(0.02));
        CHECK(parts[2].clear.at[i] == doctest::Approx(all.clear.at[i]).epsilon(0.02));
    }
}

TEST_CASE("Air goes on beneath the ground up to the first distance there") {
    const Atmosphere air({});
    const SkyRay ray{1000.0, -0.5, 0.4, 0.3};
    // The Earth is nearly flat so near.
    const std::array<double, 4> distancesM{1000.0, 1999.0, 2500.0, 9000.0};
    std::array<AirLight, 4> parts;
    air.along(ray, distancesM, parts);
    const AirLight all = air.along(ray);
    for (std::size_t i = 0; i < kSpectrumSize; ++i) {
        CHECK(parts[1].clear.at[i] == doctest::Approx(all.clear.at[i]).epsilon(1e-3));
        const float perM = air.moleculesPerM().at[i] + air.hazePerM().at[i];
        const float below = std::log(parts[1].clear.at[i] / parts[2].clear.at[i]);
        CHECK(below == doctest::Approx(501.0f * perM).epsilon(0.02));
        CHECK(parts[2].radiance.at[i] > parts[1].radiance.at[i]);
        CHECK(parts[3].radiance.at[i] == parts[2].radiance.at[i]);
    }
}

TEST_CASE("From space the air begins far from the eye") {
    const Atmosphere air({});
    const std::array<double, 2> distancesM{250e3, 500e3};
    std::array<AirLight, 2> parts;
    air.along({400e3, -1.0, 0.0, 0.5}, distancesM, parts);
    CHECK(parts[0].radiance.at[1] == 0.0f);
    CHECK(parts[0].clear.at[1] == 1.0f);
    CHECK(parts[1].radiance.at[1] > 0.01f / 4.0f);
}
