// phase.cpp: selects a phase function by kind, from the closed forms of the shader library or from
// the table of the droplets.
#include "core/optics/phase.h"

#include <algorithm>
#include <cmath>

#include "core/optics/droplets.h"
#include "shaders/lib/glsl_cpp.h"

namespace neph {
namespace {

/// Value of the functions that do not depend on wavelength.
float greyValue(const PhaseSpec& spec, float cosTheta) {
    switch (spec.kind) {
        case PhaseKind::isotropic:
        case PhaseKind::waterDroplets:
            break;
        case PhaseKind::rayleigh:
            return glsl::rayleighValue(cosTheta);
        case PhaseKind::henyeyGreenstein:
            return glsl::hgValue(cosTheta, spec.g);
        case PhaseKind::doubleHenyeyGreenstein:
            return glsl::doubleHgValue(cosTheta, spec.g, spec.g2, spec.weight);
        case PhaseKind::draine:
            return glsl::draineValue(cosTheta, spec.g, spec.alpha);
        case PhaseKind::cornetteShanks:
            return glsl::cornetteShanksValue(cosTheta, spec.g);
        case PhaseKind::roughAggregate:
            return glsl::roughAggregateValue(cosTheta, spec.radiusM);
        case PhaseKind::solidColumn:
            return glsl::solidColumnValue(cosTheta, spec.radiusM);
    }
    return glsl::isotropicValue();
}

/// Cumulative of the droplets; between entries proportional to the solid angle, as for a constant
/// value.
float dropletCumulative(const DropletOptics& droplets, float theta) {
    const float index = glsl::phaseTableIndex(std::cos(theta), kPhaseTableSize);
    const int i = std::min(static_cast<int>(index), kPhaseTableSize - 2);
    const float lower = std::cos(glsl::phaseTableTheta(i, kPhaseTableSize));
    const float upper = std::cos(glsl::phaseTableTheta(i + 1, kPhaseTableSize));
    const float share = lower == upper ? 0.0f : (lower - std::cos(theta)) / (lower - upper);
    const auto at = static_cast<std::size_t>(i);
    return std::lerp(droplets.cumulative[at], droplets.cumulative[at + 1],
                     std::clamp(share, 0.0f, 1.0f));
}

/// Inverse of dropletCumulative, as a cosine; u = 1 is the forward direction.
float dropletSample(const DropletOptics& droplets, float u) {
    const auto& cumulative = droplets.cumulative;
    const float share = 1.0f - u;
    const auto above = std::upper_bound(cumulative.begin() + 1, cumulative.end() - 1, share);
    const auto i = static_cast<int>(above - cumulative.begin());
    const float low = *(above - 1), high = *above;
    const float f = high > low ? std::clamp((share - low) / (high - low), 0.0f, 1.0f) : 0.5f;
    return std::lerp(std::cos(glsl::phaseTableTheta(i - 1, kPhaseTableSize)),
                     std::cos(glsl::phaseTableTheta(i, kPhaseTableSize)), f);
}

}  // namespace

bool phaseReads(PhaseKind kind, float PhaseSpec::*parameter) {
    switch (kind) {
        case PhaseKind::isotropic:
        case PhaseKind::rayleigh:
            break;
        case PhaseKind::henyeyGreenstein:
        case PhaseKind::cornetteShanks:
            return parameter == &PhaseSpec::g;
        case PhaseKind::doubleHenyeyGreenstein:
            return parameter == &PhaseSpec::g || parameter == &PhaseSpec::g2 ||
                   parameter == &PhaseSpec::weight;
        case PhaseKind::draine:
            return parameter == &PhaseSpec::g || parameter == &PhaseSpec::alpha;
        case PhaseKind::waterDroplets:
        case PhaseKind::roughAggregate:
        case PhaseKind::solidColumn:
            return parameter == &PhaseSpec::radiusM;
    }
    return false;
}

glm::vec3 phaseValue(const PhaseSpec& spec, float cosTheta) {
    if (spec.kind == PhaseKind::waterDroplets) {
        return lookUp(waterDroplets(spec.radiusM)->phase, cosTheta);
    }
    return glm::vec3(greyValue(spec, cosTheta));
}

float phaseCumulative(const PhaseSpec& spec, float theta) {
    switch (spec.kind) {
        case PhaseKind::isotropic:
            break;
        case PhaseKind::rayleigh:
            return glsl::rayleighCumulative(theta);
        case PhaseKind::henyeyGreenstein:
            return glsl::hgCumulative(theta, spec.g);
        case PhaseKind::doubleHenyeyGreenstein:
            return glsl::doubleHgCumulative(theta, spec.g, spec.g2, spec.weight);
        case PhaseKind::draine:
            return glsl::draineCumulative(theta, spec.g, spec.alpha);
        case PhaseKind::cornetteShanks:
            return glsl::cornetteShanksCumulative(theta, spec.g);
        case PhaseKind::waterDroplets:
            return dropletCumulative(*waterDroplets(spec.radiusM), theta);
        case PhaseKind::roughAggregate:
            return glsl::roughAggregateCumulative(theta, spec.radiusM);
        case PhaseKind::solidColumn:
            return glsl::solidColumnCumulative(theta, spec.radiusM);
    }
    return glsl::isotropicCumulative(theta);
}

float phaseSample(const PhaseSpec& spec, float u) {
    switch (spec.kind) {
        case PhaseKind::isotropic:
            break;
        case PhaseKind::rayleigh:
            return glsl::rayleighSample(u);
        case PhaseKind::henyeyGreenstein:
            return glsl::hgSample(u, spec.g);
        case PhaseKind::doubleHenyeyGreenstein:
            return glsl::doubleHgSample(u, spec.g, spec.g2, spec.weight);
        case PhaseKind::draine:
            return glsl::draineSample(u, spec.g, spec.alpha);
        case PhaseKind::cornetteShanks:
            return glsl::cornetteShanksSample(u, spec.g);
        case PhaseKind::waterDroplets:
            return dropletSample(*waterDroplets(spec.radiusM), u);
        case PhaseKind::roughAggregate:
            return glsl::roughAggregateSample(u, spec.radiusM);
        case PhaseKind::solidColumn:
            return glsl::solidColumnSample(u, spec.radiusM);
    }
    return glsl::isotropicSample(u);
}

float phaseAsymmetry(const PhaseSpec& spec) {
    switch (spec.kind) {
        case PhaseKind::isotropic:
        case PhaseKind::rayleigh:
            break;
        case PhaseKind::henyeyGreenstein:
            return spec.g;
        case PhaseKind::doubleHenyeyGreenstein:
            return glsl::doubleHgAsymmetry(spec.g, spec.g2, spec.weight);
        case PhaseKind::draine:
            return glsl::draineAsymmetry(spec.g, spec.alpha);
        case PhaseKind::cornetteShanks:
            return glsl::cornetteShanksAsymmetry(spec.g);
        case PhaseKind::waterDroplets:
            return waterDroplets(spec.radiusM)->asymmetry.y;
        case PhaseKind::roughAggregate:
            return glsl::roughAggregateAsymmetry(spec.radiusM);
        case PhaseKind::solidColumn:
            return glsl::solidColumnAsymmetry(spec.radiusM);
    }
    return 0.0f;
}

PhaseTable makePhaseTable(const PhaseSpec& spec) {
    if (spec.kind == PhaseKind::waterDroplets) return waterDroplets(spec.radiusM)->phase;
    PhaseTable table;
    table.reserve(kPhaseTableSize);
    for (int i = 0; i < kPhaseTableSize; ++i) {
        const float cosTheta = std::cos(glsl::phaseTableTheta(i, kPhaseTableSize));
        table.emplace_back(greyValue(spec, cosTheta));
    }
    return table;
}

glm::vec3 lookUp(std::span<const glm::vec3> table, float cosTheta) {
    const auto size = static_cast<int>(table.size());
    const float index = glsl::phaseTableIndex(cosTheta, size);
    const int i = std::min(static_cast<int>(index), size - 2);
    const auto at = static_cast<std::size_t>(i);
    return glm::mix(table[at], table[at + 1], index - static_cast<float>(i));
}

}  // namespace neph
