// sun_test.cpp: the sun of a look by date and place, and its three buttons.
#include "core/look/sun.h"

#include <doctest/doctest.h>

#include <cmath>

#include "core/look/parameter.h"

using namespace neph;

namespace {

/// 2010-03-15 06:30 UTC at Longyearbyen: azimuth 110.910237, zenith angle 87.669511 degrees by
/// NREL's SPA [Reda04] (spa_reference_testdata.csv of github.com/klausbrunner/solarpositioning).
Whereabouts longyearbyen(double convergenceDeg = 0.0) {
    return {.place = PlacePoint{.geo = {78.22, 15.65}, .convergenceDeg = convergenceDeg},
            .utc = utcOfText("2010-03-15T06:30:00Z")};
}

Look byDate() {
    Look look;
    look.sunSource = SunSource::date;
    return look;
}

}  // namespace

TEST_CASE("A sun by date stands where the almanac has it for the place and date of the data") {
    const SunState state = sunStateOf(byDate(), longyearbyen());
    CHECK(state.placeOfData);
    CHECK(state.dateOfData);
    CHECK(std::abs(state.azimuthDeg - 110.910f) < 0.01f);
    CHECK(std::abs(state.elevationDeg - (90.0f - 87.670f)) < 0.01f);
}

TEST_CASE("The sun's path of a day passes through where the almanac has it, in the grid's frame") {
    const std::vector<SunPathPoint> path = sunPathOf(byDate(), longyearbyen(-20.0));
    REQUIRE(path.size() == 97);
    CHECK(path.front().hour == 0.0);
    CHECK(path.back().hour == 24.0);
    CHECK(path[26].hour == 6.5);
    CHECK(std::abs(path[26].azimuthDeg - 90.910) < 0.01);
    CHECK(std::abs(path[26].elevationDeg - (90.0 - 87.670)) < 0.01);
    // By angles the data alone can give it.
    CHECK(sunPathOf(Look{}, longyearbyen()).size() == 97);
    Whereabouts where = longyearbyen();
    where.utc.reset();
    CHECK(sunPathOf(Look{}, where).empty());
    // Of the look's own day and hour otherwise.
    Look look = byDate();
    look.sunDay = 75;
    look.sunHour = 6.5f;
    const SunPathPoint at = sunPathOf(look, where)[26];
    const SunState state = sunStateOf(look, where);
    CHECK(std::abs(at.azimuthDeg - static_cast<double>(state.azimuthDeg)) < 1e-4);
    CHECK(std::abs(at.elevationDeg - static_cast<double>(state.elevationDeg)) < 1e-4);
}

TEST_CASE("A sun that is put somewhere stands by angles within the range of their rows") {
    Look look = byDate();
    setSunAngles(look, -30.0, 95.0);
    CHECK(look.sunSource == SunSource::angles);
    CHECK(look.sunAzimuthDeg == 330.0f);
    CHECK(look.sunElevationDeg == 90.0f);
    setSunAngles(look, 725.0, -80.0);
    CHECK(look.sunAzimuthDeg == 5.0f);
    CHECK(look.sunElevationDeg == -12.0f);
}

TEST_CASE("A grid that is turned against true north has the sun in its own frame") {
    // True north 20 degrees west of the grid's north: all azimuths are 20 degrees less.
    CHECK(std::abs(sunStateOf(byDate(), longyearbyen(-20.0)).azimuthDeg - 90.910f) < 0.01f);
    CHECK(std::abs(sunStateOf(byDate(), longyearbyen(250.0)).azimuthDeg - 0.910f) < 0.01f);
}

TEST_CASE("What the data do not state comes from the look, each part by itself") {
    Look look = byDate();
    look.sunLatitudeDeg = 78.22f;
    look.sunLongitudeDeg = 15.65f;
    look.sunDay = 75;  // 15 March of a leap year
    look.sunHour = 6.5f;
    Whereabouts where = longyearbyen();
    where.place.reset();
    SunState state = sunStateOf(look, where);
    CHECK_FALSE(state.placeOfData);
    CHECK(std::abs(state.azimuthDeg - 110.910f) < 0.01f);
    where = longyearbyen();
    where.utc.reset();
    state = sunStateOf(look, where);
    CHECK_FALSE(state.dateOfData);
    // Another year: the sun has moved by up to half a day of its yearly path.
    CHECK(utcText(state.utc).substr(4) == "-03-15T06:30:00Z");
    CHECK(std::abs(state.elevationDeg - (90.0f - 87.670f)) < 0.25f);
    look.sunDay = 366;
    CHECK(utcText(sunStateOf(look, {}).utc).substr(4) == "-12-31T06:30:00Z");
}

