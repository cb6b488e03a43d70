// phase.h: the phase function of a species, as the document names it and as the renderer tabulates
// it.
//
// cosTheta is the cosine between the propagation directions before and after scattering: 1 is
// straight on. Values are per steradian and integrate to 1 over the sphere. The mathematics of each
// function is in shaders/lib/phase_*.glsl, compiled here as C++; water droplets come from
// core/optics/droplets.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <span>
#include <string_view>
#include <vector>

namespace neph {

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
inline constexpr int kPhaseKindCount = 9;
/// Spelling in JSON and `--set`, in the order of PhaseKind; labels for the screen likewise.
inline constexpr std::array<std::string_view, kPhaseKindCount> kPhaseIds{
    "isotropic",   "rayleigh",        "henyey_greenstein", "double_henyey_greenstein",
    "draine",      "cornette_shanks", "water_droplets",    "rough_aggregate",
    "solid_column"};
inline constexpr std::array<std::string_view, kPhaseKindCount> kPhaseLabels{"Isotropic",
                                                                            "Rayleigh",
                                                                            "Henyey-Greenstein",
                                                                            "Double HG",
                                                                            "Draine",
                                                                            "Cornette-Shanks",
                                                                            "Water droplets (Mie)",
                                                                            "Rough aggregate (ice)",
                                                                            "Solid column (ice)"};

/// A phase function with its parameters; each kind reads those it has, the others are ignored.
struct PhaseSpec {
    PhaseKind kind = PhaseKind::isotropic;
    float g = 0.85f;         ///< g of HG, Draine and Cornette-Shanks; first lobe of double HG
    float g2 = -0.65f;       ///< second lobe of double HG
    float weight = 0.99f;    ///< share of the first lobe of double HG
    float alpha = 1.0f;      ///< Draine's alpha
    float radiusM = 10e-6f;  ///< effective radius of water droplets and of ice crystals
    bool operator==(const PhaseSpec&) const = default;
};

/// Whether functions of a kind read a parameter of PhaseSpec.
bool phaseReads(PhaseKind kind, float PhaseSpec::*parameter);

#include "shaders/shared/sizes.glsl"

/// P at 650, 550 and 450 nm, 1/sr, kPhaseTableSize entries; entry i belongs to Theta = pi (i /
/// (size
/// - 1))², so that the forward peak is resolved.
using PhaseTable = std::vector<glm::vec3>;

/// P(Theta) at the three wavelengths, 1/sr.
glm::vec3 phaseValue(const PhaseSpec& spec, float cosTheta);

/// Share of light scattered within `theta` radians of straight on, at 550 nm, in [0, 1].
float phaseCumulative(const PhaseSpec& spec, float theta);

/// Cosine of a direction drawn from the phase function at 550 nm; u uniform in [0, 1), 1 being
/// straight on.
float phaseSample(const PhaseSpec& spec, float u);

/// Mean of cosTheta at 550 nm.
float phaseAsymmetry(const PhaseSpec& spec);

/// The function tabulated for the renderer. Water droplets are computed once per radius and kept on
/// disk.
PhaseTable makePhaseTable(const PhaseSpec& spec);

/// The table at an angle, by linear interpolation: what shaders/lib/phase_table.glsl does on the
/// GPU.
glm::vec3 lookUp(std::span<const glm::vec3> table, float cosTheta);

}  // namespace neph
