// render_context.h: what an engine works with and reports to, whatever it is.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "app/gl/pass_timer.h"
#include "app/gl/program.h"
#include "app/render/frame/frame_inputs.h"
#include "app/render/medium/held_medium.h"
#include "app/render/medium/medium_bake.h"
#include "app/render/medium/noise_texture.h"
#include "app/render/medium/volume_textures.h"
#include "app/render/sky/sky_textures.h"
#include "core/base/progress.h"

namespace neph::render {

struct RenderContext {
    const VolumeTextures& volume;
    HeldMedium& medium;
    NoiseTextures& noise;
    const SkyTextures& sky;       ///< of the frame, bound
    const gl::Texture& sunShown;  ///< R32F, 1 x 1: share of the sun's disc that the eye sees
    gl::ProgramCache& programs;
    gl::PassTimer& timer;
    const Progress& progress;            ///< to be asked every few milliseconds
    FrameStats& stats;                   ///< to be filled in
    std::vector<std::string>& messages;  ///< problems, for the user
    /// To be called from any thread when work in the background has brought something to show; may
    /// be empty.
    const std::function<void()>& wake;
};

/// Fills in `context.sunShown` for an eye and a medium that are bound; `defines`: of the latter,
/// for medium/sun_shown.comp. Where the look shows no disc there is nothing to do.
void measureSunShown(const FrameInputs& inputs, const std::vector<std::string>& defines,
                     const RenderContext& context);

/// Has the medium be MediumTextures as the look asks for, with the noise that they need: for
/// engines that read one extinction per optical class.
void prepareClasses(const Look& look, RenderContext& context);

/// The noise that such engines read; null where the medium has no detail.
const gl::Texture* filteredNoise(const MediumPlan& plan, RenderContext& context);

}  // namespace neph::render