TEST_CASE("A look by angles is drawn as it is, whatever the data state") {
    Look look;
    look.sunAzimuthDeg = 123.0f;
    look.sunElevationDeg = 4.0f;
    CHECK(withSun(look, longyearbyen(30.0)) == look);
}

TEST_CASE("The look that is drawn has the sun by angles, and the rest unchanged") {
    Look look = byDate();
    look.sunIntensity = 3.0f;
    const Look drawn = withSun(look, longyearbyen());
    CHECK(drawn.sunSource == SunSource::angles);
    CHECK(drawn.sunIntensity == 3.0f);
    CHECK(withSun(drawn, {}) == drawn);
    const glm::dvec3 towards = sunDirWorld(drawn);
    CHECK(glm::degrees(std::asin(towards.z)) == doctest::Approx(90.0 - 87.669511).epsilon(0.005));
    CHECK(glm::degrees(std::atan2(towards.x, towards.y)) ==
          doctest::Approx(110.910237).epsilon(1e-4));
}

TEST_CASE("Looks whose suns stand alike are drawn alike, whatever does not act") {
    Look other;
    other.sunLatitudeDeg = 10.0f;
    other.sunDay = 3;
    CHECK(withSun(other, {}) == withSun(Look(), {}));
    Look dated = byDate();
    dated.sunHour = 3.0f;
    CHECK(withSun(dated, longyearbyen()) == withSun(byDate(), longyearbyen()));
}

TEST_CASE("The sun is written with the date and place that it follows from, where it does") {
    CHECK(sunText(sunStateOf(byDate(), longyearbyen())) ==
          "azimuth 110.9, elevation 2.3 deg at 2010-03-15T06:30:00Z, 78.22 N 15.65 E");
    CHECK(sunText(sunStateOf(Look(), {})) == "azimuth 225.0, elevation 35.0 deg");
}

TEST_CASE("Golden hour keeps the azimuth of the sun and puts it at 6 degrees") {
    Look look;
    look.sunAzimuthDeg = 77.0f;
    setGoldenHour(look, {});
    CHECK(look.sunAzimuthDeg == 77.0f);
    CHECK(look.sunElevationDeg == 6.0f);
    Look dated = byDate();
    setGoldenHour(dated, longyearbyen());
    CHECK(dated.sunSource == SunSource::angles);
    CHECK(std::abs(dated.sunAzimuthDeg - 110.910f) < 0.01f);
    CHECK(dated.sunElevationDeg == 6.0f);
}

TEST_CASE("Noon is the passage of the meridian by date, and a high sun in the south by angles") {
    Look look;
    setNoon(look, {});
    CHECK(look.sunAzimuthDeg == 180.0f);
    CHECK(look.sunElevationDeg == 60.0f);
    // Brasilia in June: noon in the north, some 50 degrees high (90 - 15.8 - 23.3).
    Look chosen = byDate();
    chosen.sunLatitudeDeg = -15.79f;
    chosen.sunLongitudeDeg = -47.88f;
    chosen.sunDay = 167;
    chosen.sunHour = 20.0f;
    setNoon(chosen, {});
    CHECK(chosen.sunSource == SunSource::date);
    CHECK(chosen.sunDay == 167);
    const SunState noon = sunStateOf(chosen, {});
    CHECK(std::abs(std::remainder(noon.azimuthDeg, 360.0f)) < 0.05f);
    CHECK(noon.elevationDeg == doctest::Approx(50.9).epsilon(0.01));
    // A date of the data stays: the sun is put where it was or will be at noon.
    Look dated = byDate();
    setNoon(dated, longyearbyen(-5.0));
    CHECK(dated.sunSource == SunSource::angles);
    CHECK(std::abs(dated.sunAzimuthDeg - 175.0f) < 0.01f);
    CHECK(dated.sunElevationDeg == doctest::Approx(90.0 - 78.22 - 2.1).epsilon(0.03));
}

