// phase.cpp: a phase function by its specification, which the table of them knows how to compute.
#include "core/optics/phase.h"

#include <algorithm>
#include <cmath>

#include "core/optics/phase_functions.h"
#include "shaders/lib/glsl_cpp.h"

namespace neph {

bool phaseReads(PhaseKind kind, float PhaseSpec::*parameter) {
    const auto reads = phaseFunction(kind).reads();
    return std::ranges::find(reads, parameter, &PhaseParameter::member) != reads.end();
}

glm::vec3 phaseValue(const PhaseSpec& spec, float cosTheta) {
    return phaseFunction(spec.kind).value(spec, cosTheta);
}

float phaseCumulative(const PhaseSpec& spec, float theta) {
    return phaseFunction(spec.kind).cumulative(spec, theta);
}

float phaseSample(const PhaseSpec& spec, float u) {
    return phaseFunction(spec.kind).sample(spec, u);
}

float phaseAsymmetry(const PhaseSpec& spec) {
    return phaseFunction(spec.kind).asymmetry(spec);
}

PhaseTable makePhaseTable(const PhaseSpec& spec) {
    const PhaseFunction& function = phaseFunction(spec.kind);
    if (function.table != nullptr) return function.table(spec);
    PhaseTable table;
    table.reserve(kPhaseTableSize);
    for (int i = 0; i < kPhaseTableSize; ++i) {
        const float cosTheta = std::cos(glsl::phaseTableTheta(i, kPhaseTableSize));
        table.push_back(function.value(spec, cosTheta));
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
