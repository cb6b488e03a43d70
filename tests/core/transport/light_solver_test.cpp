// light_solver_test.cpp: what any solution of the transfer of light must satisfy.
#include "core/transport/light_solver.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "core/transport/scattered_radiance.h"
#include "tests/core/transport/transport_slab.h"

using namespace neph;

namespace {

const glm::dvec3 kHighSun = glm::normalize(glm::dvec3(0.3, -0.2, 0.8));

LightScene sunScene(const glm::dvec3& towardsSun = kHighSun) {
    LightScene scene;
    scene.towardsSun = towardsSun;
    scene.groundAlbedo = 0.2;
    return scene;
}

/// Nothing but light: a sky of radiance 1 over ground that reflects all.
LightScene furnaceScene(bool periodicSides) {
    LightScene scene;
    scene.source = LightSource::sky;
    scene.groundAlbedo = 1.0;
    scene.periodicSides = periodicSides;
    return scene;
}

/// Largest departure from radiance 1 in every direction, relative, and of the flux at the ground.
double fromFurnace(const LightSolver& solver) {
    const double exact = std::sqrt(4.0 * std::numbers::pi);
    double most = 0.0;
    const auto count = static_cast<std::size_t>(solver.momentCount());
    for (std::size_t i = 0; i < solver.field().moments.size(); ++i) {
        const double value = static_cast<double>(solver.field().moments[i]) / exact;
        most = std::max(most, std::abs(value - (i % count == 0 ? 1.0 : 0.0)));
    }
    for (const float flux : solver.groundFlux()) {
        most = std::max(most, std::abs(static_cast<double>(flux) / std::numbers::pi - 1.0));
    }
    return most;
}

/// Root mean square of the difference of l = 0 over that of the field.
double difference(const LightSolver& a, const LightSolver& b) {
    double spread = 0.0, whole = 0.0;
    const auto count = static_cast<std::size_t>(a.momentCount());
    for (std::size_t i = 0; i < a.field().moments.size(); i += count) {
        const auto x = static_cast<double>(a.field().moments[i]);
        const auto y = static_cast<double>(b.field().moments[i]);
        spread += (x - y) * (x - y);
        whole += x * x;
    }
    return std::sqrt(spread / whole);
}

LightSolver solvedAfter(const LightMedium& medium, const LightScene& scene,
                        const LightSettings& settings, int cycles) {
    LightSolver solver(medium, scene, settings);
    for (int i = 0; i < cycles; ++i) solver.cycle();
    return solver;
}

}  // namespace

TEST_CASE("transport: in a white furnace every field comes to radiance 1 and stays there" *
          doctest::skip(!kSolvesInSeconds)) {
    for (const bool periodic : {false, true}) {
        for (const bool aligned : {false, true}) {
            CAPTURE(periodic);
            CAPTURE(aligned);
            LightSettings settings;
            settings.aligned = aligned;
            settings.coldCycles = 60;
            const LightSolver solver =
                solvedAfter(transportClouds({12, 10, 14}), furnaceScene(periodic), settings, 60);
            CHECK(fromFurnace(solver) < 1e-5);
        }
    }
}

TEST_CASE("transport: the same seed gives the same field, another a field close to it") {
    const LightMedium medium = transportClouds({14, 12, 13});
    LightSettings settings;
    for (const bool aligned : {false, true}) {
        settings.aligned = aligned;
        settings.seed = 7;
        const LightSolver first = solvedAfter(medium, sunScene(), settings, 12);
        CHECK(first.field().moments ==
              solvedAfter(medium, sunScene(), settings, 12).field().moments);
        settings.seed = 8;
        const LightSolver other = solvedAfter(medium, sunScene(), settings, 12);
        CHECK(difference(first, other) > 0.0);
        CHECK(difference(first, other) < 0.1);
        CHECK(first.chance() > 0.0);
        CHECK(first.chance() < 0.1);
    }
}

TEST_CASE("transport: a warm start ends where a cold one does" * doctest::skip(!kSolvesInSeconds)) {
    const LightMedium medium = transportClouds({14, 12, 13});
    const glm::dvec3 moved = glm::normalize(glm::dvec3(0.5, -0.2, 0.6));
    for (const bool aligned : {false, true}) {
        LightSettings settings;
        settings.aligned = aligned;
        LightSolver warm = solvedAfter(medium, sunScene(), settings, 8);
        warm.restart(sunScene(moved));
        CHECK(warm.cyclesDone() == 0);
        for (int i = 0; i < 60; ++i) warm.cycle();
        const LightSolver cold = solvedAfter(medium, sunScene(moved), settings, 60);
        CHECK(difference(cold, warm) < 0.01);
    }
}

TEST_CASE("transport: a sun that is dimmer by a third in every layer gives a third less light") {
    const LightMedium medium = transportClouds({8, 8, 9});
    LightScene dim = sunScene();
    dim.sunByLayer.assign(9, 2.0f / 3.0f);
    const LightSolver whole = solvedAfter(medium, sunScene(), {}, 6);
    const LightSolver less = solvedAfter(medium, dim, {}, 6);
    for (std::size_t i = 0; i < whole.field().moments.size(); ++i) {
        const double expected = 2.0 / 3.0 * static_cast<double>(whole.field().moments[i]);
        CHECK(less.field().moments[i] == doctest::Approx(expected).epsilon(1e-3).scale(1e-3));
    }
}