TEST_CASE("Backlit puts the sun beyond the target, opposite to the camera") {
    Look look = byDate();
    setBacklit(look, 30.0f);
    CHECK(look.sunSource == SunSource::angles);
    CHECK(look.sunAzimuthDeg == 210.0f);
    CHECK(look.sunElevationDeg == 10.0f);
    setBacklit(look, 300.0f);
    CHECK(look.sunAzimuthDeg == 120.0f);
}

TEST_CASE("Rows of angles act by angles, rows of date and place by date") {
    const auto acts = [](const char* id, SunSource source) {
        Look look;
        look.sunSource = source;
        return applies(parameter(id), look);
    };
    for (const char* id : {"sun.azimuth", "sun.elevation"}) {
        CHECK(acts(id, SunSource::angles));
        CHECK_FALSE(acts(id, SunSource::date));
    }
    for (const char* id : {"sun.latitude", "sun.longitude", "sun.day", "sun.hour"}) {
        CHECK(acts(id, SunSource::date));
        CHECK_FALSE(acts(id, SunSource::angles));
    }
}

TEST_CASE("At night by date a gradient has no sun, and an atmosphere keeps it below the horizon") {
    Look look;
    look.sunSource = SunSource::date;
    look.sunLatitudeDeg = look.sunLongitudeDeg = 0.0f;
    look.sunDay = 172;
    look.sunHour = 0.0f;  // midnight in Greenwich
    CHECK(withSun(look, {}).sunElevationDeg < -60.0f);
    CHECK(withSun(look, {}).sunIntensity == 0.0f);
    look.skyModel = SkyModel::atmosphere;
    CHECK(withSun(look, {}).sunIntensity == look.sunIntensity);
    look.skyModel = SkyModel::gradient;
    look.sunHour = 12.0f;
    CHECK(withSun(look, {}).sunIntensity == look.sunIntensity);
}

TEST_CASE("By a date the moon stands where it is, lit as it is, and is fainter") {
    Look look;
    look.skyModel = SkyModel::atmosphere;
    look.sunBody = LightBody::moon;
    look.sunSource = SunSource::date;
    Whereabouts where;
    where.utc = utcOfText("2024-05-16T02:00:00Z");  // a day after the first quarter
    const SunState state = sunStateOf(look, where);
    CHECK(state.moon);
    CHECK(state.moonPhaseDeg == doctest::Approx(84.0).epsilon(0.06));
    CHECK(sunText(state).find("moon, phase angle 8") != std::string::npos);
    const Look drawn = withSun(look, where);
    CHECK(drawn.sunAzimuthDeg == state.azimuthDeg);
    CHECK(shownIntensity(drawn) < 4e-7f);
    // The sun that lights it is at the phase angle from the way back to the eye.
    const double cosine = glm::dot(sunOfMoonWorld(drawn), -sunDirWorld(drawn));
    CHECK(glm::degrees(std::acos(cosine)) ==
          doctest::Approx(static_cast<double>(state.moonPhaseDeg)).epsilon(1e-3));
    look.skyModel = SkyModel::gradient;
    CHECK_FALSE(sunStateOf(look, where).moon);
}

TEST_CASE("From aloft the disc is seen lower by what the air bends less, and can be put anywhere") {
    Look look;
    look.skyModel = SkyModel::atmosphere;
    look.sunElevationDeg = 0.5f;
    CHECK(discDirWorld(look, 0.0).z == doctest::Approx(sunDirWorld(look).z).epsilon(0.02));
    // Refraction at an apparent half degree is 29', of which little is left at 12 km.
    const double aloft = glm::degrees(std::asin(discDirWorld(look, 12e3).z));
    CHECK(aloft > 0.0);
    CHECK(aloft < 0.25);
    for (const double altitudeM : {0.0, 3000.0, 12e3}) {
        for (const double elevationDeg : {60.0, 5.0, 0.3, -1.5}) {
            CAPTURE(altitudeM);
            CAPTURE(elevationDeg);
            if (altitudeM < 12e3 && elevationDeg < 0.0) continue;  // behind the Earth
            setDiscSeen(look, compassDirWorld(30.0f, static_cast<float>(elevationDeg)), altitudeM);
            const glm::dvec3 seen = discDirWorld(look, altitudeM);
            CHECK(glm::degrees(std::asin(seen.z)) == doctest::Approx(elevationDeg).epsilon(0.01));
            CHECK(look.sunAzimuthDeg == doctest::Approx(30.0));
        }
    }
    look.skyModel = SkyModel::gradient;
    CHECK(discDirWorld(look, 12e3) == sunDirWorld(look));
}
