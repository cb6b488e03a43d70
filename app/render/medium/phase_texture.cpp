// phase_texture.cpp: one table a row.
#include "app/render/medium/phase_texture.h"

#include <vector>

namespace neph::render {

void PhaseTexture::update(const Look& look, const MediumPlan& plan) {
    const bool same = filled_ && plan_ == plan && look_.phaseDisplay == look.phaseDisplay &&
                      look_.phaseTruncationDeg == look.phaseTruncationDeg;
    if (same) return;
    std::vector<glm::vec4> values;
    values.reserve(plan.classes.size() * kPhaseTableSize + 1);
    for (const PhaseTable& table : displayPhases(look, plan)) {
        for (const glm::vec3& value : table) values.emplace_back(value, 0.0f);
    }
    if (values.empty()) values.resize(kPhaseTableSize);  // a sampler must have something bound
    const glm::ivec2 size{kPhaseTableSize, static_cast<int>(values.size()) / kPhaseTableSize};
    if (tables_.size() != glm::ivec3(size, 1)) tables_ = gl::Texture::make2D(GL_RGBA32F, size);
    tables_.upload(GL_RGBA, GL_FLOAT, values.data());
    look_ = look;
    plan_ = plan;
    filled_ = true;
}

}  // namespace neph::render
