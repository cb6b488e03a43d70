// parcel_test.cpp: parcels lifted through soundings whose energy is known.
#include "core/air/parcel.h"

#include <doctest/doctest.h>

#include <cmath>

#include "core/air/thermodynamics.h"

using namespace neph;

namespace {

/// The analytic sounding of [Weisman82]: potential temperature and relative humidity by height,
/// vapour of at most `mostRatio` near the ground; hydrostatic from 1000 hPa.
Sounding weismanKlemp(double mostRatio) {
    constexpr double kTropopauseM = 12000.0, kThetaTropopause = 343.0, kTropopauseK = 213.0;
    constexpr double kGround = 300.0, kHeat = 1004.0, kStepM = 50.0;
    const auto theta = [&](double z) {
        return z <= kTropopauseM
                   ? kGround + (kThetaTropopause - kGround) * std::pow(z / kTropopauseM, 1.25)
                   : kThetaTropopause *
                         std::exp(kGravityMPerS2 * (z - kTropopauseM) / (kHeat * kTropopauseK));
    };
    const auto humidity = [&](double z) {
        return z <= kTropopauseM ? 1.0 - 0.75 * std::pow(z / kTropopauseM, 1.25) : 0.25;
    };
    Sounding sounding;
    double exner = 1.0, ratio = mostRatio;
    for (double z = 0.0; z <= 18000.0; z += kStepM) {
        if (z > 0.0) {
            const double moist = theta(z - kStepM / 2) * (1.0 + 0.61 * ratio);
            exner -= kGravityMPerS2 * kStepM / (kHeat * moist);
        }
        const double pressure = 1e5 * std::pow(exner, 1.0 / kPoissonDry);
        const double temperature = theta(z) * exner;
        ratio = std::min(mostRatio, humidity(z) * saturationRatio(pressure, temperature));
        sounding.levels.push_back({pressure, z, temperature, ratio});
    }
    return sounding;
}

}  // namespace

TEST_CASE("The sounding of Weisman and Klemp has the energy that CM1 finds in it") {
    // With 14 g/kg, CM1 r21.1 has 1872 and 1906 J/kg in two corners of a domain that began with it.
    const Sounding sounding = weismanKlemp(0.014);
    const Ascent ascent = ascentOf(sounding, parcelOf(sounding, ParcelSource::surface));
    CHECK(ascent.capeJPerKg == doctest::Approx(1889.0).epsilon(0.03));
    REQUIRE(ascent.freeConvection);
    REQUIRE(ascent.equilibrium);
    CHECK(ascent.freeConvection->heightM > ascent.condensation->heightM);
    CHECK(ascent.equilibrium->heightM > 9000.0);
    CHECK(ascent.equilibrium->heightM < 13000.0);
    CHECK(ascent.cinJPerKg < 0.0);
    CHECK(ascent.cinJPerKg > -100.0);
}

TEST_CASE("Energy is the integral of buoyancy where the parcel is warmer by a known amount") {
    // Surroundings at the parcel's own virtual temperature less 1 % from 800 to 400 hPa, and 1 %
    // more elsewhere: CAPE is 0.01/0.99 R T ln(800/400), by the hypsometric equation.
    Sounding sounding;
    const double startK = 295.0, ratio = 0.010;
    const double condensation = condensationPressurePa(1e5, startK, ratio);
    double height = 0.0, temperature = startK, last = 1e5, lastAround = 0.0, expected = 0.0;
    for (double pressure = 1e5; pressure >= 2e4; pressure -= 200.0) {
        const bool dry = pressure >= condensation;
        const double from = last >= condensation ? condensation : last;
        temperature = dry ? startK * std::pow(pressure / 1e5, kPoissonDry)
                          : pseudoadiabatK(from,
                                           last >= condensation
                                               ? startK * std::pow(condensation / 1e5, kPoissonDry)
                                               : temperature,
                                           pressure);
        const double vapour = dry ? ratio : saturationRatio(pressure, temperature);
        const bool buoyant = pressure < 8e4 && pressure > 4e4;
        const double around = virtualTemperatureK(temperature, vapour) * (buoyant ? 0.99 : 1.01);
        if (lastAround > 0.0) {
            const double step =
                287.04 / kGravityMPerS2 * 0.5 * (around + lastAround) * std::log(last / pressure);
            height += step;
            if (buoyant) expected += kGravityMPerS2 * step * (1.0 / 0.99 - 1.0);
        }
        sounding.levels.push_back({pressure, height, around, 0.0});
        last = pressure;
        lastAround = around;
    }
    const Ascent ascent = ascentOf(sounding, {1e5, startK, ratio});
    CHECK(ascent.capeJPerKg == doctest::Approx(expected).epsilon(0.02));
    REQUIRE(ascent.freeConvection);
    CHECK(ascent.freeConvection->pressurePa == doctest::Approx(8e4).epsilon(0.01));
    REQUIRE(ascent.equilibrium);
    CHECK(ascent.equilibrium->pressurePa == doctest::Approx(4e4).epsilon(0.01));
}

TEST_CASE("Stable air has neither energy nor inhibition") {
    Sounding sounding;
    for (int i = 0; i < 40; ++i) {
        sounding.levels.push_back({1e5 * std::exp(-i / 20.0), 400.0 * i, 290.0, 0.001});
    }
    const Ascent ascent = ascentOf(sounding, parcelOf(sounding, ParcelSource::surface));
    CHECK(ascent.capeJPerKg == 0.0);
    CHECK(ascent.cinJPerKg == 0.0);
    CHECK_FALSE(ascent.freeConvection);
    CHECK_FALSE(ascent.equilibrium);
}

TEST_CASE("The most unstable parcel is lifted from where it is") {
    Sounding sounding = weismanKlemp(0.014);
    sounding.levels[20].vapourRatio = 0.0155;  // 1 km above the ground
    const Parcel parcel = parcelOf(sounding, ParcelSource::mostUnstable);
    CHECK(parcel.pressurePa == sounding.levels[20].pressurePa);
    const Ascent ascent = ascentOf(sounding, parcel);
    CHECK(ascent.way.front().pressurePa == parcel.pressurePa);
    CHECK(ascent.capeJPerKg >
          ascentOf(sounding, parcelOf(sounding, ParcelSource::surface)).capeJPerKg);
}

TEST_CASE("Air without vapour does not condense below the top") {
    Sounding sounding = weismanKlemp(0.014);
    for (SoundingLevel& level : sounding.levels) level.vapourRatio = 0.0;
    const Ascent ascent = ascentOf(sounding, parcelOf(sounding, ParcelSource::surface));
    CHECK_FALSE(ascent.condensation);
    CHECK_FALSE(ascent.freeConvection);
    CHECK(ascent.capeJPerKg == 0.0);
}
