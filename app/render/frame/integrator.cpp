// integrator.cpp: what an engine does that has nothing special.
#include "app/render/frame/integrator.h"

namespace neph::render {

Stage Integrator::stageFor(const FrameInputs&, std::optional<Stage> changed) const {
    return changed.value_or(Stage::medium);
}

bool Integrator::floor(const FrameRequest&, RenderContext&) {
    return false;
}

std::optional<FrameLayers> Integrator::layers(const FrameInputs&, RenderContext&) {
    return {};
}

std::array<ImageF, 2> Integrator::halves(glm::ivec2) const {
    return {};
}

}  // namespace neph::render
