// furnace_test.cpp: moments about the sun, of which the solver has none under a sky, in a white
// furnace. docs/transport.md
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/transport/balance.h"
#include "core/transport/multigrid.h"
#include "tests/core/transport/transport_slab.h"

using namespace neph;

namespace {

const glm::dvec3 kSunTravel = -glm::normalize(glm::dvec3(0.6, -0.2, 0.4));
const double kWhiteMoment = std::sqrt(4.0 * std::numbers::pi);  ///< moment 0 of radiance 1

/// Clouds under a sky of radiance 1 over ground that reflects all, in moments about a sun without
/// light.
struct Furnace {
    std::vector<TransportLevel> levels;
    DirectionSource source{5};

    Furnace(const LightMedium& medium, bool periodicSides) {
        levels.push_back(finestLevel(medium, periodicSides, true, kAlignedMoments));
        while (levels.size() < 3 && canCoarsen(levels.back().grid)) {
            levels.push_back(coarsened(levels.back()));
        }
    }
    LightField white() const {
        LightField field = levels.front().emptyField();
        for (std::size_t i = 0; i < field.moments.size(); i += kAlignedMoments) {
            field.moments[i] = static_cast<float>(kWhiteMoment);
        }
        std::ranges::fill(field.groundFlux, static_cast<float>(std::numbers::pi));
        return field;
    }
    Swept sweptOnce(const LightField& field, const LightDirections& directions) const {
        SweepInput input;
        input.level = &levels.front();
        input.field = &field;
        input.sunTravel = kSunTravel;
        input.sky = {1.0, 1.0};
        input.farGroundRadiance = 1.0f;
        for (const float flux : field.groundFlux) {
            input.groundRadiance.push_back(flux / static_cast<float>(std::numbers::pi));
        }
        return swept(input, directions, 2);
    }
    /// As LightSolver does it.
    void cycle(LightField& field) {
        const LightDirections rings = source.rings(kSunTravel);
        LightField next = sweptOnce(field, rings).field;
        correctByMultigrid(levels, {&rings, kSunTravel, 1.0, 2, 2}, field, next);
        field = std::move(next);
    }
};

double largestOf(const std::vector<float>& values) {
    double most = 0.0;
    for (const float value : values) most = std::max(most, static_cast<double>(std::abs(value)));
    return most;
}

/// Of every moment and of the ground, relative to radiance 1.
double departure(const LightField& field, const LightField& white) {
    std::vector<float> moments = field.moments, flux = field.groundFlux;
    for (std::size_t i = 0; i < moments.size(); ++i) moments[i] -= white.moments[i];
    for (std::size_t i = 0; i < flux.size(); ++i) flux[i] -= white.groundFlux[i];
    return std::max(largestOf(moments) / kWhiteMoment, largestOf(flux) / std::numbers::pi);
}

}  // namespace

TEST_CASE("transport: moments about the sun come to nothing in a white furnace" *
          doctest::skip(!kSolvesInSeconds)) {
    for (const bool periodic : {false, true}) {
        CAPTURE(periodic);
        Furnace furnace(transportClouds({8, 8, 9}), periodic);
        REQUIRE_FALSE(furnace.levels.front().thick());
        LightField field = furnace.levels.front().emptyField();
        for (int i = 0; i < 30; ++i) furnace.cycle(field);
        CHECK(departure(field, furnace.white()) < 1e-5);
    }
}

TEST_CASE("transport: one sweep along rings leaves a white furnace as it is, thin or thick") {
    for (const float scale : {1.0f, 20.0f}) {
        for (const bool periodic : {false, true}) {
            CAPTURE(scale);
            CAPTURE(periodic);
            Furnace furnace(transportClouds({10, 8, 11}, scale), periodic);
            const TransportLevel& fine = furnace.levels.front();
            CHECK(fine.thick() == (scale > 1.0f));
            const LightField white = furnace.white();
            for (int set = 0; set < 4; ++set) {
                const Swept sums = furnace.sweptOnce(white, furnace.source.rings(kSunTravel));
                if (fine.thick()) {
                    const LightField missing = missingFrom(fine, sums, white, nullptr);
                    CHECK(largestOf(missing.moments) / kWhiteMoment < 1e-5);
                    CHECK(largestOf(missing.groundFlux) / std::numbers::pi < 1e-5);
                } else {
                    CHECK(departure(sums.field, white) < 1e-5);
                }
            }
        }
    }
}
