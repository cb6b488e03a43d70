// radius_scheme_test.cpp: sizes by scheme against the values of docs/physics.md §7, which were
// worked out apart from this code.
#include "core/volume/radius_scheme.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace neph;
using doctest::Approx;

namespace {

constexpr auto kGeometric = RadiationOptics::geometric;
constexpr auto kRrtmg = RadiationOptics::wrfRrtmg;
constexpr double kZeroC = 273.15;

/// 1 g/m³.
CellState gram(double temperatureK = kZeroC, double numberPerM3 = 0.0) {
    return {1e-3, numberPerM3, temperatureK};
}

double radiusUm(Microphysics scheme, Species s, RadiationOptics optics, const CellState& cell) {
    return 1e6 * sizeFromScheme(scheme, s, optics, cell).radiusM;
}

/// Mass extinction by the scheme's own distribution, m²/kg.
double massExtinction(Microphysics scheme, Species s, const CellState& cell) {
    const ParticleSize size = sizeFromScheme(scheme, s, kGeometric, cell);
    return extinctionPerM(kGeometric, s, cell.contentKgPerM3, size) / cell.contentKgPerM3;
}

}  // namespace

TEST_CASE("WSM6 droplets of 1 g per m3: 27.8 um as coded, 9.3 um as they are") {
    CHECK(radiusUm(Microphysics::wsm6, Species::cloud, kRrtmg, gram()) ==
          Approx(27.8).epsilon(2e-3));
    CHECK(radiusUm(Microphysics::wsm6, Species::cloud, kGeometric, gram()) ==
          Approx(9.3).epsilon(5e-3));
}

TEST_CASE("WSM6 ice of 1 g per m3 has an effective radius of 84 um") {
    CHECK(radiusUm(Microphysics::wsm6, Species::ice, kGeometric, gram()) ==
          Approx(84.0).epsilon(6e-3));
    CHECK(radiusUm(Microphysics::wsm6, Species::ice, kGeometric, {1e-12, 0.0, kZeroC}) ==
          Approx(10.01));
}

TEST_CASE("Scheme-consistent mass extinction at 1 g per m3") {
    CHECK(massExtinction(Microphysics::wsm6, Species::rain, gram()) == Approx(2.24).epsilon(2e-3));
    CHECK(massExtinction(Microphysics::wsm6, Species::snow, gram()) == Approx(8.9).epsilon(2e-3));
    CHECK(massExtinction(Microphysics::wsm6, Species::snow, gram(kZeroC - 20.0)) ==
          Approx(16.2).epsilon(2e-3));
    CHECK(massExtinction(Microphysics::wsm6, Species::graupel, gram()) ==
          Approx(3.17).epsilon(2e-3));
    CHECK(massExtinction(Microphysics::lin, Species::graupel, gram()) ==
          Approx(3.74).epsilon(2e-3));
}

TEST_CASE("WSM6 hands radiation a third of the radius that its snow has, within WRF's bounds") {
    const CellState cold = gram(kZeroC - 40.0);
    CHECK(radiusUm(Microphysics::wsm6, Species::snow, kRrtmg, cold) ==
          Approx(radiusUm(Microphysics::wsm6, Species::snow, kGeometric, cold) / 3.0));
    CHECK(radiusUm(Microphysics::wsm6, Species::snow, kRrtmg, {0.05, 0.0, kZeroC}) ==
          Approx(999.0));
}

TEST_CASE("The intercept of WSM6 snow stops growing at 1e11") {
    const double coldest = kZeroC - std::log(1e11 / 2e6) / 0.12;
    const auto at = [](double kelvin) {
        return radiusUm(Microphysics::wsm6, Species::snow, kGeometric, gram(kelvin));
    };
    CHECK(at(coldest - 20.0) == Approx(at(coldest)));
    CHECK(at(coldest + 5.0) > 1.01 * at(coldest));
}

TEST_CASE("Thompson droplets of 1 g per m3 have an effective radius of 14.3 um") {
    CHECK(radiusUm(Microphysics::thompson, Species::cloud, kGeometric, gram()) ==
          Approx(14.3).epsilon(4e-3));
}

TEST_CASE("Thompson snow: 480 um at -20 degrees, and 22.8 m2 per kg for any content") {
    CHECK(radiusUm(Microphysics::thompson, Species::snow, kGeometric, gram(kZeroC - 20.0)) ==
          Approx(480.0).epsilon(2e-3));
    for (const double content : {1e-5, 1e-3, 5e-3}) {
        for (const double kelvin : {230.0, 253.15, 270.0}) {
            CHECK(massExtinction(Microphysics::thompson, Species::snow, {content, 0.0, kelvin}) ==
                  Approx(22.8).epsilon(2e-3));
        }
    }
}

TEST_CASE("Thompson ice follows its number and stays within 5 and 125 um") {
    // 1e5 crystals in 0.1 g/m³ weigh 1 ng each: mean mass πρ/λ³, λ = (π 890 / 1e-9)^(1/3).
    const double expectedUm = 1.5e6 / std::cbrt(3.14159265 * 890.0 / 1e-9);
    CHECK(expectedUm > 10.0);
    CHECK(radiusUm(Microphysics::thompson, Species::ice, kGeometric, {1e-4, 1e5, kZeroC}) ==
          Approx(expectedUm));
    CHECK(radiusUm(Microphysics::thompson, Species::ice, kGeometric, {1e-3, 1.0, kZeroC}) == 125.0);
    CHECK(radiusUm(Microphysics::thompson, Species::ice, kGeometric, {1e-9, 1e7, kZeroC}) ==
          Approx(5.01));
}

