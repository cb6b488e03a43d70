// slicing.h: half-angle slicing, the method of [Riley03] §4.4.1 after [Kniss03].
//
// Light is carried from slice to slice in a float buffer seen from the sun; each batch of slices is
// then summed along the pixels' rays, which sample exactly the slices. Both passes are compute
// shaders.
#pragma once
#include "app/gl/objects.h"
#include "app/gl/pass_timer.h"
#include "app/gl/program.h"
#include "app/render/frame/frame_inputs.h"
#include "app/render/light/light_layers.h"
#include "app/render/light/slice_plan.h"
#include "app/render/medium/medium_bake.h"
#include "app/render/medium/phase_texture.h"
#include "core/base/progress.h"

namespace neph::render {

class SlicingEngine {
  public:
    /// Renders the scene-referred picture with its background into `linear` (RGBA32F, A = 1 -
    /// transmittance). `lightIsValid` says that nothing but what the eye sees has changed since the
    /// last whole frame. Asks `progress` between bands of slices and of rows; throws Cancelled.
    void render(const FrameInputs& inputs, const VolumeTextures& volume,
                const MediumTextures& medium, const gl::Texture* noise, gl::ProgramCache& programs,
                const gl::Texture& linear, bool lightIsValid, const Progress& progress,
                gl::PassTimer& timer);

    const SlicePlan& plan() const { return plan_; }
    std::size_t bytes() const { return light_.bytes() + eye_.bytes() + phases_.bytes(); }

  private:
    void resize(const FrameInputs& inputs);
    void marchEye(const FrameInputs& inputs, const gl::Program& program, const Progress& progress);

    SlicePlan plan_;
    int batch_ = 0;  ///< slices whose light is held at a time
    LightLayers light_;
    gl::Texture eye_;
    gl::Buffer block_;
    PhaseTexture phases_;
};

}  // namespace neph::render
