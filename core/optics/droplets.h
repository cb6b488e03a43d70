// droplets.h: how a population of cloud droplets scatters visible light.
//
// Droplets follow the gamma distribution of [HT74], n(r) ∝ r^((1-3v)/v) e^(-r/(r_eff v)), with
// effective variance v = 0.1, and are spheres of pure water. Colours are the wavelengths 650, 550
// and 450 nm, or all three are one that is asked for, 400 to 1000 nm. Absorption is neglected (1 -
// ω is below 3e-6 at the three, 2e-5 at 800 nm).
#pragma once
#include <array>
#include <memory>
#include <vector>

#include "core/optics/phase.h"

namespace neph {

/// Radii outside this range are clamped. Above it only the diffraction peak becomes narrower.
inline constexpr float kSmallestDropletM = 1e-6f;
inline constexpr float kLargestDropletM = 50e-6f;

/// Optical properties of one population, at 650, 550 and 450 nm.
struct DropletOptics {
    float effectiveRadiusM = 0.0f;
    PhaseTable phase;               ///< on the angles of shaders/lib/phase_table.glsl
    std::vector<float> cumulative;  ///< at 550 nm, on the same angles, 0 to 1
    glm::vec3 asymmetry{0.0f};
    glm::vec3 extinctionEfficiency{0.0f};  ///< over π r², averaged over the population
};

/// Takes a fraction of a second at 10 µm, more for larger drops (docs/measurements.md). A
/// wavelength of 0 stands for the three.
DropletOptics computeDroplets(float effectiveRadiusM, float wavelengthM = 0.0f);

/// The same from memory, else from the disk cache, else computed and stored in both. The radius is
/// clamped and rounded to 0.1 µm. May be called from any thread. The cache is
/// $XDG_CACHE_HOME/nephoscope or ~/.cache/nephoscope; a file that cannot be read or written there
/// costs time but is not an error. Other wavelengths than the three are kept in memory alone.
std::shared_ptr<const DropletOptics> waterDroplets(float effectiveRadiusM,
                                                   float wavelengthM = 0.0f);

/// Share of light scattered within `theta` radians of forward, at 550 nm; between entries in
/// proportion to the solid angle, as for a constant value.
float dropletCumulative(const DropletOptics& droplets, float theta);

/// Its inverse, as a cosine; u = 1 is forward.
float dropletSample(const DropletOptics& droplets, float u);

}  // namespace neph
