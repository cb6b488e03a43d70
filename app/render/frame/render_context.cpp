// render_context.cpp: what engines that read the same medium have in common.
#include "app/render/frame/render_context.h"

#include "app/render/frame/frame_block.h"

namespace neph::render {

void prepareClasses(const Look& look, RenderContext& context) {
    const MediumPlan plan = planMedium(look, context.volume);
    filteredNoise(plan, context);
    context.medium.update<MediumTextures>(plan, [&](MediumTextures& medium) {
        context.timer.pass("bake medium");
        bakeMedium(context.volume, plan, context.programs, medium);
        context.stats.bakedMedium = true;
    });
}

void measureSunShown(const FrameInputs& inputs, const std::vector<std::string>& defines,
                     const RenderContext& context) {
    if (!context.sky.hasAir() || !inputs.look.sunDisc) return;
    context.sunShown.bindImage(kSunShownImage, GL_WRITE_ONLY);
    context.programs.get("medium/sun_shown.comp", defines).dispatch({1, 1, 1});
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

const gl::Texture* filteredNoise(const MediumPlan& plan, RenderContext& context) {
    return isNoisy(plan) ? &context.noise.filtered(context.programs, context.timer) : nullptr;
}

}  // namespace neph::render
