// hodograph_test.cpp: shear, helicity and motion of storms of winds with known answers.
#include "core/air/hodograph.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <numbers>

using namespace neph;

namespace {

constexpr double kGroundM = 500.0;

Sounding windSounding(const std::function<glm::dvec2(double)>& wind) {
    Sounding sounding;
    sounding.groundM = kGroundM;
    for (double z = 0.0; z <= 12000.0; z += 100.0) {
        sounding.levels.push_back({1e5 * std::exp(-z / 8000.0), kGroundM + z, 280.0, 0.0, wind(z)});
    }
    return sounding;
}

}  // namespace

TEST_CASE("Helicity of a half circle is twice the area of its circle's half") {
    constexpr double kRadius = 10.0, kTopM = 3000.0;
    const Sounding sounding = windSounding([](double z) {
        const double angle = std::numbers::pi * (1.0 - std::min(z / kTopM, 1.0));
        return kRadius * glm::dvec2(std::cos(angle), std::sin(angle));
    });
    // Clockwise around a storm that stands still: positive.
    CHECK(stormRelativeHelicity(sounding, kTopM, {0.0, 0.0}) ==
          doctest::Approx(std::numbers::pi * kRadius * kRadius).epsilon(2e-3));
    CHECK(stormRelativeHelicity(sounding, kTopM, {0.0, kRadius}) <
          stormRelativeHelicity(sounding, kTopM, {0.0, 0.0}));
}

TEST_CASE("Bulk shear is the difference of winds above the ground") {
    const Sounding sounding = windSounding([](double z) { return glm::dvec2(z / 200.0, 5.0); });
    const glm::dvec2 shear = bulkShearMPerS(sounding, 6000.0);
    CHECK(shear.x == doctest::Approx(30.0));
    CHECK(shear.y == doctest::Approx(0.0));
}

TEST_CASE("Storms move 7.5 m/s right and left of the mean wind") {
    const Sounding sounding = windSounding([](double z) { return glm::dvec2(z / 200.0, 0.0); });
    const StormMotion motion = stormMotionOf(sounding);
    CHECK(motion.rightMPerS.y == doctest::Approx(-7.5));
    CHECK(motion.leftMPerS.y == doctest::Approx(7.5));
    CHECK(motion.rightMPerS.x == doctest::Approx(motion.meanMPerS.x));
    // More air lies below 3 km than above.
    CHECK(motion.meanMPerS.x < 15.0);
    CHECK(motion.meanMPerS.x > 10.0);
}

TEST_CASE("Levels without wind are passed over, and wind ends half a layer above the highest") {
    Sounding sounding;
    sounding.groundM = kGroundM;
    sounding.levels = {{1e5, 600.0, 300.0, 0.0, glm::dvec2(1.0, 0.0)},
                       {9e4, 800.0, 300.0, 0.0},
                       {8e4, 1000.0, 300.0, 0.0, glm::dvec2(3.0, 0.0)},
                       {7e4, 1200.0, 300.0, 0.0}};
    CHECK(sounding.hasWind());
    CHECK(windAt(sounding, 0.0).x == doctest::Approx(1.0));
    CHECK(windAt(sounding, 400.0).x == doctest::Approx(2.5));
    CHECK(windAt(sounding, 900.0).x == doctest::Approx(3.0));
    CHECK(windTopM(sounding) == doctest::Approx(600.0));
}

TEST_CASE("Air between levels is linear in the logarithm of pressure") {
    Sounding sounding;
    sounding.levels = {{1e5, 0.0, 300.0, 0.01}, {5e4, 5000.0, 260.0, 0.0}};
    const SoundingLevel middle = levelAt(sounding, std::sqrt(1e5 * 5e4));
    CHECK(middle.temperatureK == doctest::Approx(280.0));
    CHECK(middle.heightM == doctest::Approx(2500.0));
    CHECK(levelAt(sounding, 2e5).pressurePa == 1e5);
    CHECK(levelAt(sounding, 1e4).pressurePa == 5e4);
}
