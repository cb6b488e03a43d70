// scattered_radiance.h: what an eye makes of a solved field, written out for one point; the
// reference for renderers, not for speed.
#pragma once
#include <functional>
#include <span>

#include "core/transport/light_solver.h"

namespace neph {

/// A phase function, 1/sr, by the cosine of the scattering angle.
using PhaseOfCosine = std::function<float(float cosTheta)>;

/// Light emitted by scattering towards an eye that looks along the unit vector `view`, away from
/// itself, per metre: W/(m² sr m) per W/m² of the sun, or per W/(m² sr) of the sky. To be
/// attenuated with the scaled extinction. The sun is scattered once with the complete phase
/// functions, one for each class of `medium`, and the field with what delta-M left; together they
/// are at least 0.
double scatteredRadiancePerM(const LightSolver& solver, const LightMedium& medium,
                             std::span<const PhaseOfCosine> phases, const glm::dvec3& atM,
                             const glm::dvec3& view);

}  // namespace neph
