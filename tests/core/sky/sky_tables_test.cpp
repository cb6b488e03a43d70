// sky_tables_test.cpp: places in the tables of sky and air, and what the tables hold.
#include "core/sky/sky_tables.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "core/sky/air_columns.h"
#include "shaders/lib/glsl_cpp.h"

using namespace neph;

namespace {

glm::dvec3 towardsSun(double elevationDeg) {
    const double elevation = elevationDeg * std::numbers::pi / 180.0;
    return {std::cos(elevation), 0.0, std::sin(elevation)};
}

const Atmosphere& clearAir() {
    static const Atmosphere air({});
    return air;
}

/// Light of the air up to a distance, and what it leaves of other light.
struct AirUpTo {
    glm::dvec3 light, clear;
};

/// Halfway between texel k and the next of the tables of air, at an elevation and an azimuth of
/// theirs.
AirUpTo tabled(const SkyTables& tables, int elevation, int azimuth, int k) {
    const auto at = [&](int distance) {
        return static_cast<std::size_t>(distance * glsl::kAirElevations + elevation);
    };
    const auto lit = [&](int distance) {
        return at(distance) * static_cast<std::size_t>(glsl::kAirAzimuths) +
               static_cast<std::size_t>(azimuth);
    };
    return {glm::dvec3(0.5f * (tables.air[lit(k)] + tables.air[lit(k + 1)])),
            glm::dvec3(0.5f * (tables.clear[at(k)] + tables.clear[at(k + 1)]))};
}

AirUpTo integrated(const SkyRay& ray, double atM) {
    AirLight air;
    clearAir().along(ray, std::array{atM}, std::span(&air, 1));
    return {4.0 * std::numbers::pi * rgbOfSunlight(air.radiance),
            rgbOfSunlight(air.clear) / rgbOfSunlight(Spectrum(1.0f))};
}

}  // namespace

TEST_CASE("Places in the tables lead back to what they are of") {
    for (const float altitudeM : {0.0f, 2000.0f, 12e3f, 400e3f}) {
        CAPTURE(altitudeM);
        const float horizon = glsl::horizonSine(altitudeM);
        CHECK(horizon == doctest::Approx(horizonUp(static_cast<double>(altitudeM))).epsilon(1e-3));
        for (float share = 0.0f; share <= 1.0f; share += 0.0625f) {
            CHECK(glsl::skyShare(glsl::skyUpOfShare(share, horizon), horizon) ==
                  doctest::Approx(share).epsilon(0.02));
            CHECK(glsl::airShare(glsl::airUpOfShare(share, horizon), horizon) ==
                  doctest::Approx(share).epsilon(0.02));
            CHECK(glsl::lengthShare(glsl::lengthOfShare(share, 400e3f), 400e3f) ==
                  doctest::Approx(share).epsilon(1e-4));
        }
    }
    // 90 degrees from the sun's azimuth.
    const float share = glsl::azimuthShare(glm::vec3(0, 0.6f, 0.8f), glm::vec3(0.5f, 0, 0.866f));
    CHECK(glsl::azimuthOfShare(share) == doctest::Approx(std::numbers::pi / 2.0).epsilon(1e-4));
}

TEST_CASE("Bent rays graze the ground where the horizon of a sphere is") {
    for (const float altitudeM : {2.0f, 1500.0f, 12e3f, 400e3f}) {
        CAPTURE(altitudeM);
        const float bend = glsl::bendPerM(altitudeM);
        const auto meets = [&](float up) {
            const float across = std::sqrt(1.0f - up * up);
            return glsl::groundAlongM(altitudeM, {across, 0.0f, up}, bend) > 0.0f;
        };
        const float horizon = glsl::horizonSine(altitudeM);
        CHECK(meets(1.001f * horizon));
        CHECK_FALSE(meets(0.999f * horizon));
        CHECK(glsl::groundAlongM(altitudeM, {0.0f, 0.0f, -1.0f}, bend) ==
              doctest::Approx(altitudeM));
    }
    // From 10 km, half as steep again as to the horizon: by the law of cosines on the sphere.
    const float up = -0.084f, r = 6371e3f + 10e3f;
    const float exact = -r * up - std::sqrt(r * r * up * up - (r * r - 6371e3f * 6371e3f));
    const float along =
        glsl::groundAlongM(10e3f, {std::sqrt(1.0f - up * up), 0.0f, up}, glsl::bendPerM(10e3f));
    CHECK(along == doctest::Approx(exact).epsilon(0.01));
}

