// look_test.cpp: the defaults of a look, and where its sun stands.
#include "core/look/look.h"

#include <doctest/doctest.h>

#include <cmath>
#include "core/look/sun.h"

using namespace neph;

TEST_CASE("Default radii are those of table 3 of the paper") {
    const Look look;
    CHECK(look.of(Species::cloud).effectiveRadiusM == 0.01e-3f);
    CHECK(look.of(Species::ice).effectiveRadiusM == 1e-3f);
    CHECK(look.of(Species::rain).effectiveRadiusM == 1e-3f);
    CHECK(look.of(Species::snow).effectiveRadiusM == 2e-3f);
    CHECK(look.of(Species::graupel).effectiveRadiusM == 2.5e-3f);
}

TEST_CASE("The sun stands where compass and horizon say") {
    Look look;
    look.sunElevationDeg = 0.0f;
    look.sunAzimuthDeg = 90.0f;  // east is +x
    CHECK(sunDirWorld(look).x == doctest::Approx(1.0));
    look.sunAzimuthDeg = 0.0f;  // north is +y
    CHECK(sunDirWorld(look).y == doctest::Approx(1.0));
    look.sunElevationDeg = 30.0f;
    CHECK(sunDirWorld(look).z == doctest::Approx(0.5));
    CHECK(glm::length(sunDirWorld(look)) == doctest::Approx(1.0));
}

TEST_CASE("Droplets scatter as droplets and ice as crystals, of sizes that clouds have") {
    const Look look;
    for (const Species s : {Species::cloud, Species::rain}) {
        CHECK(look.of(s).phase.kind == PhaseKind::waterDroplets);
        CHECK(look.of(s).noiseCharacter == NoiseCharacter::billow);
    }
    for (const Species s : {Species::ice, Species::snow, Species::graupel, Species::hail}) {
        CHECK(look.of(s).phase.kind == PhaseKind::roughAggregate);
        CHECK(look.of(s).phase.radiusM == 30e-6f);
        CHECK(look.of(s).noiseCharacter == NoiseCharacter::wisp);
    }
    CHECK(look.of(Species::cloud).phase.radiusM == 10e-6f);
    CHECK(look.of(Species::rain).phase.radiusM == 25e-6f);
}

TEST_CASE("Between periodic sides the sun keeps off the horizon, of engines that know them") {
    Look look;
    look.domainSides = DomainSides::periodic;
    for (const float elevationDeg : {0.0f, 0.5f, -0.5f, 1.5f, -3.0f}) {
        CAPTURE(elevationDeg);
        look.sunElevationDeg = elevationDeg;
        const float kept = elevationDeg == -0.5f           ? -1.0f
                           : std::abs(elevationDeg) < 1.0f ? 1.0f
                                                           : elevationDeg;
        for (const Engine engine : {Engine::march, Engine::reference}) {
            look.engine = engine;
            CHECK(sidesRepeat(look));
            CHECK(sunDirWorld(look).z == doctest::Approx(std::sin(glm::radians(kept))));
        }
        look.engine = Engine::slicing;
        CHECK_FALSE(sidesRepeat(look));
        CHECK(sunDirWorld(look).z == doctest::Approx(std::sin(glm::radians(elevationDeg))));
    }
    look.engine = Engine::march;
    look.domainSides = DomainSides::open;
    CHECK_FALSE(sidesRepeat(look));
}
