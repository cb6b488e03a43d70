// beam.h: what reaches a place straight from the sun.
#pragma once
#include <vector>

#include "core/transport/transport_level.h"

namespace neph {

/// Trilinear interpolation between the values of all nodes; 0 beyond them.
double trilinear(const TransportGrid& grid, const std::vector<float>& values,
                 const glm::dvec3& atM);

/// Optical depth, scaled, from `atM` towards the sun.
double depthTowards(const TransportLevel& level, const glm::dvec3& atM,
                    const glm::dvec3& towardsSun);

/// Irradiance across the beam at every node, 1 above the medium; empty if the sun is not above the
/// horizon.
std::vector<float> beamIrradiance(const TransportLevel& level, const glm::dvec3& towardsSun,
                                  int threads);

}  // namespace neph
