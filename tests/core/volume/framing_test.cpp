// framing_test.cpp: what is seen of a volume is in the image, and fills it.
#include "core/volume/framing.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace neph;

namespace {

constexpr glm::ivec3 kSkySize{40, 30, 20};

Array3f& fieldOf(SpeciesVolume& volume, Species s) {
    return volume.contentKgPerM3[static_cast<std::size_t>(s)];
}

/// 60 km by 45 km by 10 km, without cloud.
SpeciesVolume emptySky() {
    SpeciesVolume volume;
    volume.grid = {kSkySize, {0.0, 0.0, 0.0}, {1500.0, 1500.0, 500.0}};
    fieldOf(volume, Species::cloud) = Array3f(kSkySize);
    fieldOf(volume, Species::rain) = Array3f(kSkySize);
    return volume;
}

/// How far the corners of a box reach in the image, 1 at its edge.
double reach(const Camera& camera, const BoxM& box) {
    double most = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p{(corner & 1) != 0 ? box.upperM.x : box.lowerM.x,
                           (corner & 2) != 0 ? box.upperM.y : box.lowerM.y,
                           (corner & 4) != 0 ? box.upperM.z : box.lowerM.z};
        const auto ndc = ndcOf(camera, p);
        REQUIRE(ndc.has_value());
        most = std::max({most, std::abs(ndc->x), std::abs(ndc->y)});
    }
    return most;
}

BoxM cellM(const RegularGrid& grid, glm::ivec3 cell) {
    const glm::dvec3 lower = grid.originM + glm::dvec3(cell) * grid.spacingM;
    return {lower, lower + grid.spacingM};
}

}  // namespace

TEST_CASE("All cloud is in the image and reaches its margin, from any side and in any format") {
    SpeciesVolume volume = emptySky();
    // A band across the domain: the box around it is much larger than what is seen.
    std::vector<glm::ivec3> cells;
    for (int i = 0; i < 28; ++i) cells.emplace_back(i + 6, i + 1, 4 + i / 4);
    for (const glm::ivec3 c : cells) fieldOf(volume, Species::cloud).at(c.x, c.y, c.z) = 1e-3f;
    const VolumeSummary shown = summarise(volume);
    for (const double aspect : {0.5, 16.0 / 9.0, 3.0}) {
        for (const float azimuthDeg : {10.0f, 135.0f, 246.0f}) {
            CAPTURE(aspect);
            CAPTURE(azimuthDeg);
            CameraPose pose;
            pose.azimuthDeg = azimuthDeg;
            pose = framed(View::fit, pose, shown, Look{}, aspect);
            const Camera camera = placeCamera(pose, shown.grid, aspect);
            double most = 0.0;
            for (const glm::ivec3 c : cells) {
                most = std::max(most, reach(camera, cellM(shown.grid, c)));
            }
            CHECK(most <= 0.9501);
            CHECK(most > 0.85);  // what one block is too large by
            CHECK(pose.azimuthDeg == azimuthDeg);
        }
    }
}

TEST_CASE("A domain of 6 km is seen from as near, for its size, as one of 600 km") {
    SpeciesVolume volume = emptySky();
    for (int x = 10; x < 14; ++x) fieldOf(volume, Species::cloud).at(x, 12, 5) = 1e-3f;
    volume.grid.spacingM = {150.0, 150.0, 50.0};
    const CameraPose small = framed(View::fit, {}, summarise(volume), Look{}, 1.5);
    volume.grid.spacingM *= 100.0;
    const CameraPose large = framed(View::fit, {}, summarise(volume), Look{}, 1.5);
    CHECK(small.distance == doctest::Approx(large.distance).epsilon(1e-4));
    CHECK(glm::length(small.target - large.target) < 1e-4f);
}

TEST_CASE("Drizzle too thin to be seen is not framed; a cloud of as much water is") {
    SpeciesVolume volume = emptySky();
    fieldOf(volume, Species::cloud).at(3, 4, 5) = 1e-5f;
    fieldOf(volume, Species::rain).at(30, 20, 2) = 1e-5f;  // 1.5 m²/kg: a path of 67 km
    const VolumeSummary shown = summarise(volume);
    REQUIRE(shown.seen.size() == 1);
    CHECK(shown.seen[0].box.lowerM == glm::dvec3(4500.0, 6000.0, 2500.0));
    CHECK(shown.seen[0].box.upperM == glm::dvec3(6000.0, 7500.0, 3000.0));
}

TEST_CASE("What the look hides is not framed, unless there is nothing else") {
    SpeciesVolume volume = emptySky();
    // In one block, and rain far away as well.
    fieldOf(volume, Species::cloud).at(6, 4, 5) = 1e-3f;
    fieldOf(volume, Species::rain).at(7, 5, 4) = 1e-2f;
    fieldOf(volume, Species::rain).at(30, 20, 2) = 1e-2f;
    const VolumeSummary shown = summarise(volume);
    const auto reached = [&](const Look& look, glm::ivec3 cell) {
        const CameraPose pose = framed(View::south, {}, shown, look, 1.5);
        return reach(placeCamera(pose, shown.grid, 1.5), cellM(shown.grid, cell));
    };
    const glm::ivec3 cloud(6, 4, 5), far(30, 20, 2);
    Look look;
    CHECK(reached(look, far) == doctest::Approx(0.95).epsilon(0.02));
    const CameraPose all = framed(View::south, {}, shown, look, 1.5);
    look.of(Species::rain).visible = false;
    CHECK(reached(look, cloud) == doctest::Approx(0.95).epsilon(0.02));
    CHECK(reached(look, far) > 2.0);
    look.of(Species::rain).visible = true;
    look.of(Species::rain).mixingScale = 0.0f;
    CHECK(reached(look, cloud) == doctest::Approx(0.95).epsilon(0.02));
    look.of(Species::cloud).visible = false;
    CHECK(framed(View::south, {}, shown, look, 1.5) == all);
}

TEST_CASE("Where there is no cloud the whole domain is framed") {
    const VolumeSummary shown = summarise(emptySky());
    CHECK(shown.seen.empty());
    const CameraPose pose = framed(View::south, {}, shown, Look{}, 2.0);
    const Camera camera = placeCamera(pose, shown.grid, 2.0);
    CHECK(reach(camera, {shown.grid.originM, shown.grid.upperM()}) ==
          doctest::Approx(0.95).epsilon(1e-4));
}
