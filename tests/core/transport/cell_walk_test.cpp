// cell_walk_test.cpp: rays through cells, and beside them.
#include "core/transport/cell_walk.h"

#include <doctest/doctest.h>

using namespace neph;

namespace {

int cellsMet(const glm::dvec3& start, const glm::dvec3& perM) {
    TransportGrid grid;
    grid.nodes = {5, 5, 5};
    int met = 0;
    walkCells(grid, start, perM, [&](const glm::ivec3&, const glm::vec3&, const glm::vec3&, float) {
        ++met;
        return true;
    });
    return met;
}

}  // namespace

TEST_CASE("A ray meets the cells on its way, and one that is all but level beside them none") {
    CHECK(cellsMet({-1.0, 1.5, 1.5}, {0.01, 0.0, 0.0}) == 4);
    CHECK(cellsMet({-1.0, 1.5, 1.5}, {-0.01, 0.0, 0.0}) == 0);
    // The cosine of 90 degrees in floating point: it would reach them after 1e18 m.
    CHECK(cellsMet({-1.0, 1.5, 1.5}, {6e-19, 0.01, 0.0}) == 0);
    CHECK(cellsMet({1.5, 1.5, -1.0}, {-6e-19, 0.01, 0.01}) == 3);
}
