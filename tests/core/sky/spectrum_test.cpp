// spectrum_test.cpp: sunlight as colour.
#include "core/sky/spectrum.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace neph;

TEST_CASE("The sun outside the atmosphere gives 133 kilolux") {
    // Solar illuminance constant, 133.1 klx: Darula, Kittler, Gueymard, Solar Energy 79, 559
    // (2005).
    CHECK(683.0 * solarIrradianceWPerM2() == doctest::Approx(133.1e3).epsilon(0.01));
}

TEST_CASE("The sun outside the atmosphere has a luminance of 1 and its known colour") {
    const glm::dvec3 rgb = rgbOfSunlight(Spectrum(1.0f));
    CHECK(glm::dot(rgb, glm::dvec3(0.2126, 0.7152, 0.0722)) == doctest::Approx(1.0).epsilon(1e-4));
    // CIE x, y of the E-490 extraterrestrial spectrum: 0.322, 0.332.
    const glm::dmat3 columns{
        {0.4124, 0.2126, 0.0193}, {0.3576, 0.7152, 0.1192}, {0.1805, 0.0722, 0.9505}};
    const glm::dvec3 xyz = columns * rgb;
    CHECK(xyz.x / (xyz.x + xyz.y + xyz.z) == doctest::Approx(0.322).epsilon(0.01));
    CHECK(xyz.y / (xyz.x + xyz.y + xyz.z) == doctest::Approx(0.332).epsilon(0.01));
}

TEST_CASE("Exponentials of a spectrum are those of the library") {
    for (float x = 0.0f; x < 80.0f; x = 1.01f * x + 0.003f) {
        CAPTURE(x);
        const float expected = std::exp(-x);
        CHECK(std::abs(expMinus(Spectrum(x)).at[3] - expected) <= 4e-6f * expected + 1e-36f);
    }
}

TEST_CASE("No colour has a negative channel, and its luminance stays") {
    Spectrum red;
    red.at.back() = 1.0f;
    const glm::dvec3 rgb = rgbOfSunlight(red);
    CHECK(std::min({rgb.r, rgb.g, rgb.b}) >= 0.0);
    CHECK(rgb.r > 0.0);
    CHECK(rgb.g < 0.1 * rgb.r);
}
