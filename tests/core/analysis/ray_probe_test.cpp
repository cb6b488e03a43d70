// ray_probe_test.cpp: slabs of known extinction along a ray.
#include "core/analysis/ray_probe.h"

#include <doctest/doctest.h>

#include <cmath>

#include "core/volume/optical_depth.h"

using namespace neph;

namespace {

/// Cloud in the cells of x 10 to 19 and rain in those of 20 to 29, 100 m each, of extinctions 1e-3
/// and 4e-3 per m.
SpeciesVolume slabs() {
    SpeciesVolume volume;
    volume.grid = {{40, 8, 8}, {0.0, 0.0, 0.0}, {100.0, 100.0, 100.0}};
    for (const Species s : {Species::cloud, Species::rain}) {
        auto& held = volume.extinctionPerM[static_cast<std::size_t>(s)];
        held = Array3f(volume.grid.size);
        const int from = s == Species::cloud ? 10 : 20;
        for (int z = 0; z < 8; ++z) {
            for (int y = 0; y < 8; ++y) {
                for (int x = from; x < from + 10; ++x) {
                    held.at(x, y, z) = s == Species::cloud ? 1e-3f : 4e-3f;
                }
            }
        }
    }
    return volume;
}

MediumPlan plain() {
    MediumPlan plan;
    for (const Species s : {Species::cloud, Species::rain}) {
        plan.extinctionPerHeld[static_cast<std::size_t>(s)] = 1.0f;
    }
    return plan;
}

}  // namespace

TEST_CASE("A ray says where it meets cloud, where it sees no further, and whose light that is") {
    const SpeciesVolume volume = slabs();
    const glm::dvec3 eye(-500.0, 400.0, 400.0), east(1.0, 0.0, 0.0);
    const RayProbe probe = probeRay(volume, plain(), eye, east);
    CHECK(probe.depth == doctest::Approx(5.0).epsilon(1e-3));
    CHECK(probe.depth ==
          doctest::Approx(opticalDepthAlong(volume, plain(), eye, east).total()).epsilon(1e-3));
    REQUIRE(probe.metM);
    // 0.05 deep: 50 m within the cloud, whose edge is a ramp of a cell's width around 1 km.
    CHECK(probe.metM->x == doctest::Approx(1050.0).epsilon(0.01));
    REQUIRE(probe.opaqueM);
    CHECK(probe.opaqueM->x == doctest::Approx(2500.0).epsilon(0.01));
    CHECK(probe.depths[0] == doctest::Approx(1.0).epsilon(1e-3));
    CHECK(probe.depths[2] == doctest::Approx(4.0).epsilon(1e-3));
    // What is behind the cloud is dimmed by it.
    const double cloud = 1.0 - std::exp(-1.0), rain = std::exp(-1.0) - std::exp(-5.0);
    CHECK(probe.seen[0] == doctest::Approx(cloud / (cloud + rain)).epsilon(0.01));
    CHECK(probe.seen[2] == doctest::Approx(rain / (cloud + rain)).epsilon(0.01));
    CHECK(probe.extinctionPerM[0] > 0.0);
    CHECK(probe.extinctionPerM[2] == 0.0);
}

TEST_CASE("A ray beside all cloud meets none") {
    const SpeciesVolume volume = slabs();
    const RayProbe up = probeRay(volume, plain(), {500.0, 400.0, -10.0}, {0.0, 0.0, 1.0});
    CHECK(up.depth == 0.0);
    CHECK_FALSE(up.metM);
    const RayProbe away = probeRay(volume, plain(), {-500.0, 400.0, 400.0}, {-1.0, 0.0, 0.0});
    CHECK(away.depth == 0.0);
    MediumPlan none;
    CHECK(probeRay(volume, none, {-500.0, 400.0, 400.0}, {1.0, 0.0, 0.0}).depth == 0.0);
}
