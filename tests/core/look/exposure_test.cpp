// exposure_test.cpp: how bright looks are shown.
#include "core/look/exposure.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace neph;

namespace {

Look skyLook(float sunElevationDeg) {
    Look look;
    look.skyModel = SkyModel::atmosphere;
    look.sunElevationDeg = sunElevationDeg;
    return look;
}

}  // namespace

TEST_CASE("A stop doubles what is shown") {
    Look look;
    look.exposureEv = 2.0f;
    CHECK(exposureGain(look) == doctest::Approx(4.0));
    look = skyLook(40.0f);
    look.autoExposure = false;
    look.exposureEv = -1.0f;
    CHECK(exposureGain(look) == doctest::Approx(0.5));
}

TEST_CASE("By day the exposure is nearly that of a sun without air") {
    for (const float elevationDeg : {30.0f, 60.0f, 90.0f}) {
        Look look = skyLook(elevationDeg);
        look.exposureEv = 0.0f;
        CHECK(exposureGain(look) == doctest::Approx(1.0).epsilon(0.15));
    }
}

TEST_CASE("The lower the sun, the longer the exposure and the darker the image") {
    double light = 2.0, gain = 0.0, shown = 2.0;
    for (const float elevationDeg : {40.0f, 5.0f, 0.0f, -2.0f, -4.0f, -8.0f}) {
        CAPTURE(elevationDeg);
        const Look look = skyLook(elevationDeg);
        CHECK(meteredLight(look) < light);
        CHECK(exposureGain(look) > gain);
        light = meteredLight(look);
        gain = exposureGain(look);
        CHECK(light * gain < shown);
        shown = light * gain;
    }
}

TEST_CASE("Looks of the same air share it") {
    Look look = skyLook(10.0f);
    const auto air = atmosphereOf(look);
    look.sunElevationDeg = 20.0f;
    CHECK(atmosphereOf(look) == air);
    look.visibilityM = 20e3f;
    CHECK(atmosphereOf(look) != air);
}
