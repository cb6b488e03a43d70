// source_moments.h: what particles make of a solved field, at each active node, for renderers.
#pragma once
#include <vector>

#include "core/transport/light_solver.h"

namespace neph {

/// Albedo of each degree, scaled: TransportLevel::albedo, where nodes without particles, which are
/// beside some, have the mean of those.
std::vector<float> filledAlbedo(const TransportLevel& level);

/// Moments of the source function: what a unit of scaled optical depth sends out in the direction
/// `travel` is the sum over q of them times harmonicsAt(travel, -towardsSun)[q]. The balanced share
/// of the beam is part of them. `albedo` is of a level of the same nodes and at least as many
/// degrees, `degrees`.
std::vector<float> sourceMoments(const LightSolver& solver, const std::vector<float>& albedo,
                                 int degrees);

/// `albedo` times the share in which a node is balanced; empty where none is. Who adds sunlight
/// that is scattered once takes this much of it away again.
std::vector<float> balancedAlbedo(const TransportLevel& level, std::vector<float> albedo);

}  // namespace neph
