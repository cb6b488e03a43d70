// thick_test.cpp: media whose nodes are optically thick. docs/transport.md
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/transport/beam.h"
#include "core/transport/scattered_radiance.h"
#include "tests/core/transport/transport_slab.h"

using namespace neph;

namespace {

constexpr double kThickG = 0.85;

/// A layer of `layers` nodes between empty ones, as wide cells as a storm's.
LightMedium thickLayer(double opticalDepth, int layers) {
    LightMedium medium;
    medium.nodes = {4, 4, layers + 4};
    medium.spacingM = {1000.0, 1000.0, 400.0};
    LightClass light;
    light.extinctionPerM = Array3f(medium.nodes);
    for (std::size_t l = 0; l < light.moments.size(); ++l) light.moments[l] = std::pow(kThickG, l);
    const auto extinction = static_cast<float>(opticalDepth / (layers * medium.spacingM.z));
    for (int k = 2; k < layers + 2; ++k) {
        for (int j = 0; j < 4; ++j) {
            for (int i = 0; i < 4; ++i) light.extinctionPerM.at(i, j, k) = extinction;
        }
    }
    medium.classes.push_back(std::move(light));
    return medium;
}

LightScene overhead(double sine) {
    LightScene scene;
    scene.periodicSides = true;
    scene.towardsSun = {std::sqrt(1.0 - sine * sine), 0.0, sine};
    return scene;
}

LightSolver solvedLayer(double opticalDepth, int layers, double sine, int cycles) {
    LightSettings settings;
    settings.coldCycles = cycles / 2;
    LightSolver solver(thickLayer(opticalDepth, layers), overhead(sine), settings);
    for (int i = 0; i < cycles; ++i) solver.cycle();
    return solver;
}

/// Diffusion: what passes goes as 1 / ((1 - g) tau + 1.4209), the factor from adding and doubling
/// of a layer of 64.
double expectedTransmission(double opticalDepth, double sine) {
    const double ofLayer64 = sine == 1.0 ? 0.15371913 : 0.10503029;
    const double scaled = (1.0 - kThickG) * opticalDepth;
    return ofLayer64 * ((1.0 - kThickG) * 64.0 + 1.4209) / (scaled + 1.4209);
}

}  // namespace

TEST_CASE("transport: thick layers of a few nodes pass as much as the diffusion limit says" *
          doctest::skip(!kSolvesInSeconds)) {
    struct Row {
        double opticalDepth;
        int layers;
    };
    for (const Row& row : {Row{18, 4}, Row{90, 4}, Row{90, 10}, Row{451, 4}, Row{451, 10}}) {
        for (const double sine : {1.0, 0.5}) {
            CAPTURE(row.opticalDepth);
            CAPTURE(row.layers);
            CAPTURE(sine);
            const LightSolver solver = solvedLayer(row.opticalDepth, row.layers, sine, 60);
            REQUIRE_FALSE(solver.balanced().empty());
            double passed = 0.0, back = 0.0;
            const std::size_t above = static_cast<std::size_t>(row.layers + 2) * 16;
            for (std::size_t i = 0; i < 16; ++i) {
                passed += static_cast<double>(solver.groundFlux()[i]) / sine / 16.0 +
                          static_cast<double>(solver.groundBeam()[i]) / 16.0;
                back += std::sqrt(4.0 * std::numbers::pi / 3.0) / sine / 16.0 *
                        static_cast<double>(solver.momentsAt(above + i)[2]);
            }
            const double expected = expectedTransmission(row.opticalDepth, sine);
            CHECK(passed == doctest::Approx(expected).epsilon(0.05));
            CHECK(passed + back == doctest::Approx(1.0).epsilon(0.02));
        }
    }
}

TEST_CASE("transport: the beam leaves in thick nodes what it loses") {
    const LightMedium medium = thickLayer(200.0, 5);
    for (const double sine : {1.0, 0.5}) {
        const LightSolver solver(medium, overhead(sine), {});
        const TransportLevel& level = solver.level();
        double lost = 0.0;
        for (std::size_t node = 0; node < level.place.size(); node += 16) {
            if (level.place[node] < 0) continue;
            CHECK(solver.balanced()[node] == 1.0f);
            lost +=
                static_cast<double>(solver.beam()[node] * level.weightAt(node)) * medium.spacingM.z;
        }
        CHECK(lost == doctest::Approx(sine).epsilon(1e-3));
        CHECK(solver.underResolved() == doctest::Approx(1.0));
    }
}

