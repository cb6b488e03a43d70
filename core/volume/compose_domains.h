// compose_domains.h: volumes of the domains of a nested run, as one volume on one grid.
//
// Positions are counted in lattice cells, of which every domain's cells are whole multiples on a
// common lattice from the south-west corner of the outermost domain. Levels are those of the result
// already: every domain was remapped to them by its own heights.
//
// A result cell is the mean over the lattice cells in it. Where a domain's cells are wider than the
// result's, its value at a lattice cell is interpolated linearly between the centres of its cells
// (constant beyond the outermost): every cell's value then enters the result with its own area, so
// that mass and optical depth of the domain are kept, to rounding. Else it is the value of the cell
// that it lies in, which keeps them likewise; on the nest's own lattice it is the nest.
#pragma once
#include <glm/glm.hpp>
#include <optional>

#include "core/base/progress.h"
#include "core/grid/species.h"

namespace neph {

/// Cells of a nest, from its edge inwards, over which it takes the place of its parent. In WRF
/// these are the values of the parent: one row is specified and four are relaxed towards it
/// (spec_bdy_width = 5, spec_zone = 1), in nests as in the outermost domain. [WrfGuide]
inline constexpr int kNestEdgeCells = 5;

/// Edges of a nest, in lattice cells.
struct NestEdges {
    glm::ivec2 lower{0}, upper{0};
    double width = 0.0;  ///< over which its weight grows from 0 to 1, lattice cells
    bool operator==(const NestEdges&) const = default;
};

/// Share of a nest at a position: 0 at its edges and beyond, 1 from `width` inwards, in between
/// 3 t² - 2 t³ of the distance from the nearest edge.
double nestWeight(const NestEdges& edges, glm::dvec2 position);

/// Where the cells of a grid lie on the lattice.
struct LatticeGrid {
    glm::ivec2 corner{0};  ///< lattice cells from the outermost domain's corner
    int cell = 1;          ///< lattice cells along one of the grid
    bool operator==(const LatticeGrid&) const = default;
};

/// Puts the fields of a domain into `result`, whose grid is set: all of it without `edges`, else
/// with the weight of a nest, the rest being what is there already, of every field. A species that
/// either lacks counts as 0 there. `domain` has the levels of the result, and holds a species as
/// the result does. Throws Cancelled.
void composeDomain(const SpeciesVolume& domain, const LatticeGrid& at,
                   const std::optional<NestEdges>& edges, const LatticeGrid& resultAt,
                   SpeciesVolume& result, const Progress& progress = {});

}  // namespace neph
