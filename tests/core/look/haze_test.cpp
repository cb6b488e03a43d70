// haze_test.cpp: which looks follow the humidity, and what engines are given.
#include "core/look/haze.h"

#include <doctest/doctest.h>

#include "core/look/exposure.h"
#include "core/look/parameter.h"

using namespace neph;

namespace {

Look byHumidity() {
    Look look;
    look.skyModel = SkyModel::atmosphere;
    look.haze = Haze::humidity;
    look.visibilityM = 50e3f;
    return look;
}

Whereabouts inAir(double humidity) {
    Whereabouts where;
    where.humidity = humidity;
    return where;
}

}  // namespace

TEST_CASE("Haze follows the humidity where the look asks for it and the data have it") {
    // 90 km e^(-2.5 (0.7 - 0.15)) at a contrast of 5 %, times ln 0.02 / ln 0.05.
    const HazeState haze = hazeOf(byHumidity(), inAir(0.7));
    CHECK(haze.visibilityM == doctest::Approx(29716.0).epsilon(1e-4));
    CHECK(haze.humidity == 0.7);
    CHECK(hazeText(haze) == "visibility 29.7 km by a relative humidity of 70 % of the lowest air");
    CHECK(hazeText(hazeOf(byHumidity(), {})) == "visibility 50 km");
    Look fixed = byHumidity();
    fixed.haze = Haze::fixed;
    CHECK(hazeOf(fixed, inAir(0.7)).visibilityM == 50e3);
}

TEST_CASE("A sky of two colours asks for no humidity") {
    Look look = byHumidity();
    CHECK(asksHumidity(look));
    look.skyModel = SkyModel::gradient;
    CHECK_FALSE(asksHumidity(look));
    CHECK(lookAsDrawn(look, inAir(0.7)).visibilityM == 50e3f);
}

TEST_CASE("Engines are given a fixed haze, and its exposure and light are those of the data") {
    const Look drawn = lookAsDrawn(byHumidity(), inAir(0.7));
    CHECK(drawn.haze == Haze::fixed);
    CHECK(drawn.visibilityM == doctest::Approx(29716.0).epsilon(1e-4));
    CHECK(lookAsDrawn(drawn, inAir(0.2)) == drawn);
    // Only the air differs between times, and with it the light.
    const Look later = lookAsDrawn(byHumidity(), inAir(0.9));
    CHECK(firstDifference(drawn, later) == Stage::light);
    CHECK(atmosphereOf(later)->spec().visibilityM < 20e3);
    Look same = drawn;
    same.visibilityM = later.visibilityM;
    CHECK(same == later);
}

TEST_CASE("Where haze cannot follow the humidity a note says why and what acts instead") {
    CHECK(
        hazeNote(byHumidity(), {}, "18:00", "the data have no water vapour", "") ==
        "18:00: haze does not follow the humidity: the data have no water vapour; visibility 50 km "
        "as sky.visibility has it.");
    CHECK(
        hazeNote(byHumidity(), inAir(0.7), "18:00", "", "the data have no number of dust").empty());
    CHECK(hazeNote(Look(), {}, "18:00", "the data have no water vapour", "").empty());
}

TEST_CASE("Haze follows the aerosol where the look asks for it and the data have it") {
    Look look = byHumidity();
    look.haze = Haze::aerosol;
    Whereabouts where = inAir(0.7);
    where.aerosolPerM = 6e-5;
    // 3.912 / (6e-5 + 1.148e-5), the molecules of [Bodhaine99]: 1.15e-5 /m of docs/sky.md.
    const HazeState haze = hazeOf(look, where);
    CHECK(haze.byAerosol);
    CHECK(haze.visibilityM == doctest::Approx(3.912 / (6e-5 + 1.15e-5)).epsilon(1e-3));
    CHECK(hazeText(haze) ==
          "visibility 54.7 km by the aerosol of the lowest air, at a relative humidity of 70 %");
    CHECK(hazeNote(look, where, "18:00", "", "").empty());
    CHECK(atmosphereOf(lookAsDrawn(look, where))->hazePerM().at[0] > 6e-5f);  // at 400 nm
    CHECK(hazeOf(byHumidity(), where).visibilityM == doctest::Approx(29716.0).epsilon(1e-4));
    where.aerosolPerM = 0.0;
    CHECK(hazeOf(look, where).visibilityM == 300e3);
    where.aerosolPerM = 1.0;
    CHECK(hazeOf(look, where).visibilityM == 2e3);
}

TEST_CASE("Without aerosol haze follows the humidity, without that the look, and a note says so") {
    Look look = byHumidity();
    look.haze = Haze::aerosol;
    const std::string_view dust = "the data have no number of dust";
    const std::string_view vapour = "the data have no water vapour";
    CHECK(hazeOf(look, inAir(0.7)).visibilityM == doctest::Approx(29716.0).epsilon(1e-4));
    CHECK_FALSE(hazeOf(look, inAir(0.7)).byAerosol);
    CHECK(hazeNote(look, inAir(0.7), "18:00", "", dust) ==
          "18:00: haze does not follow the aerosol: the data have no number of dust; visibility "
          "29.7 km by a relative humidity of 70 % of the lowest air.");
    CHECK(hazeNote(look, {}, "18:00", vapour, dust) ==
          "18:00: haze does not follow the aerosol: the data have no number of dust, and the data "
          "have no water vapour; visibility 50 km as sky.visibility has it.");
    CHECK(hazeNote(look, {}, "18:00", vapour, vapour) ==
          "18:00: haze does not follow the aerosol: the data have no water vapour; visibility "
          "50 km as sky.visibility has it.");
}
