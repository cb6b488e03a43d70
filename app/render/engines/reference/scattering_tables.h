// scattering_tables.h: phase functions as paths of light need them: to evaluate, and to draw angles
// from.
#pragma once
#include <span>
#include <vector>

#include "app/gl/objects.h"
#include "core/grid/species.h"
#include "core/optics/phase.h"

namespace neph::render {

#include "shaders/shared/reference_layout.glsl"

/// The table scaled so that it integrates to 1 over the sphere at each wavelength as the shaders
/// interpolate it. A share of 1e-4 too much would make 10 % of a path of a thousand scatterings.
PhaseTable normalised(const PhaseTable& table);

/// Versines that part a normalised table, at one wavelength (0 to 2), into equally probable
/// intervals; kScatteringIntervals + 1 of them.
std::vector<float> scatteringVersines(const PhaseTable& table, int wavelength);

struct ScatteringTables {
    gl::Texture phases;      ///< RGBA32F, one row a phase function
    gl::Texture scattering;  ///< R32F, one row a phase function and wavelength
};
/// Of classes, and of molecules and haze after them.
ScatteringTables makeScatteringTables(std::span<const PhaseSpec> phases);

}  // namespace neph::render
