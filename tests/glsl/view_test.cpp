// view_test.cpp: rays through boxes, the background, and tone mapping from radiance to the display.
#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <numbers>

#include "shaders/lib/glsl_cpp.h"

using namespace neph;
using doctest::Approx;

namespace {
const glm::vec3 kLower(0.0f), kUpper(2.0f, 4.0f, 8.0f);
}

TEST_CASE("A ray is inside a box between two distances, also if it starts inside or points away") {
    const glm::vec2 through = glsl::rayBox({-1.0f, 2.0f, 4.0f}, {1.0f, 0.0f, 0.0f}, kLower, kUpper);
    CHECK(through.x == Approx(1.0));
    CHECK(through.y == Approx(3.0));
    const glm::vec2 inside = glsl::rayBox({1.0f, 1.0f, 1.0f}, {0.0f, 0.0f, -2.0f}, kLower, kUpper);
    CHECK(inside.x == Approx(-3.5));
    CHECK(inside.y == Approx(0.5));
    const glm::vec2 behind = glsl::rayBox({5.0f, 2.0f, 4.0f}, {1.0f, 0.0f, 0.0f}, kLower, kUpper);
    CHECK(behind.x == Approx(-5.0));
    CHECK(behind.y == Approx(-3.0));
}

TEST_CASE("A ray beside a box misses it, parallel to its walls or not") {
    for (const glm::vec3 dir :
         {glm::vec3(1.0f, 0.0f, 0.0f), glm::vec3(1.0f, 0.1f, 0.0f), glm::vec3(-1.0f, 0.0f, 0.0f)}) {
        const glm::vec2 t = glsl::rayBox({-1.0f, 5.0f, 4.0f}, dir, kLower, kUpper);
        CHECK(t.x > t.y);
    }
}

TEST_CASE("A diagonal ray enters at the last near plane and leaves at the first far plane") {
    const glm::vec3 dir = glm::normalize(glm::vec3(1.0f, 2.0f, 4.0f));
    const glm::vec2 t = glsl::rayBox(-dir, dir, kLower, kUpper);
    CHECK(t.x == Approx(1.0));
    CHECK(t.y == Approx(1.0 + std::sqrt(84.0)).epsilon(1e-6));
}

TEST_CASE("The sky is the horizon's colour at and below the horizon, the zenith's overhead") {
    const glm::vec3 zenith(0.1f, 0.2f, 0.5f), horizon(0.5f, 0.6f, 0.7f);
    CHECK(glsl::skyRadiance(0.0f, zenith, horizon) == horizon);
    CHECK(glsl::skyRadiance(-0.4f, zenith, horizon) == horizon);
    CHECK(glm::distance(glsl::skyRadiance(1.0f, zenith, horizon), zenith) < 1e-6f);
    const glm::vec3 between = glsl::skyRadiance(0.3f, zenith, horizon);
    for (int c = 0; c < 3; ++c) {
        CHECK(between[c] > zenith[c]);
        CHECK(between[c] < horizon[c]);
    }
}

TEST_CASE("The ground fades into the horizon with distance") {
    const glm::vec3 ground(0.1f), horizon(0.6f);
    CHECK(glsl::hazyGround(ground, horizon, 0.0f) == ground);
    const glm::vec3 away = glsl::hazyGround(ground, horizon, glsl::kHazeLengthM);
    CHECK(away.r == Approx(0.6 - 0.5 / std::exp(1.0)).epsilon(1e-5));
}

TEST_CASE("Display encoding is sRGB: 0.18 becomes 0.4614 and 0.5 becomes 0.7354") {
    CHECK(glsl::srgbEncode(0.18f) == Approx(0.461356).epsilon(1e-5));
    CHECK(glsl::srgbEncode(0.5f) == Approx(0.735357).epsilon(1e-5));
    CHECK(glsl::srgbEncode(0.0f) == 0.0f);
    CHECK(glsl::srgbEncode(1.0f) == Approx(1.0).epsilon(1e-6));
    CHECK(glsl::srgbEncode(0.0031308f) == Approx(glsl::srgbEncode(0.00313081f)).epsilon(1e-4));
}

