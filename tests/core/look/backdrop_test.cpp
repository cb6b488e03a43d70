// backdrop_test.cpp: sky and ground as an image without cloud has them.
#include "core/look/backdrop.h"

#include <doctest/doctest.h>

#include <cmath>

#include "core/sky/air_columns.h"

using namespace neph;

namespace {

Look airy(float sunElevationDeg) {
    Look look;
    look.skyModel = SkyModel::atmosphere;
    look.sunAzimuthDeg = 90.0f;
    look.sunElevationDeg = sunElevationDeg;
    return look;
}

glm::dvec3 towards(double azimuthDeg, double elevationDeg) {
    return compassDirWorld(static_cast<float>(azimuthDeg), static_cast<float>(elevationDeg));
}

float brightness(const glm::vec3& colour) {
    return colour.r + colour.g + colour.b;
}

}  // namespace

TEST_CASE("Two colours are shown as the gradient has them, in the tones of the look") {
    Look look;
    look.skyModel = SkyModel::gradient;
    look.toneMap = ToneMap::linear;
    look.exposureEv = 0.0f;
    look.skyZenith = {0.0f, 0.0f, 1.0f};
    look.skyHorizon = {1.0f, 0.0f, 0.0f};
    look.skyIntensity = 0.5f;
    const Backdrop backdrop(look, 0.0);
    // 0.5 is encoded as 0.735 (IEC 61966-2-1).
    CHECK(glm::length(backdrop.sky(towards(0.0, 90.0)) - glm::vec3(0.0f, 0.0f, 0.7354f)) < 1e-3f);
    CHECK(glm::length(backdrop.sky(towards(0.0, -5.0)) - glm::vec3(0.7354f, 0.0f, 0.0f)) < 1e-3f);
    CHECK(backdrop.horizonUp() == 0.0);
    look.groundVisible = false;
    CHECK_FALSE(Backdrop(look, 0.0).ground(towards(0.0, -5.0)).has_value());
}

TEST_CASE("A clear sky is blue above, paler at the horizon and red where the sun is low") {
    const Backdrop day(airy(40.0f), 1000.0);
    const glm::vec3 above = day.sky(towards(270.0, 60.0)), low = day.sky(towards(270.0, 1.0));
    CHECK(above.b > 1.3f * above.r);
    CHECK(brightness(low) > brightness(above));
    const Backdrop dusk(airy(1.0f), 1000.0);
    const glm::vec3 glow = dusk.sky(towards(90.0, 1.0)), against = dusk.sky(towards(270.0, 60.0));
    CHECK(glow.r > 1.2f * glow.b);
    CHECK(against.b > against.r);
}

TEST_CASE("The ground has its colour near and the sky's at the horizon, which sinks with height") {
    Look look = airy(40.0f);
    look.groundColour = {0.4f, 0.05f, 0.05f};
    const Backdrop backdrop(look, 2000.0);
    CHECK(backdrop.horizonUp() == doctest::Approx(horizonUp(2000.0)));
    CHECK(backdrop.horizonUp() < 0.0);
    const glm::vec3 near = backdrop.ground(towards(0.0, -80.0)).value();
    const glm::vec3 far = backdrop.ground(towards(0.0, 0.0)).value();
    CHECK(near.r > 1.3f * near.b);
    CHECK(glm::length(far - backdrop.sky(towards(0.0, 0.0))) < 0.1f);
    CHECK(glm::length(near - far) > 0.2f);
}
