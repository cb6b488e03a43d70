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

TEST_CASE("An exposure value has its luminance be white, and is that of the gain") {
    Look look = skyLook(40.0f);
    look.autoExposure = false;
    look.exposureEv = 0.0f;
    look.ev100 = 15.0f;
    // White is 1.2 cd/m² times 2^15; an image's unit is the sun's 194 W/m² over 4 pi, 683 lm/W.
    const double whiteUnits = 1.2 * std::exp2(15.0) / (683.0 * imageUnitWPerM2Sr());
    CHECK(exposureGain(look) == doctest::Approx(1.0 / whiteUnits).epsilon(0.01));
    CHECK(exposureValue(look) == doctest::Approx(15.0).epsilon(1e-4));
    look.exposureEv = 1.0f;
    CHECK(exposureValue(look) == doctest::Approx(14.0).epsilon(1e-4));
    look.autoExposure = true;
    CHECK(exposureValue(look) == doctest::Approx(12.1).epsilon(0.02));
}

TEST_CASE("Balanced by the sun, what falls on a cloud is white and as bright as before") {
    Look look = skyLook(3.0f);
    const glm::dvec3 light = meteredColour(look);
    CHECK(light.r > 1.2 * light.b);
    CHECK(displayTones(look).exposure[1][0] == 0.0f);
    const double gain = static_cast<double>(exposureGain(look));
    look.whiteBalance = WhiteBalance::sun;
    const glm::dvec3 shown = glm::dmat3(displayTones(look).exposure) * light;
    for (int c = 0; c < 3; ++c) {
        CHECK(shown[c] == doctest::Approx(gain * meteredLight(look)).epsilon(1e-3));
    }
}

TEST_CASE("The reflectance factor of a white surface in full sunlight is 1 at any exposure") {
    Look look = skyLook(30.0f);
    look.exposureEv = 3.0f;
    look.toneMap = ToneMap::reflectance;
    look.sunIntensity = 2.0f;
    const DisplayTones tones = displayTones(look);
    // Radiance of a white Lambert surface: the irradiance of 4 pi times 2 sin 30 over pi.
    CHECK((tones.exposure * glm::vec3(4.0f)).r == doctest::Approx(1.0));
    CHECK(tones.curve == static_cast<int>(ToneMap::linear));
}

TEST_CASE("Glare is a share of the sun's light, and there is none without a disc") {
    Look look = skyLook(50.0f);
    look.glare = 0.02f;
    CHECK(glareOf(look, 0.0).g == doctest::Approx(0.02 * discIrradiance(look, 0.0).g));
    CHECK(discIrradiance(look, 0.0).g < discIrradiance(look, 12e3).g);
    CHECK(discIrradiance(look, 40e3).g == doctest::Approx(12.5).epsilon(0.03));
    look.sunDisc = false;
    CHECK(glareOf(look, 0.0) == glm::vec3(0.0f));
}

TEST_CASE("Looks of the same air share it") {
    Look look = skyLook(10.0f);
    const auto air = atmosphereOf(look);
    look.sunElevationDeg = 20.0f;
    CHECK(atmosphereOf(look) == air);
    look.visibilityM = 20e3f;
    CHECK(atmosphereOf(look) != air);
}
