// radius_scheme.h: particle size in a model cell according to its microphysics scheme, and the
// extinction that follows.
//
// Formulas and constants are those of WRF 4.2.2, as stated in docs/physics.md §7. Where a scheme
// passes its radiation code a radius that does not follow from its own size distribution, geometric
// optics use the one that follows, and the optics of the radiation code use the one passed.
#pragma once
#include <limits>

#include "core/air/thermodynamics.h"
#include "core/dataset/dataset.h"
#include "core/grid/species.h"
#include "core/look/look.h"

namespace neph {

/// An effective radius and the particle density for which it was derived: extinction needs both
/// from one source.
struct ParticleSize {
    double radiusM = 0.0;
    double densityKgPerM3 = 0.0;
};

/// What is known about the hydrometeor and the air of one cell.
struct CellState {
    double contentKgPerM3 = 0.0;  ///< above 0
    double numberPerM3 = 0.0;     ///< 0 if unknown
    double temperatureK = 0.0;    ///< used only if schemeReadsTemperature() is true
};

/// Whether the scheme predicts or prescribes the number of particles of the species.
bool schemeReadsNumber(Microphysics scheme, Species species);
bool schemeReadsTemperature(Microphysics scheme, Species species);

/// Size by the scheme's own diagnosis. If the scheme has none, or needs a number that is unknown:
/// droplets at 100 per cm³, ice of 30 µm, and the distributions of Lin for precipitation.
ParticleSize sizeFromScheme(Microphysics scheme, Species species, RadiationOptics optics,
                            const CellState& cell);

/// Size from the number of particles, which must be above 0, with the shape of distribution of the
/// scheme: gamma for droplets, exponential for the rest.
ParticleSize sizeFromNumber(Microphysics scheme, Species species, const CellState& cell);

/// Limits of the radii that the schemes of WRF pass to its radiation code.
struct RadiusBounds {
    double lowerM = 0.0, upperM = std::numeric_limits<double>::infinity();
};
/// Of droplets, ice and snow; none of the others.
RadiusBounds radiationBounds(Species species);

/// A radius from the file, with the density that belongs to it.
ParticleSize sizeFromFile(Microphysics scheme, Species species, double radiusM);

/// Whether the radius is the one that WRF writes where the species is absent (2.49, 4.99 and 9.99
/// µm for droplets, ice and snow, also when rounded to 0.1 µm), or not a valid radius.
bool isBackgroundRadius(Species species, double radiusM);

/// Extinction coefficient, 1/m, of `contentKgPerM3` of such particles.
double extinctionPerM(RadiationOptics optics, Species species, double contentKgPerM3,
                      const ParticleSize& size);

}  // namespace neph