TEST_CASE("transport: sunlight that the air keeps from lower layers does not reach the ground") {
    LightScene scene = sunScene();
    scene.groundAlbedo = 1.0;
    scene.sunByLayer.assign(9, 1.0f);
    scene.sunByLayer[0] = 0.0f;
    const LightMedium nothing = [] {
        LightMedium medium = transportClouds({8, 8, 9});
        for (LightClass& light : medium.classes) {
            std::ranges::fill(light.extinctionPerM.values, 0.0f);
        }
        // A little at the top, where the ground would be seen.
        medium.classes[0].extinctionPerM.at(4, 4, 7) = 1e-6f;
        return medium;
    }();
    const LightSolver solver = solvedAfter(nothing, scene, {}, 4);
    for (const float moment : solver.field().moments) CHECK(std::abs(moment) < 1e-3f);
}

TEST_CASE("transport: a dome of one radiance is a sky of one radiance") {
    auto dome = std::make_shared<SkyDome>();
    for (SkyPattern& pattern : dome->patterns) {
        pattern.radiance.assign(static_cast<std::size_t>(24 * 24), 1.0f);
    }
    LightScene plain = furnaceScene(false), domed = furnaceScene(false);
    plain.groundAlbedo = domed.groundAlbedo = 0.3;
    domed.sky.dome = dome;
    domed.sky.pattern = 1;
    const LightMedium medium = transportClouds({8, 8, 9});
    const LightSolver a = solvedAfter(medium, plain, {}, 6), b = solvedAfter(medium, domed, {}, 6);
    CHECK(difference(a, b) < 1e-4);
    CHECK(domed.sky.irradiance() == doctest::Approx(plain.sky.irradiance()).epsilon(1e-4));
}

TEST_CASE("transport: multigrid ends where sweeps alone do") {
    const LightMedium medium = transportClouds({10, 9, 11});
    LightSettings with, without;
    without.levels = 1;
    without.coldCycles = 200;
    const LightSolver slow = solvedAfter(medium, sunScene(), without, 300);
    const LightSolver fast = solvedAfter(medium, sunScene(), with, 100);
    CHECK(difference(slow, fast) < 0.03);  // of which chance is two thirds
}

TEST_CASE(
    "transport: a sun below the horizon lights clouds as one above does, and not the ground") {
    const auto totalOf = [](double up, double groundAlbedo) {
        LightScene scene = sunScene(glm::normalize(glm::dvec3(1.0, 0.0, up)));
        scene.groundAlbedo = groundAlbedo;
        const LightSolver solver = solvedAfter(transportClouds({8, 8, 9}), scene, {}, 8);
        double sum = 0.0;
        for (const float moment : solver.field().moments) {
            sum += static_cast<double>(std::abs(moment));
        }
        return sum;
    };
    CHECK(totalOf(-0.02, 0.0) == doctest::Approx(totalOf(0.02, 0.0)).epsilon(0.1));
    CHECK(totalOf(-0.02, 0.9) > totalOf(-0.02, 0.0));  // what clouds send down comes back
}

TEST_CASE("transport: where there is nothing light goes straight to the ground") {
    LightMedium medium = transportClouds({8, 8, 9});
    for (LightClass& light : medium.classes) std::ranges::fill(light.extinctionPerM.values, 0.0f);
    LightScene scene = sunScene();
    const LightSolver sun = solvedAfter(medium, scene, {}, 1);
    CHECK(sun.field().moments.empty());
    CHECK(std::ranges::all_of(sun.groundBeam(), [](float e) { return e == 1.0f; }));
    CHECK(std::ranges::all_of(sun.groundFlux(), [](float f) { return f == 0.0f; }));
    scene.source = LightSource::sky;
    const LightSolver sky = solvedAfter(medium, scene, {}, 1);
    for (const float flux : sky.groundFlux()) {
        CHECK(flux == doctest::Approx(std::numbers::pi).epsilon(1e-5));
    }
}

TEST_CASE("transport: what an eye sees of a white furnace is as bright as the furnace") {
    const LightMedium medium = transportClouds({12, 10, 14});
    LightSettings settings;
    settings.coldCycles = 60;
    const LightSolver solver = solvedAfter(medium, furnaceScene(false), settings, 60);
    const std::vector<PhaseOfCosine> phases(2, [](float) { return 1.0f; });  // no sun, no matter
    const auto [atM, extinction] = thickestNode(solver);
    for (const glm::dvec3& view : {glm::dvec3(0, 0, 1), glm::dvec3(0.6, 0.0, -0.8)}) {
        const double radiance = scatteredRadiancePerM(solver, medium, phases, atM, view);
        CHECK(radiance == doctest::Approx(extinction).epsilon(1e-4));
    }
}

TEST_CASE("transport: a solver takes at most 150 bytes a node where clouds fill a third") {
    LightMedium medium = transportClouds({48, 48, 24});
    for (LightClass& light : medium.classes) {
        for (int k = 0; k < 24; ++k) {
            for (int j = 0; j < 48; ++j) {
                for (int i = 19; i < 48; ++i) light.extinctionPerM.at(i, j, k) = 0.0f;
            }
        }
    }
    LightSettings settings;
    settings.aligned = true;
    const LightSolver solver(medium, sunScene(), settings);
    const auto nodes = static_cast<double>(solver.level().place.size());
    CHECK(static_cast<double>(solver.level().activeCount) / nodes > 0.33);
    CHECK(static_cast<double>(solver.bytes()) / nodes < 150.0);
}