TEST_CASE("Thompson graupel has an intercept that grows with its content") {
    // 1 g/m³: N0 = 10^(3.5 + 8/7) = 4.39e4 /m⁴, λ = (π 500 N0 / 1e-3)^(1/4) = 512.5 /m.
    CHECK(radiusUm(Microphysics::thompson, Species::graupel, kGeometric, gram()) ==
          Approx(1.5e6 / 512.5).epsilon(2e-3));
}

TEST_CASE("Morrison droplets of 1 g per m3 have an effective radius of 11.4 um") {
    CHECK(radiusUm(Microphysics::morrison, Species::cloud, kGeometric, gram()) ==
          Approx(11.4).epsilon(4e-3));
}

TEST_CASE("Morrison sizes all that freezes or falls by number, with its own densities") {
    const auto expectedUm = [](double density) {
        return 1.5e6 / std::cbrt(3.14159265 * density * 1e4 / 1e-3);
    };
    const CellState cell = gram(kZeroC, 1e4);
    const auto radius = [&](Species s) {
        return radiusUm(Microphysics::morrison, s, kGeometric, cell);
    };
    CHECK(radius(Species::rain) == Approx(expectedUm(997.0)));
    CHECK(radius(Species::snow) == Approx(expectedUm(100.0)));
    CHECK(radius(Species::graupel) == Approx(expectedUm(400.0)));
    CHECK(sizeFromScheme(Microphysics::morrison, Species::ice, kGeometric, gram(kZeroC, 1e6))
              .densityKgPerM3 == 500.0);
}

TEST_CASE("More droplets make smaller ones: the extinction of Twomey") {
    double before = 1.0;
    for (const double perCm3 : {50.0, 100.0, 300.0, 1000.0}) {
        const ParticleSize size =
            sizeFromNumber(Microphysics::unknown, Species::cloud, gram(kZeroC, perCm3 * 1e6));
        CHECK(size.radiusM < before);
        before = size.radiusM;
    }
}

TEST_CASE("What no scheme sizes: 30 um ice of solid density and droplets at 100 per cm3") {
    for (const Microphysics scheme : {Microphysics::unknown, Microphysics::lin}) {
        const ParticleSize ice = sizeFromScheme(scheme, Species::ice, kGeometric, gram());
        CHECK(ice.radiusM == 30e-6);
        CHECK(ice.densityKgPerM3 == 917.0);
        CHECK(sizeFromScheme(scheme, Species::cloud, kGeometric, gram()).radiusM ==
              sizeFromNumber(scheme, Species::cloud, gram(kZeroC, 1e8)).radiusM);
    }
}

TEST_CASE("As WRF RRTMG, ice has 2513 m2 per kg over its radius in um, 1.54 times the geometric") {
    const ParticleSize ice{30e-6, 917.0};
    const double rrtmg = extinctionPerM(kRrtmg, Species::ice, 1e-3, ice);
    CHECK(rrtmg / 1e-3 == Approx(2513.0 / 30.0));
    CHECK(rrtmg / extinctionPerM(kGeometric, Species::ice, 1e-3, ice) ==
          Approx(1.54).epsilon(3e-3));
}

TEST_CASE("As WRF RRTMG, snow above 130 um counts as 130 um with less mass") {
    const auto k = [](double um) {
        return extinctionPerM(kRrtmg, Species::snow, 1.0, {um * 1e-6, 100.0});
    };
    CHECK(k(100.0) == Approx(25.13));
    CHECK(k(130.0) == Approx(2513.0 / 130.0));
    CHECK(k(260.0) == Approx(2513.0 / 130.0 / 4.0));
}

TEST_CASE("As WRF RRTMG, water is geometric") {
    const ParticleSize drop{14e-6, 1000.0};
    CHECK(extinctionPerM(kRrtmg, Species::cloud, 1e-3, drop) ==
          extinctionPerM(kGeometric, Species::cloud, 1e-3, drop));
}

TEST_CASE("A radius that stands for absence is told from one that is a size") {
    CHECK(isBackgroundRadius(Species::cloud, 2.49e-6));
    CHECK(isBackgroundRadius(Species::ice, 4.99e-6));
    CHECK(isBackgroundRadius(Species::snow, 9.99e-6));
    CHECK(isBackgroundRadius(Species::ice, 0.0));
    CHECK(isBackgroundRadius(Species::ice, std::nan("")));
    CHECK_FALSE(isBackgroundRadius(Species::cloud, 2.51e-6));
    CHECK_FALSE(isBackgroundRadius(Species::ice, 5.01e-6));
    CHECK_FALSE(isBackgroundRadius(Species::snow, 10.01e-6));
    CHECK_FALSE(isBackgroundRadius(Species::cloud, 4.99e-6));
    CHECK_FALSE(isBackgroundRadius(Species::rain, 9.99e-6));
}
