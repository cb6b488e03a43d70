// medium.h: what a look makes of the species that are present: a few optical classes instead of six
// fields.
//
// Species that scatter alike (same phase function, albedo, colour and noise) share a class, whose
// extinction is the sum of theirs. A voxel of the medium is then one extinction per class, and Eq.
// 18 is a sum over classes. The GPU bake and the CPU reference both start from this plan.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "core/grid/species.h"
#include "core/look/look.h"
#include "core/optics/phase.h"

namespace neph {

struct MediumClass {
    float albedo = 1.0f;
    glm::vec3 colour{1.0f};
    PhaseSpec phase;
    float noiseAmount = 0.0f;  ///< 0 when noise is off
    float noiseScaleM = 1.0f;
    glm::vec2 noiseFit{1.0f};  ///< times this along x and y: fitNoise()
    NoiseCharacter noiseCharacter = NoiseCharacter::billow;
    bool operator==(const MediumClass&) const = default;
};

struct MediumPlan {
    std::vector<MediumClass> classes;  ///< at most kSpeciesCount; empty when nothing is visible
    /// What the held values are multiplied by to give extinction in 1/m: m²/kg, Eq. 9, for mass
    /// content, 1 for extinction, times the mixing scale; 0 when absent or invisible.
    std::array<float, kSpeciesCount> extinctionPerHeld{};
    /// Index into `classes`, -1 when absent or invisible.
    std::array<int, kSpeciesCount> classOf{};
    bool repeats = false;  ///< the medium is that of periodic sides
    bool operator==(const MediumPlan&) const = default;
};

/// What lengths of a noise are multiplied by so that a whole number of its tiles, at least one,
/// fits into each width of a domain that repeats: the detail then goes on across its sides.
glm::vec2 fitNoise(float scaleM, glm::dvec2 widthM);

/// Length of the largest features of a field's noise, in data of such cells.
inline float noiseScaleM(const SpeciesLook& field, double cellM) {
    return static_cast<float>(static_cast<double>(field.noiseScaleCells) * cellM);
}

/// What a field's content is multiplied by, in data of such cells. With MixingRule::byCell a scale
/// below 1 is one that makes a cell of 1 km as transparent as it should look; a smaller cell keeps
/// more, so that light crosses as many cells, up to all that the model has.
float mixingScaleAt(const Look& look, const SpeciesLook& field, double cellM);

/// `cellM` is the data's native horizontal cell (SpeciesVolume::cellM).
MediumPlan planMedium(const Look& look, const std::array<Holding, kSpeciesCount>& holdings,
                      double cellM);

/// The same of a domain of some width, which repeats if the look's sides do.
MediumPlan planMedium(const Look& look, const std::array<Holding, kSpeciesCount>& holdings,
                      double cellM, glm::dvec2 widthM);

/// The phase functions of the classes as the image shows them (`light.phase_display`): tables of
/// kPhaseTableSize entries, dimensionless, 1 for full isotropic scatter in the physical display and
/// for the cut peak in the others.
std::vector<PhaseTable> displayPhases(const Look& look, const MediumPlan& plan);

/// Shares of light scattered into the inner disc and into disc and ring, CP(θ_f/4) and CP(θ_f/2) of
/// Eq. 15-16.
struct ForwardShares {
    float inner = 0.0f;
    float outer = 0.0f;
};
ForwardShares forwardShares(const Look& look);

/// Optical-depth weighted asymmetry used for skylight; one number for the look. docs/physics.md §5
inline constexpr float kSkylightAsymmetry = 0.85f;

}  // namespace neph
