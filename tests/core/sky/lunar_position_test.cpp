// lunar_position_test.cpp: against the worked examples of [Meeus98] and against eclipses.
#include "core/sky/lunar_position.h"

#include <doctest/doctest.h>

#include <cmath>

#include "core/sky/solar_position.h"

using namespace neph;

TEST_CASE("The moon stands where Meeus has it") {
    // Examples 47.a and 48.a: 12 April 1992, 0h dynamical time, which was 59 s ahead.
    const UtcTime time = *utcOfText("1992-04-11T23:59:01Z");
    const double rightAscensionDeg = 134.688470, declinationDeg = 13.768368;
    // Sidereal time at Greenwich at 0h UT of that day by ch. 12, less 59 s.
    const double days = -2820.5 - 59.0 / 86400.0;
    const double siderealDeg = std::fmod(280.46061837 + 360.98564736629 * days, 360.0);
    const LunarPosition overhead =
        lunarPosition(time, declinationDeg, rightAscensionDeg - siderealDeg);
    CHECK(overhead.apparentElevationDeg > 89.9);
    CHECK(overhead.distanceKm == doctest::Approx(368409.7).epsilon(3e-4));
    CHECK(overhead.phaseDeg == doctest::Approx(69.0756).epsilon(0.002));
}

TEST_CASE("The moon is before the sun in a solar eclipse, and opposite in a lunar one") {
    // 8 April 2024, 18:17:16 UT, greatest eclipse at 25.3 N 104.1 W; NASA catalogue of eclipses.
    const UtcTime solar = *utcOfText("2024-04-08T18:17:16Z");
    const LunarPosition moon = lunarPosition(solar, 25.3, -104.1);
    const SolarPosition sun = solarPosition(solar, 25.3, -104.1);
    CHECK(moon.apparentElevationDeg == doctest::Approx(sun.apparentElevationDeg).epsilon(0.002));
    CHECK(std::abs(moon.azimuthDeg - sun.azimuthDeg) < 0.3);
    CHECK(moon.phaseDeg > 179.0);
    // 14 March 2025, 06:58:47 UT.
    CHECK(lunarPosition(*utcOfText("2025-03-14T06:58:47Z"), 0.0, -100.0).phaseDeg < 0.6);
}

TEST_CASE("A waxing moon is lit from the side of the evening's sun") {
    // First quarter of 15 May 2024, 11:48 UT; in the evening over Oklahoma it stands in the
    // southwest, and the sun has set to its right.
    const LunarPosition moon = lunarPosition(*utcOfText("2024-05-16T02:00:00Z"), 35.0, -97.5);
    CHECK(moon.azimuthDeg > 180.0);
    CHECK(moon.apparentElevationDeg > 40.0);
    CHECK(moon.limbDeg > 45.0);
    CHECK(moon.limbDeg < 135.0);
    CHECK(moon.phaseDeg == doctest::Approx(84.0).epsilon(0.06));
}

TEST_CASE("A full moon is 400 000 times fainter than the sun, half of it far more") {
    CHECK(1.0 / moonShare(0.0) == doctest::Approx(4.0e5).epsilon(0.02));
    CHECK(moonShare(0.0) / moonShare(90.0) == doctest::Approx(11.0).epsilon(0.1));
}
