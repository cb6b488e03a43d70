// air_bands_test.cpp: three bands against eight wavelengths.
#include "core/sky/air_bands.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace neph;

TEST_CASE("Bands have the colour of sunlight through so much air of one kind") {
    const Atmosphere air({});
    const AirBands bands = airBandsOf(air);
    const glm::dvec3 white = rgbOfSunlight(Spectrum(1.0f));
    for (const float columnM : {1e3f, 10e3f, 40e3f}) {
        const glm::dvec3 molecules = rgbOfSunlight(expMinus(columnM * air.moleculesPerM())) / white;
        const glm::dvec3 haze = rgbOfSunlight(expMinus(columnM * air.hazePerM())) / white;
        for (int c = 0; c < 3; ++c) {
            const double m = static_cast<double>(columnM);
            CHECK(std::exp(-bands.moleculesPerM[c] * m) ==
                  doctest::Approx(molecules[c]).epsilon(0.01));
            CHECK(std::exp(-bands.hazePerM[c] * m) == doctest::Approx(haze[c]).epsilon(0.01));
        }
    }
    // No haze beyond what molecules leave of sight.
    CHECK(airBandsOf(Atmosphere({.visibilityM = 1e6})).hazePerM == glm::dvec3(0.0));
}
