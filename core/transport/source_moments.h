// source_moments.h: what particles make of a solved field, at each active node, for renderers.
#pragma once
#include <vector>

#include "core/transport/light_solver.h"

namespace neph {

/// Scattering of degree l per extinction, both scaled: degreeCount side by side of each active
/// node. Nodes without particles, which are beside some, have the mean of those.
std::vector<float> scatteringShares(const TransportLevel& level);

/// Moments of the source function: what a unit of scaled optical depth sends out in the direction
/// `travel` is the sum over q of them times harmonicsAt(travel, -towardsSun)[q]. `shares` are those
/// of a level of the same nodes and at least as many degrees, `degrees`.
std::vector<float> sourceMoments(const LightSolver& solver, const std::vector<float>& shares,
                                 int degrees);

}  // namespace neph
