// optical_depth_test.cpp: optical depth along a ray against closed forms.
#include "core/volume/optical_depth.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace neph;
using doctest::Approx;

namespace {

/// 4 x 5 x 6 cells of 1000 x 500 x 250 m, corner at (100, 200, 300) m; rain of 1 g/m³ everywhere.
SpeciesVolume uniformRain() {
    SpeciesVolume volume;
    volume.grid = {{4, 5, 6}, {100.0, 200.0, 300.0}, {1000.0, 500.0, 250.0}};
    volume.contentKgPerM3[static_cast<std::size_t>(Species::rain)] =
        Array3f(volume.grid.size, 1e-3f);
    return volume;
}

double rainAlong(const SpeciesVolume& volume, const glm::dvec3& eye, const glm::dvec3& dir) {
    const MediumPlan plan = planMedium(Look{}, volume.holdings(), volume.cellM());
    const OpticalDepth depth = opticalDepthAlong(volume, plan, eye, glm::normalize(dir));
    CHECK(depth.total() == depth.of[static_cast<std::size_t>(Species::rain)]);
    return depth.total();
}

// Rain of 1 mm and 1000 kg/m³: 3 / (2 r rho) = 1.5 m²/kg, so 1.5e-3 per metre.
constexpr double kPerM = 1.5e-3;

}  // namespace

TEST_CASE("Through a uniform box the optical depth is extinction times the way through it") {
    const SpeciesVolume volume = uniformRain();
    // East through 4 km, up through 1.5 km from below, and 1 km from inside of the box.
    CHECK(rainAlong(volume, {-5e3, 1e3, 1e3}, {1, 0, 0}) == Approx(kPerM * 4000.0));
    CHECK(rainAlong(volume, {1e3, 1e3, -9e3}, {0, 0, 1}) == Approx(kPerM * 1500.0));
    CHECK(rainAlong(volume, {3100.0, 1e3, 1e3}, {1, 0, 0}) == Approx(kPerM * 1000.0));
    // From corner to corner: sqrt(4000² + 2500² + 1500²) = 4949.75 m.
    const glm::dvec3 diagonal{4000.0, 2500.0, 1500.0};
    CHECK(rainAlong(volume, volume.grid.originM - diagonal, diagonal) ==
          Approx(kPerM * std::sqrt(4000.0 * 4000.0 + 2500.0 * 2500.0 + 1500.0 * 1500.0)));
    // Past it, away from it.
    CHECK(rainAlong(volume, {-5e3, 0.0, 1e3}, {1, 0, 0}) == 0.0);
    CHECK(rainAlong(volume, {-5e3, 1e3, 1e3}, {-1, 0, 0}) == 0.0);
}

TEST_CASE("A gradient along the ray is integrated exactly between the centres of the cells") {
    SpeciesVolume volume = uniformRain();
    Array3f& rain = volume.contentKgPerM3[static_cast<std::size_t>(Species::rain)];
    for (int z = 0; z < 6; ++z) {
        for (int y = 0; y < 5; ++y) {
            for (int x = 0; x < 4; ++x) rain.at(x, y, z) = 1e-3f * static_cast<float>(x);
        }
    }
    // Half a cell of 0, a ramp from 0 to 3 over 3 km, half a cell of 3: 4.5 + 1.5 = 6 g/m³ km.
    CHECK(rainAlong(volume, {-5e3, 1e3, 1e3}, {1, 0, 0}) == Approx(1.5 * 6.0).epsilon(1e-6));
}

TEST_CASE("Fields count with their scale and as they are held, and not when they are invisible") {
    SpeciesVolume volume = uniformRain();
    volume.extinctionPerM[static_cast<std::size_t>(Species::ice)] =
        Array3f(volume.grid.size, 2e-3f);
    Look look;
    look.of(Species::ice).mixingScale = 0.5f;
    const auto along = [&] {
        const MediumPlan plan = planMedium(look, volume.holdings(), volume.cellM());
        return opticalDepthAlong(volume, plan, {-5e3, 1e3, 1e3}, {1.0, 0.0, 0.0});
    };
    CHECK(along().of[static_cast<std::size_t>(Species::ice)] == Approx(4.0));
    CHECK(along().total() == Approx(10.0));
    look.of(Species::rain).visible = false;
    CHECK(along().total() == Approx(4.0));
}
