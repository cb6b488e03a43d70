// light_around_test.cpp: what clouds change of the light around them, where it is known.
#include "core/transport/light_around.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/core/transport/transport_slab.h"

using namespace neph;

namespace {

/// A block of cloud in the middle of 33 x 33 x 21 nodes, 200 m apart, from 1.2 to 2 km.
LightMedium blockOfCloud(double extinctionPerM) {
    TransportSlab slab;
    slab.nodes = {33, 33, 21};
    LightMedium medium = slab.medium();
    medium.spacingM = glm::dvec3(200.0);
    Array3f& cloud = medium.classes[0].extinctionPerM;
    cloud = Array3f(slab.nodes, 0.0f);
    for (int z = 6; z <= 10; ++z)
        for (int y = 10; y < 23; ++y)
            for (int x = 10; x < 23; ++x) cloud.at(x, y, z) = static_cast<float>(extinctionPerM);
    return medium;
}

LightAround solvedAround(const LightMedium& medium, const LightScene& scene) {
    LightSolver solver(medium, scene, {.aligned = true, .threads = 1});
    for (int cycle = 0; cycle < 6; ++cycle) solver.cycle();
    return lightAround(solver, 60000);
}

/// Of the sphere, which a square covers as seen from below its middle.
double shareOfSquare(double halfM, double belowM) {
    const double sine = halfM / std::hypot(halfM, belowM);
    return std::asin(sine * sine) / std::numbers::pi;
}

/// Change of the mean radiance at a node.
double meanChange(const LightAround& around, std::size_t node) {
    return static_cast<double>(around.change[node * kBroadMoments]) /
           std::sqrt(4.0 * std::numbers::pi);
}

/// At a height in the middle of a level, m.
double changeInMiddle(const LightAround& around, double heightM) {
    const TransportGrid& grid = around.grid;
    const auto layer = static_cast<int>(std::lround(heightM / grid.spacingM.z));
    return meanChange(around, grid.index(grid.nodes.x / 2, grid.nodes.y / 2, layer));
}

}  // namespace

TEST_CASE("Clouds that absorb nothing change no light that comes from everywhere alike") {
    LightScene furnace;
    furnace.source = LightSource::sky;
    furnace.groundAlbedo = 1.0;
    const LightAround around = solvedAround(blockOfCloud(5e-3), furnace);
    CHECK(around.change.size() == kBroadMoments * around.grid.nodeCount());
    for (const float change : around.change) CHECK(std::abs(change) < 0.06f);
}

TEST_CASE("A black cloud takes the part of the sky that it covers") {
    LightScene scene;
    scene.source = LightSource::sky;
    LightMedium medium = blockOfCloud(0.05);
    medium.classes[0].singleScattering = 0.0;
    const LightAround around = solvedAround(medium, scene);
    const double change = changeInMiddle(around, 0.0);
    CHECK(-change > shareOfSquare(1200.0, 1200.0));
    CHECK(-change < shareOfSquare(1400.0, 1000.0));  // between nodes it thins out
    // Above it the ground is dark anyway.
    CHECK(std::abs(changeInMiddle(around, 3600.0)) < 0.01);
}

TEST_CASE("A sunlit cloud lights the air above it") {
    LightScene scene;
    scene.towardsSun = {0.6, 0.0, 0.8};
    const LightMedium medium = blockOfCloud(0.02);
    const LightAround bright = solvedAround(medium, scene);
    // Below is a square of cloud, of whose light, 0.8, half to all goes up in all directions alike.
    const double above = changeInMiddle(bright, 3200.0);
    CHECK(above > 0.5 * 0.8 / std::numbers::pi * shareOfSquare(1200.0, 1200.0));
    CHECK(above < 0.8 / std::numbers::pi * shareOfSquare(1400.0, 1000.0));
    // Farther away there is less of it.
    const auto corner = meanChange(bright, bright.grid.nodeCount() - 1);
    CHECK(corner > 0.0);
    CHECK(corner < 0.3 * above);
}

TEST_CASE("Where there is no medium nothing changes the light") {
    LightScene scene;
    scene.towardsSun = {0.6, 0.0, 0.8};
    scene.groundAlbedo = 0.3;
    const LightAround around = solvedAround(blockOfCloud(0.0), scene);
    for (const float change : around.change) CHECK(std::abs(change) < 1e-3f);
}