TEST_CASE("Two patterns make the sky at every height, in every colour") {
    for (const double elevation : {60.0, 5.0}) {
        CAPTURE(elevation);
        const SkyTables tables = makeSkyTables(clearAir(), towardsSun(elevation), 1000.0);
        constexpr auto kCount = static_cast<std::size_t>(glsl::kAltitudes);
        for (const std::size_t i : {std::size_t{0}, std::size_t{20}, std::size_t{32}}) {
            const double altitudeM = 40e3 * static_cast<double>(i * i) / (63.0 * 63.0);
            CAPTURE(altitudeM);
            // Irradiance on a level surface, by rays of equal shares of it.
            glm::dvec3 exact(0.0), made(0.0);
            constexpr int kSide = 12;
            for (int k = 0; k < kSide * kSide; ++k) {
                const double up = std::sqrt((k / kSide + 0.5) / kSide);
                const double azimuth = std::numbers::pi * (k % kSide + 0.5) / kSide;
                const double across = std::sqrt(1.0 - up * up);
                const glm::dvec3 dir{across * std::cos(azimuth), across * std::sin(azimuth), up};
                const SkyRay ray{altitudeM, up, azimuth, towardsSun(elevation).z};
                exact += 4.0 * std::numbers::pi * rgbOfSunlight(clearAir().along(ray).radiance);
                for (std::size_t p = 0; p < kSkyPatterns; ++p) {
                    made += glm::dvec3(tables.byAltitude[(1 + p) * kCount + i]) *
                            tables.dome->patterns[p].at(dir, tables.dome->towardsSun);
                }
            }
            for (int c = 0; c < 3; ++c) CHECK(made[c] == doctest::Approx(exact[c]).epsilon(0.04));
        }
    }
}

TEST_CASE("A pattern of the sky has irradiance pi") {
    const SkyTables tables = makeSkyTables(clearAir(), towardsSun(30.0), 0.0);
    for (const SkyPattern& pattern : tables.dome->patterns) {
        double sum = 0.0;
        constexpr int kSide = 64;
        for (int k = 0; k < kSide * kSide; ++k) {
            const double up = std::sqrt((k / kSide + 0.5) / kSide);
            const double azimuth = 2.0 * std::numbers::pi * (k % kSide + 0.5) / kSide;
            const double across = std::sqrt(1.0 - up * up);
            sum += pattern.at({across * std::cos(azimuth), across * std::sin(azimuth), up},
                              tables.dome->towardsSun);
        }
        CHECK(sum / (kSide * kSide) == doctest::Approx(1.0).epsilon(0.02));
    }
}

TEST_CASE("A table over lengths is interpolated evenly in length") {
    for (const float lengthM : {0.0f, 100.0f, 5000.0f, 123e3f, 399e3f, 400e3f}) {
        const float place = glsl::lengthCoordinate(glsl::lengthShare(lengthM, 400e3f), 24) * 24.0f;
        const float texel = std::min(std::floor(place - 0.5f), 22.0f);
        const float lowerM = glsl::lengthOfShare(texel / 23.0f, 400e3f);
        const float upperM = glsl::lengthOfShare((texel + 1.0f) / 23.0f, 400e3f);
        CHECK(std::lerp(lowerM, upperM, place - 0.5f - texel) ==
              doctest::Approx(lengthM).epsilon(1e-4));
    }
}

TEST_CASE("Between its distances the table of air has the air that there is") {
    using namespace glsl;
    constexpr int kAzimuth = 12;
    const glm::dvec3 sun = towardsSun(10.0);
    double sum = 0.0, clearSum = 0.0;
    int count = 0;
    const auto azimuth = static_cast<double>(
        azimuthOfShare(static_cast<float>(kAzimuth) / static_cast<float>(kAirAzimuths - 1)));
    for (const double altitudeM : {2.0, 1500.0, 12e3}) {
        const SkyTables tables = makeSkyTables(clearAir(), sun, altitudeM);
        const float horizon = horizonSine(static_cast<float>(altitudeM));
        for (int j = 0; j < kAirElevations; ++j) {
            const float up = airUpOfShare(
                static_cast<float>(j) / static_cast<float>(kAirElevations - 1), horizon);
            const float groundM =
                groundAlongM(static_cast<float>(altitudeM), {std::sqrt(1.0f - up * up), 0.0f, up},
                             bendPerM(static_cast<float>(altitudeM)));
            for (int k = 0; k + 1 < kAirDistances; ++k) {
                const double halfway = (k * k + (k + 1) * (k + 1)) / 2.0;
                const double last = (kAirDistances - 1) * (kAirDistances - 1);
                const double atM = static_cast<double>(kAirRangeM) * halfway / last;
                if (groundM >= 0.0f && atM > static_cast<double>(groundM)) break;
                CAPTURE(altitudeM);
                CAPTURE(up);
                CAPTURE(atM);
                const AirUpTo seen = tabled(tables, j, kAzimuth, k);
                const AirUpTo there =
                    integrated({altitudeM, static_cast<double>(up), azimuth, sun.z}, atM);
                for (int c = 0; c < 3; ++c) {
                    const double off =
                        std::abs(seen.light[c] - there.light[c]) / (there.light[c] + 0.02);
                    CHECK(off < 0.15);
                    clearSum += std::abs(seen.clear[c] - there.clear[c]);
                    sum += off;
                    ++count;
                }
            }
        }
    }
    CAPTURE(sum / count);
    CAPTURE(clearSum / count);
    CHECK(clearSum < 0.01 * count);
    CHECK(sum < 0.01 * count);
}