TEST_CASE("The disc has all of the sun's light, however large the pixels, and a darker limb") {
    // By rings around the middle; a pixel's edge is soft.
    for (const float pixel : {1e-5f, 1e-3f, 0.01f, 0.05f}) {
        glm::dvec3 sum(0.0);
        const double widest = 1.2 * static_cast<double>(std::max(glsl::kSunRadius, pixel));
        constexpr int kRings = 20000;
        for (int i = 0; i < kRings; ++i) {
            const double angle = widest * (i + 0.5) / kRings;
            sum += 2.0 * std::numbers::pi * angle * (widest / kRings) *
                   glm::dvec3(glsl::sunDiscShare(static_cast<float>(angle), pixel));
        }
        for (int c = 0; c < 3; ++c) {
            CHECK(sum[c] == Approx(1.0).epsilon(pixel < 1e-4f ? 0.01 : 0.15));
        }
    }
    const glm::vec3 middle = glsl::sunDiscShare(0.0f, 1e-5f);
    const glm::vec3 limb = glsl::sunDiscShare(0.98f * glsl::kSunRadius, 1e-5f);
    CHECK(limb.r / middle.r > limb.b / middle.b);
    CHECK(limb.g / middle.g == Approx(0.44).epsilon(0.05));
    CHECK(glsl::sunDiscShare(1.1f * glsl::kSunRadius, 1e-5f).g == 0.0f);
}

TEST_CASE("The ground is as bright on average as its colour, near and far, land and sea") {
    for (const int kind : {glsl::kPlainGround, glsl::kFieldGround, glsl::kSeaGround}) {
        for (const float pixelM : {5.0f, 300.0f, 5000.0f}) {
            CAPTURE(kind);
            CAPTURE(pixelM);
            glm::dvec3 sum(0.0);
            constexpr int kAcross = 300;
            for (int i = 0; i < kAcross * kAcross; ++i) {
                const glm::vec2 at(4237.0f * static_cast<float>(i % kAcross) - 700e3f,
                                   4151.0f * static_cast<float>(i / kAcross) - 650e3f);
                sum += glm::dvec3(glsl::groundPattern(kind, at, pixelM));
            }
            sum /= kAcross * kAcross;
            for (int c = 0; c < 3; ++c) CHECK(sum[c] == Approx(1.0).epsilon(0.02));
        }
    }
}

TEST_CASE("All that strays in a lens falls somewhere ahead") {
    double sum = 0.0;
    constexpr int kRings = 20000;
    for (int i = 0; i < kRings; ++i) {
        const double angle = 0.5 * std::numbers::pi * (i + 0.5) / kRings;
        sum += 2.0 * std::numbers::pi * std::sin(angle) * (0.5 * std::numbers::pi / kRings) *
               static_cast<double>(glsl::glareAt(static_cast<float>(angle)));
    }
    CHECK(sum == Approx(1.0).epsilon(0.01));
}

TEST_CASE("Filmic tone mapping rises from 0 to 1 and maps 1 to 0.8038") {
    CHECK(glsl::filmic(glm::vec3(0.0f)).r == 0.0f);
    CHECK(glsl::filmic(glm::vec3(1.0f)).r == Approx(2.54 / 3.16).epsilon(1e-5));
    CHECK(glsl::filmic(glm::vec3(100.0f)).r == 1.0f);
    float before = 0.0f;
    for (float x = 0.05f; x < 5.0f; x += 0.05f) {
        const float now = glsl::filmic(glm::vec3(x)).r;
        CHECK(now > before);
        before = now;
    }
}

TEST_CASE("Display values get gain, tone mapping and encoding, and negative light is black") {
    const glm::vec3 linear = glsl::displayValue(glm::vec3(0.5f, -2.0f, 18.0f), 0);
    CHECK(linear.r == Approx(0.735357).epsilon(1e-5));
    CHECK(linear.g == 0.0f);
    CHECK(linear.b == Approx(1.0).epsilon(1e-6));
    const glm::vec3 video = glsl::displayValue(glm::vec3(1.0f), 1);
    CHECK(video.r == Approx(glsl::srgbEncode(2.54f / 3.16f)).epsilon(1e-5));
}

TEST_CASE("Clouds that repeat are what they are nearby, and gone where rays end") {
    const glm::vec3 cloud(1.0f), horizon(0.2f, 0.3f, 0.4f);
    CHECK(glsl::hazyCloud(cloud, horizon, 0.0f) == cloud);
    CHECK(glm::length(glsl::hazyCloud(cloud, horizon, 3e3f) - cloud) < 2e-3f);
    const glm::vec3 away = glsl::hazyCloud(cloud, horizon, glsl::kHazeLengthM);
    CHECK(away.r == doctest::Approx(0.2 + 0.8 * std::exp(-1.0)));
    CHECK(glm::length(glsl::hazyCloud(cloud, horizon, glsl::kSeenM) - horizon) < 3e-3f);
}
