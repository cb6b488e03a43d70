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

/// Irradiance across the beam at active nodes and on the ground, 1 where nothing is in the way; 0
/// elsewhere. Wholly balanced nodes above the ground are left at 0.
std::vector<float> beamIrradiance(const TransportLevel& level, const glm::dvec3& towardsSun,
                                  int threads);

/// Gives balanced nodes of a thick level the irradiance that brings in what the beam loses around
/// them. Returns the share of what the beam loses that it loses between nodes further apart than a
/// scaled optical depth of 4.
double blendDeposit(const TransportLevel& level, const glm::dvec3& towardsSun, int threads,
                    std::vector<float>& irradiance);

}  // namespace neph
