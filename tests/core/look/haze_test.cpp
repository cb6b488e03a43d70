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
        hazeNote(byHumidity(), "18:00", "the data have no water vapour") ==
        "18:00: haze does not follow the humidity: the data have no water vapour; visibility 50 km "
        "as sky.visibility has it.");
    CHECK(hazeNote(byHumidity(), "18:00", "").empty());
    CHECK(hazeNote(Look(), "18:00", "the data have no water vapour").empty());
}
