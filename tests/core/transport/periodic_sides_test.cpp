// periodic_sides_test.cpp: what the work on light does with sides beyond which the medium repeats.
// How right the solver's light between them is, slab_test.cpp has.
#include <doctest/doctest.h>

#include <numeric>

#include "core/transport/light_work.h"
#include "tests/core/transport/transport_slab.h"

using namespace neph;

namespace {

double sumOf(const Array3f& values) {
    return std::accumulate(values.values.begin(), values.values.end(), 0.0);
}

/// The medium with every column further east, and what leaves in the east in the west again.
LightMedium movedEast(const LightMedium& medium, int nodes) {
    LightMedium moved = medium;
    for (std::size_t c = 0; c < medium.classes.size(); ++c) {
        const Array3f& from = medium.classes[c].extinctionPerM;
        for (int k = 0; k < from.size.z; ++k)
            for (int j = 0; j < from.size.y; ++j)
                for (int i = 0; i < from.size.x; ++i) {
                    moved.classes[c].extinctionPerM.at((i + nodes) % from.size.x, j, k) =
                        from.at(i, j, k);
                }
    }
    return moved;
}

std::shared_ptr<const LightState> firstLight(const LightMedium& medium) {
    LightWork work;
    LightRequest request;
    request.medium = std::make_shared<const LightMedium>(medium);
    request.towardsSun = glm::normalize(glm::dvec3(-2.0, 0.5, 1.0));
    request.groundAlbedo = 0.2;
    request.periodicSides = true;
    work.ask(request);
    return work.wait(false, {});
}

}  // namespace

TEST_CASE("Between periodic sides half the nodes hold as much of the medium") {
    const LightMedium fine = transportClouds({12, 10, 9});
    const LightMedium coarse = halved(fine, true);
    CHECK(coarse.nodes == glm::ivec3(6, 5, 5));
    CHECK(coarse.spacingM == 2.0 * fine.spacingM);
    for (std::size_t c = 0; c < fine.classes.size(); ++c) {
        CHECK(8.0 * sumOf(coarse.classes[c].extinctionPerM) ==
              doctest::Approx(sumOf(fine.classes[c].extinctionPerM)).epsilon(1e-5));
    }
    CHECK(glm::ivec2(halved(transportClouds({11, 10, 9}), true).nodes) == glm::ivec2(11, 5));
}

TEST_CASE("A periodic field starts beyond the last coarse node from the first one") {
    const LightMedium fine = transportClouds({8, 8, 6}, 0.2f);
    LightScene scene;
    scene.periodicSides = true;
    LightSettings settings;
    settings.threads = 1;
    LightSolver coarse(halved(fine, true), scene, settings), solver(fine, scene, settings);
    coarse.cycle();
    solver.startFrom(coarse);
    const TransportGrid &from = coarse.level().grid, &to = solver.level().grid;
    for (int j = 0; j < to.nodes.y; j += 2) {
        const auto flux = [&](int i) { return coarse.groundFlux()[from.index(i, j / 2, 0)]; };
        CHECK(solver.groundFlux()[to.index(7, j, 0)] ==
              doctest::Approx(0.5f * (flux(3) + flux(0))));
    }
}

// Moved by nodes of all grids, which else converge differently.
TEST_CASE("Where between periodic sides a cloud lies makes no difference") {
    const LightMedium clouds = transportClouds({8, 8, 6}, 3.0f);
    const auto here = firstLight(clouds), there = firstLight(movedEast(clouds, 4));
    REQUIRE(here->groundFlux[0].size() == there->groundFlux[0].size());
    for (std::size_t i = 0; i < here->groundFlux[0].size(); ++i) {
        const std::size_t moved = i / 8 * 8 + (i % 8 + 4) % 8;
        CHECK(there->groundFlux[0][moved] == doctest::Approx(here->groundFlux[0][i]).epsilon(1e-3));
    }
}

TEST_CASE("The same nodes with other sides have other light, also where it may start warm") {
    LightWork work;
    LightRequest request;
    request.medium = std::make_shared<const LightMedium>(transportClouds({8, 8, 6}));
    request.towardsSun = glm::normalize(glm::dvec3(-2.0, 0.5, 1.0));
    request.warm = true;
    work.ask(request);
    const auto open = work.wait(false, {});
    request.periodicSides = true;
    work.ask(request);
    const auto periodic = work.wait(false, {});
    CHECK(periodic->request.periodicSides);
    CHECK(open->groundFlux[0] != periodic->groundFlux[0]);
}
