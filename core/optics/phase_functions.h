// phase_functions.h: the table of phase functions, one row each. Whoever offers, draws, reads or
// tests phase functions asks it.
//
// To add one: shaders/lib/phase_<name>.glsl with its mathematics, listed in
// shaders/lib/glsl_cpp.h, and a row at the end of phase_functions.cpp.
#pragma once
#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "core/optics/phase.h"

namespace neph {

/// A parameter that a phase function reads, and a value as particles in clouds have it.
struct PhaseParameter {
    float PhaseSpec::*member = nullptr;
    float typical = 0.0f;
};

/// What a phase function describes: a formula of any particle, or particles of one kind.
enum class Scatterer { any, droplets, crystals };

struct PhaseFunction {
    std::string_view id;     ///< spelling in JSON and `--set`
    std::string_view label;  ///< on the screen
    std::string_view help;   ///< one line, with the key of its source in docs/references.md
    Scatterer scatterer = Scatterer::any;
    std::array<PhaseParameter, 3> parameters;  ///< those that it reads come first
    /// P at 650, 550 and 450 nm, 1/sr.
    glm::vec3 (*value)(const PhaseSpec& spec, float cosTheta);
    /// At 550 nm: share of light within `theta` radians of forward; the cosine of a direction
    /// drawn from it, 1 being forward for u = 1; the mean cosine.
    float (*cumulative)(const PhaseSpec& spec, float theta);
    float (*sample)(const PhaseSpec& spec, float u);
    float (*asymmetry)(const PhaseSpec& spec);
    /// Where a table is kept already; null: it is made of values. The first for a size of particles
    /// may take seconds.
    PhaseTable (*table)(const PhaseSpec& spec) = nullptr;

    std::span<const PhaseParameter> reads() const;
};

/// In the order of PhaseKind, which is the place in this table.
std::span<const PhaseFunction> phaseFunctions();

const PhaseFunction& phaseFunction(PhaseKind kind);

/// With typical parameters.
PhaseSpec typicalSpec(PhaseKind kind);

/// A specification of each, with typical parameters.
std::vector<PhaseSpec> typicalSpecs();

}  // namespace neph
