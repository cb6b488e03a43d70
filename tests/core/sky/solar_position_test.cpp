// solar_position_test.cpp: against values of NREL's SPA and of [Meeus98].
#include "core/sky/solar_position.h"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/glm.hpp>

using namespace neph;

namespace {

constexpr double kToleranceDeg = 0.01;

UtcTime almanacTime(const char* text) {
    const auto time = utcOfText(text);
    REQUIRE(time);
    return *time;
}

/// Angle between two directions of equal elevation.
double azimuthErrorDeg(const SolarPosition& sun, double azimuthDeg) {
    return std::abs(std::remainder(sun.azimuthDeg - azimuthDeg, 360.0)) *
           std::cos(glm::radians(sun.elevationDeg));
}

/// Azimuth and zenith angle, refracted where the sun is up, at 1000 hPa and 10 degrees C.
struct Almanac {
    const char* utc;
    double latitudeDeg, longitudeDeg, azimuthDeg, zenithDeg;
};

// Computed by NREL with the reference implementation spa.c of [Reda04], as the tests of
// github.com/klausbrunner/solarpositioning have them (spa_reference_testdata.csv).
constexpr Almanac kSpa[]{
    // Auckland: the sun stands in the north, and midnight UTC is its noon.
    {"1910-03-15T00:30:00Z", -36.840556, 174.74, 0.188643, 34.269919},
    {"1910-06-15T21:30:00Z", -36.840556, 174.74, 40.884175, 72.370887},
    {"2010-12-15T00:30:00Z", -36.840556, 174.74, 346.427128, 13.924050},
    {"2010-12-15T18:30:00Z", -36.840556, 174.74, 107.175261, 73.622171},
    {"2010-06-15T12:30:00Z", -36.840556, 174.74, 171.709584, 166.352971},
    {"2110-09-15T03:30:00Z", -36.840556, 174.74, 300.643240, 60.117731},
    // Brasilia: nearly in the zenith, low, and below the horizon.
    {"1910-12-15T15:30:00Z", -15.793889, -47.882778, 215.571686, 9.279282},
    {"2010-03-15T09:30:00Z", -15.793889, -47.882778, 91.385435, 86.910752},
    {"2010-06-15T03:30:00Z", -15.793889, -47.882778, 28.847986, 171.371646},
    {"2110-03-15T18:30:00Z", -15.793889, -47.882778, 281.486659, 48.640588},
    // Longyearbyen: the midnight sun, sunrise, and the polar night.
    {"1910-06-15T00:30:00Z", 78.22, 15.65, 21.707496, 77.555496},
    {"1910-09-15T03:30:00Z", 78.22, 15.65, 69.006922, 90.197018},
    {"2010-03-15T06:30:00Z", 78.22, 15.65, 110.910237, 87.669511},
    {"2010-12-15T12:30:00Z", 78.22, 15.65, 202.847721, 102.475749},
    {"2110-06-15T21:30:00Z", 78.22, 15.65, 339.354569, 77.599071},
    // Singapore, on both sides of local midnight.
    {"1910-06-15T15:30:00Z", 1.283333, 103.833333, 318.303434, 146.303806},
    {"1910-06-15T18:30:00Z", 1.283333, 103.833333, 38.818998, 147.844548},
    {"2010-09-15T03:30:00Z", 1.283333, 103.833333, 85.023986, 22.558624},
    {"2110-12-15T09:30:00Z", 1.283333, 103.833333, 244.670246, 70.057726},
};

}  // namespace

TEST_CASE("The sun stands where NREL's SPA has it, in both hemispheres, by day and by night") {
    const ObserverAir air{.pressurePa = 1e5, .temperatureK = 283.15};
    for (const Almanac& row : kSpa) {
        CAPTURE(row.utc);
        const SolarPosition sun =
            solarPosition(almanacTime(row.utc), row.latitudeDeg, row.longitudeDeg, air);
        const bool down = row.zenithDeg > 90.9;  // SPA refracts nothing there
        const double elevationDeg = down ? sun.elevationDeg : sun.apparentElevationDeg;
        CHECK(std::abs(90.0 - row.zenithDeg - elevationDeg) < kToleranceDeg);
        CHECK(azimuthErrorDeg(sun, row.azimuthDeg) < kToleranceDeg);
    }
}

TEST_CASE("The example of the SPA report is met: topocentric, refracted and at its distance") {
    // [Reda04] table A5.1: 820 hPa, 11 degrees C; e0 and R by its equations.
    const SolarPosition sun =
        solarPosition(almanacTime("2003-10-17T19:30:30Z"), 39.742476, -105.1786,
                      {.pressurePa = 82000.0, .temperatureK = 284.15});
    CHECK(std::abs(sun.elevationDeg - 39.872046) < kToleranceDeg);
    CHECK(std::abs(90.0 - sun.apparentElevationDeg - 50.11162) < kToleranceDeg);
    CHECK(azimuthErrorDeg(sun, 194.34024) < kToleranceDeg);
    CHECK(std::abs(sun.declinationDeg - -9.31434) < kToleranceDeg);
    CHECK(std::abs(sun.equationOfTimeMin - 14.641503) < 0.02);
    CHECK(std::abs(sun.distanceAu - 0.9965423) < 1e-4);
    // Refraction alone, equation 42 of the report.
    CHECK(refractionDeg(39.872046, {82000.0, 284.15}) == doctest::Approx(0.016332).epsilon(1e-3));
}

