// light_grid_test.cpp: nodes among voxels.
#include <doctest/doctest.h>

#include "core/transport/light_grid.h"

using namespace neph;

namespace {

RegularGrid storm() {
    return {{110, 120, 60}, {0.0, 0.0, 0.0}, {1000.0, 1000.0, 335.0}};
}

glm::dvec3 nodeM(const LightGrid& grid, glm::ivec3 node) {
    return grid.lowerM + glm::dvec3(node) * grid.spacingM;
}

int countOf(const LightGrid& grid) {
    return grid.nodes.x * grid.nodes.y * grid.nodes.z;
}

}  // namespace

TEST_CASE("Nodes of light lie in the middle of voxels, around all that is occupied") {
    const BoxM occupied{{20e3, 30e3, 2010.0}, {60e3, 80e3, 10050.0}};
    const LightGrid grid = chooseLightGrid(storm(), occupied, 300000, false);
    CHECK(grid.stride == glm::ivec3(1));
    const glm::dvec3 first = nodeM(grid, {0, 0, 0}), last = nodeM(grid, grid.nodes - 1);
    for (int axis = 0; axis < 2; ++axis) {
        CAPTURE(axis);
        CHECK(first[axis] == occupied.lowerM[axis] - 500.0);
        CHECK(last[axis] == occupied.upperM[axis] + 500.0);
    }
    CHECK(last.z == doctest::Approx(10050.0 + 167.5));
}

TEST_CASE("The lowest nodes of light lie on the ground, to half a voxel") {
    RegularGrid raised = storm();
    raised.originM.z = 1200.0;
    for (const RegularGrid& medium : {storm(), raised}) {
        for (const double baseM : {0.0, 3000.0}) {
            CAPTURE(medium.originM.z);
            CAPTURE(baseM);
            const BoxM occupied{{0.0, 0.0, baseM}, {110e3, 120e3, 15e3}};
            const LightGrid grid = chooseLightGrid(medium, occupied, 100000, false);
            const double heightM = medium.originM.z + grid.lowerM.z;
            CHECK(std::abs(heightM) <= 0.5 * grid.spacingM.z + medium.spacingM.z);
        }
    }
}

TEST_CASE("Nodes far above the ground do not fill the space below with others") {
    RegularGrid cirrus{{64, 64, 64}, {0.0, 0.0, 9000.0}, {25.0, 25.0, 25.0}};
    const LightGrid grid =
        chooseLightGrid(cirrus, {glm::dvec3(0.0), cirrus.extentM()}, 300000, false);
    CHECK(grid.nodes.z < 2 * 64);
}

TEST_CASE("Where there may be few nodes, the smallest spacing is widened first") {
    const BoxM all{glm::dvec3(0.0), storm().extentM()};
    int before = 1 << 30;
    for (const int most : {2000000, 500000, 100000, 20000, 1000}) {
        CAPTURE(most);
        const LightGrid grid = chooseLightGrid(storm(), all, most, false);
        CHECK(countOf(grid) <= most);
        CHECK(countOf(grid) <= before);
        CHECK(grid.spacingM.z <= 1.5 * grid.spacingM.x);
        CHECK(grid.spacingM == glm::dvec3(grid.stride) * storm().spacingM);
        before = countOf(grid);
    }
}

TEST_CASE("A medium of one voxel has nodes of light") {
    const RegularGrid one{{1, 1, 1}, {0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}};
    const LightGrid grid = chooseLightGrid(one, {glm::dvec3(0.0), glm::dvec3(1.0)}, 1000, false);
    CHECK(glm::all(glm::greaterThanEqual(grid.nodes, glm::ivec3(2))));
}

TEST_CASE("Between periodic sides nodes of light divide the whole width, and halve") {
    for (const int width : {1, 7, 96, 100, 127, 254}) {
        for (const int most : {2000000, 100000, 5000}) {
            CAPTURE(width);
            CAPTURE(most);
            const RegularGrid medium{{width, 80, 40}, {0.0, 0.0, 0.0}, {66.7, 66.7, 40.0}};
            const BoxM little{{70.0, 70.0, 400.0}, {140.0, 140.0, 800.0}};
            const LightGrid grid = chooseLightGrid(medium, little, most, true);
            CHECK(countOf(grid) <= most);
            for (int axis = 0; axis < 2; ++axis) {
                CAPTURE(axis);
                CHECK(grid.nodes[axis] * grid.spacingM[axis] ==
                      doctest::Approx(medium.extentM()[axis]).epsilon(1e-12));
                CHECK(grid.lowerM[axis] == doctest::Approx(0.5 * grid.spacingM[axis]));
                CHECK(grid.nodes[axis] % (grid.nodes[axis] >= 8 ? 4 : 2) == 0);
                CHECK(grid.stride[axis] * medium.spacingM[axis] >= 0.999 * grid.spacingM[axis]);
            }
        }
    }
}

TEST_CASE("Between periodic sides nodes lie at voxels where there may be so many") {
    const RegularGrid rico{{96, 80, 40}, {0.0, 0.0, 0.0}, {66.7, 66.7, 40.0}};
    const LightGrid grid =
        chooseLightGrid(rico, {{0.0, 0.0, 400.0}, {140.0, 140.0, 800.0}}, 1 << 20, true);
    CHECK(glm::ivec2(grid.nodes) == glm::ivec2(96, 80));
    CHECK(grid.stride == glm::ivec3(1));
    CHECK(grid.lowerM.x == doctest::Approx(rico.centreM({0, 0, 0}).x));
    CHECK(grid.held() == grid.nodes + glm::ivec3(2, 2, 0));
}
