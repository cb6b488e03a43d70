// phase.h: the phase function of a species, as the document specifies it and as the renderer
// tabulates it.
//
// cosTheta is the cosine of the scattering angle; 1 is forward. Values are per steradian and
// integrate to 1 over the sphere.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace neph {

/// Place in the table of phase functions, core/optics/phase_functions.h; those that code refers to
/// have a name.
enum class PhaseKind : int {
    isotropic,
    rayleigh,
    henyeyGreenstein,
    doubleHenyeyGreenstein,
    draine,
    cornetteShanks,
    waterDroplets,
    roughAggregate,
    solidColumn
};

/// A phase function with its parameters; each kind reads its own and ignores the others.
struct PhaseSpec {
    PhaseKind kind = PhaseKind::isotropic;
    float g = 0.85f;         ///< g of HG, Draine and Cornette-Shanks; first lobe of double HG
    float g2 = -0.65f;       ///< second lobe of double HG
    float weight = 0.99f;    ///< share of the first lobe of double HG
    float alpha = 1.0f;      ///< Draine's alpha
    float radiusM = 10e-6f;  ///< effective radius of water droplets and of ice crystals
    /// Of the light that water droplets scatter; 0: 650, 550 and 450 nm.
    float wavelengthM = 0.0f;
    bool operator==(const PhaseSpec&) const = default;
};

/// Whether functions of this kind use a parameter of PhaseSpec.
bool phaseReads(PhaseKind kind, float PhaseSpec::*parameter);

#include "shaders/shared/sizes.glsl"

/// P at 650, 550 and 450 nm, 1/sr. Entry i of kPhaseTableSize belongs to the angle pi x² with
/// x = i / (kPhaseTableSize - 1), so that the forward peak is resolved.
using PhaseTable = std::vector<glm::vec3>;

/// P(Theta) at the three wavelengths, 1/sr.
glm::vec3 phaseValue(const PhaseSpec& spec, float cosTheta);

/// Share of the light that is scattered by less than `theta` radians, at 550 nm, in [0, 1].
float phaseCumulative(const PhaseSpec& spec, float theta);

/// Cosine of a scattering angle sampled from the phase function at 550 nm; u is uniform in [0, 1),
/// and u = 1 would be forward.
float phaseSample(const PhaseSpec& spec, float u);

/// Asymmetry parameter, the mean of cosTheta, at 550 nm.
float phaseAsymmetry(const PhaseSpec& spec);

/// The function as a table for the renderer. Water droplets are computed once per radius and kept
/// on disk.
PhaseTable makePhaseTable(const PhaseSpec& spec);

/// The table at an angle, by linear interpolation, as shaders/lib/phase_table.glsl does on the GPU.
glm::vec3 lookUp(std::span<const glm::vec3> table, float cosTheta);

}  // namespace neph