TEST_CASE("Declination, equation of time and distance are those of Meeus's examples") {
    // [Meeus98] examples 25.a and 28.a: 13 October 1992, 0 h.
    const SolarPosition sun = solarPosition(almanacTime("1992-10-13T00:00:00Z"), 0.0, 0.0);
    CHECK(std::abs(sun.declinationDeg - -7.78507) < kToleranceDeg);
    CHECK(std::abs(sun.equationOfTimeMin - 13.70940) < 0.02);
    CHECK(std::abs(sun.distanceAu - 0.99766) < 1e-5);
}

TEST_CASE("At the poles the sun is as high as its declination, all day") {
    for (const char* time : {"1992-10-13T00:00:00Z", "1992-10-13T06:00:00Z"}) {
        const UtcTime when = almanacTime(time);
        CHECK(std::abs(solarPosition(when, 90.0, 0.0).elevationDeg - -7.8) < 0.1);
        CHECK(std::abs(solarPosition(when, -90.0, 0.0).elevationDeg - 7.8) < 0.1);
    }
    const UtcTime midnight = almanacTime("1992-10-13T00:00:00Z");
    CHECK(std::abs(solarPosition(midnight, -90.0, 0.0).elevationDeg - 7.78507) < kToleranceDeg);
    // Hours turn the sun clockwise at the north pole, the other way at the south pole.
    const UtcTime morning = almanacTime("1992-10-13T06:00:00Z");
    const auto turnDeg = [&](double latitudeDeg) {
        return std::remainder(solarPosition(morning, latitudeDeg, 0.0).azimuthDeg -
                                  solarPosition(midnight, latitudeDeg, 0.0).azimuthDeg,
                              360.0);
    };
    CHECK(std::abs(turnDeg(90.0) - 90.0) < 0.1);
    CHECK(std::abs(turnDeg(-90.0) - -90.0) < 0.1);
}

TEST_CASE("The sun moves evenly across midnight and across the leap day") {
    for (const char* time : {"2020-02-28T23:59:59Z", "2020-02-29T23:59:59Z", "2021-02-28T23:59:59Z",
                             "2020-12-31T23:59:59Z"}) {
        CAPTURE(time);
        const UtcTime before = almanacTime(time);
        const auto azimuthDeg = [&](double seconds) {
            return solarPosition(before + std::chrono::duration<double>(seconds), 50.0, 10.0)
                .azimuthDeg;
        };
        const double step = std::remainder(azimuthDeg(1.0) - azimuthDeg(0.0), 360.0);
        const double next = std::remainder(azimuthDeg(2.0) - azimuthDeg(1.0), 360.0);
        CHECK(step > 0.0);
        CHECK(next == doctest::Approx(step).epsilon(0.01));
    }
}

TEST_CASE("Refraction lifts the setting sun by half a degree and fades without a step below") {
    // By almanacs what is seen on the horizon stands 34' below it.
    CHECK(std::abs(refractionDeg(-34.0 / 60.0) - 34.0 / 60.0) < kToleranceDeg);
    CHECK(refractionDeg(90.0) == doctest::Approx(0.0).epsilon(1e-6));
    for (double elevationDeg = -89.0; elevationDeg < 90.0; elevationDeg += 0.01) {
        const double here = elevationDeg + refractionDeg(elevationDeg);
        const double above = elevationDeg + 0.01 + refractionDeg(elevationDeg + 0.01);
        REQUIRE(above > here);  // what is higher is seen higher
    }
    CHECK(refractionDeg(-6.0) < 0.1);
    CHECK(refractionDeg(-90.0) == 0.0);
}

TEST_CASE("At noon the sun crosses the meridian, on the side of the equator") {
    for (const double longitudeDeg : {-179.0, -97.5, 0.0, 10.0, 151.2}) {
        CAPTURE(longitudeDeg);
        const UtcTime start = almanacTime("2016-11-03T11:00:00Z");
        const UtcTime noon = nearestNoon(start, longitudeDeg);
        CHECK(std::abs((noon - start).count()) < 12.2 * 3600.0);
        const SolarPosition north = solarPosition(noon, 60.0, longitudeDeg);
        CHECK(std::abs(north.azimuthDeg - 180.0) < 1e-4);
        const SolarPosition south = solarPosition(noon, -60.0, longitudeDeg);
        CHECK(std::abs(std::remainder(south.azimuthDeg, 360.0)) < 1e-4);
    }
    // NOAA: on 3 November the equation of time is greatest, 16 min 25 s to 16 min 27 s.
    const double afterMidday = (nearestNoon(almanacTime("2016-11-03T11:00:00Z"), 0.0) -
                                almanacTime("2016-11-03T12:00:00Z"))
                                   .count();
    CHECK(afterMidday == doctest::Approx(-986.0).epsilon(0.003));
}