TEST_CASE("transport: depths are exact along any ray through a trilinear medium") {
    // In extinction x y z along a line all is a cubic, whose integral is known.
    LightMedium medium;
    medium.nodes = {4, 4, 4};
    medium.spacingM = {10.0, 10.0, 10.0};
    LightClass light;
    light.extinctionPerM = Array3f(medium.nodes);
    for (int k = 0; k < 4; ++k) {
        for (int j = 0; j < 4; ++j) {
            for (int i = 0; i < 4; ++i) {
                light.extinctionPerM.at(i, j, k) = 1e-4f * static_cast<float>(i * j * k);
            }
        }
    }
    medium.classes.push_back(std::move(light));
    const TransportLevel level = finestLevel(medium, false, false, kBroadMoments);
    const glm::dvec3 from(1.0, 2.0, 0.5);
    const glm::dvec3 towards = glm::normalize(glm::dvec3(0.6, 0.5, 0.9));
    const double length =
        std::min((30.0 - from.x) / towards.x,
                 std::min((30.0 - from.y) / towards.y, (30.0 - from.z) / towards.z));
    double expected = 0.0;
    constexpr int kSteps = 20000;
    for (int i = 0; i < kSteps; ++i) {
        const glm::dvec3 at = (from + towards * ((i + 0.5) / kSteps * length)) / 10.0;
        expected += 1e-4 * at.x * at.y * at.z * length / kSteps;
    }
    CHECK(depthTowards(level, from, towards) == doctest::Approx(expected).epsilon(1e-4));
}

TEST_CASE("transport: the white furnace stays white in thick clouds" *
          doctest::skip(!kSolvesInSeconds)) {
    const LightMedium medium = transportClouds({9, 8, 10}, 20.0f);
    LightScene scene;
    scene.source = LightSource::sky;
    scene.groundAlbedo = 1.0;
    for (const bool aligned : {false, true}) {
        CAPTURE(aligned);
        LightSettings settings;
        settings.aligned = aligned;
        settings.coldCycles = 400;
        LightSolver solver(medium, scene, settings);
        for (int i = 0; i < 400; ++i) solver.cycle();
        REQUIRE_FALSE(solver.balanced().empty());
        const double exact = std::sqrt(4.0 * std::numbers::pi);
        double most = 0.0;
        for (std::size_t i = 0; i < solver.field().moments.size(); ++i) {
            const double value = static_cast<double>(solver.field().moments[i]) / exact;
            most = std::max(most, std::abs(value - (i % kBroadMoments == 0 ? 1.0 : 0.0)));
        }
        CHECK(most < 1e-5);
        const std::vector<PhaseOfCosine> phases(2, [](float) { return 1.0f; });  // no sun
        const ThickestNode thickest = thickestNode(solver);
        const double radiance =
            scatteredRadiancePerM(solver, medium, phases, thickest.atM, {0.6, 0.0, -0.8});
        CHECK(radiance == doctest::Approx(thickest.extinctionPerM).epsilon(1e-3));
    }
}

TEST_CASE("transport: thick clouds that absorb converge as fast as those that do not") {
    LightMedium medium = transportClouds({20, 18, 16}, 5.0f);
    for (const double albedo : {1.0, 0.9, 0.8, 0.5}) {
        CAPTURE(albedo);
        for (LightClass& light : medium.classes) light.singleScattering = albedo;
        LightSolver solver(medium, overhead(0.8), {});
        for (int i = 0; i < 12; ++i) solver.cycle();
        REQUIRE_FALSE(solver.balanced().empty());
        CHECK(solver.remaining() > 0.0);  // 0 of what is not a number
        CHECK(solver.remaining() < 0.1);
    }
}

TEST_CASE("transport: thin media keep the cheap cycle, and nothing of them is under-resolved") {
    const LightSolver solver(transportClouds({10, 9, 11}), overhead(0.8), {});
    CHECK(solver.balanced().empty());
    CHECK(solver.underResolved() == 0.0);
    CHECK(solver.thickness().size() == solver.beam().size());
}

TEST_CASE("transport: more and more of a phase function counts as forward as nodes grow thicker") {
    LightMedium medium = thickLayer(1.0, 2);
    const LightClass& light = medium.classes[0];
    CHECK(lightThickness(medium, 1.0 / 1000.0) == 0.0);
    CHECK(lightThickness(medium, 4.0 / 1000.0) == doctest::Approx(1.0));
    CHECK(lightThickness(medium, 10.0 / 1000.0) == doctest::Approx(1.0));
    CHECK(lightThickness(medium, 30.0 / 1000.0) == doctest::Approx(2.0));
    for (const bool aligned : {false, true}) {
        CHECK(forwardShare(light, aligned, 0.0) ==
              doctest::Approx(std::pow(kThickG, aligned ? 5 : 3)));
        CHECK(forwardShare(light, aligned, 1.0) == doctest::Approx(std::pow(kThickG, 3)));
        CHECK(forwardShare(light, aligned, 2.0) == doctest::Approx(kThickG));
    }
    const ScaledOptics scaled = scaledOptics(light, 0.03, false, 2.0);
    CHECK(scaled.extinctionPerM == doctest::Approx(0.03 * (1.0 - kThickG)));
    CHECK(scaled.scatteringPerM[0] == doctest::Approx(scaled.extinctionPerM));
    for (std::size_t l = 1; l < scaled.scatteringPerM.size(); ++l) {
        CHECK(scaled.scatteringPerM[l] == doctest::Approx(0.0));
    }
    // Nodes are measured by their height where they are flatter than a storm's.
    medium.spacingM = {400000.0, 400000.0, 400.0};
    CHECK(lightThickness(medium, 4.0 / 1000.0) == doctest::Approx(1.0));
}
