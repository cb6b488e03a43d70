// balance.h: what a sweep of a thick level says of the field that it was made of.
//
// Where voxels are optically thick a node's radiance says little of its surroundings. There l = 0
// follows from the energy that the surroundings of the node gain and lose. docs/transport.md
#pragma once
#include <vector>

#include "core/transport/sweep.h"

namespace neph {

/// What is missing in `field`, of which the sweep was made with `beam`, or none.
LightField missingFrom(const TransportLevel& level, const Swept& sums, const LightField& field,
                       const float* beam);

/// Of active nodes: how much of a change of l = 0 remains missing after it.
std::vector<float> resistanceOf(const TransportLevel& level, const Swept& sums);

/// Adds what is missing, l = 0 divided by `resistance`.
void relax(const LightField& missing, const std::vector<float>& resistance, LightField& field);

/// Keeps l = 0 of balanced nodes between darkness and what a source of strength 1 can bring about.
void limitBalanced(const TransportLevel& level, double brightest, LightField& field);

}  // namespace neph
