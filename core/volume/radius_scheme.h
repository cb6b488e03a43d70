// radius_scheme.h: how large the particles of a model cell are by its microphysics scheme, and how
// much light they take away.
//
// Formulas and constants are those of WRF 4.2.2 as docs/physics.md §7 tells them. Where a scheme
// hands its radiation code a radius that does not follow from its own size distribution, the
// geometric optics take the one that follows, and the radiation code's optics the one handed over.
#pragma once
#include "core/dataset/dataset.h"
#include "core/grid/species.h"
#include "core/look/look.h"

namespace neph {

/// An effective radius and the bulk density of particle for which it was derived: extinction needs
/// both from one source.
struct ParticleSize {
    double radiusM = 0.0;
    double densityKgPerM3 = 0.0;
};

inline constexpr double kFreezingK = 273.15;

struct CellState {
    double contentKgPerM3 = 0.0;  ///< above 0
    double numberPerM3 = 0.0;     ///< 0 when unknown
    double temperatureK = 0.0;    ///< read where schemeReadsTemperature says so
};

/// Whether the scheme predicts or prescribes how many particles of the species there are.
bool schemeReadsNumber(Microphysics scheme, Species species);
bool schemeReadsTemperature(Microphysics scheme, Species species);

/// By the scheme's own diagnosis. Where the scheme has none, or needs a number that is not there:
/// droplets at 100 per cm³, ice of 30 µm, and the distributions of Lin for what falls.
ParticleSize sizeFromScheme(Microphysics scheme, Species species, RadiationOptics optics,
                            const CellState& cell);

/// By the number of particles, which must be above 0, in the scheme's shape of distribution: gamma
/// for droplets, exponential for the rest.
ParticleSize sizeFromNumber(Microphysics scheme, Species species, const CellState& cell);

/// A radius that the model wrote out, with the density that belongs to it.
ParticleSize sizeFromFile(Microphysics scheme, Species species, double radiusM);

/// Whether the radius is what WRF writes where the species is absent (2.49, 4.99 and 9.99 µm of
/// droplets, ice and snow, also when rounded to 0.1 µm), or no radius at all.
bool isBackgroundRadius(Species species, double radiusM);

/// Extinction coefficient, 1/m, of `contentKgPerM3` of such particles.
double extinctionPerM(RadiationOptics optics, Species species, double contentKgPerM3,
                      const ParticleSize& size);

}  // namespace neph
