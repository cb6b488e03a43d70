// phase_buffer.cpp: tables one after the other, a vec4 an entry.
#include "app/render/engines/phase_buffer.h"

#include <vector>

namespace neph::render {

void PhaseBuffer::update(const Look& look, const MediumPlan& plan) {
    const bool same = filled_ && plan_ == plan && look_.phaseDisplay == look.phaseDisplay &&
                      look_.phaseTruncationDeg == look.phaseTruncationDeg;
    if (same) return;
    std::vector<glm::vec4> values;
    values.reserve(plan.classes.size() * kPhaseTableSize + 1);
    for (const PhaseTable& table : displayPhases(look, plan)) {
        for (const glm::vec3& value : table) values.emplace_back(value, 0.0f);
    }
    if (values.empty()) values.emplace_back(0.0f);  // a buffer that is bound must have a size
    tables_.write(values.data(), values.size() * sizeof(glm::vec4));
    look_ = look;
    plan_ = plan;
    filled_ = true;
}

}  // namespace neph::render
