// light_around.h: what clouds change of the light that air around them is in.
#pragma once
#include <cstddef>
#include <vector>

#include "core/transport/directions.h"
#include "core/transport/transport_level.h"

namespace neph {

class LightSolver;

/// Radiance without the beam, less what it is where there is no medium: its moments of l = 0 ... 2
/// at every node of a coarse grid, kBroadMoments side by side, x fastest; units as LightSolver.
struct LightAround {
    TransportGrid grid;
    std::vector<float> change;
};

/// Of the solver's field as it is: one more sweep, on a grid of the multigrid with at most so many
/// nodes, or its coarsest.
LightAround lightAround(const LightSolver& solver, std::size_t mostNodes);

}  // namespace neph
