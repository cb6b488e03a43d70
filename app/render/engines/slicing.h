// slicing.h: half-angle slicing, the method of [Riley03] §4.4.1 after [Kniss03].
//
// Light is carried from slice to slice in a float buffer seen from the sun; each batch of slices is
// then summed along the pixels' rays, which sample exactly the slices. Both passes are compute
// shaders.
#pragma once
#include "app/gl/objects.h"
#include "app/gl/program.h"
#include "app/render/engines/slice_plan.h"
#include "app/render/frame_inputs.h"
#include "app/render/medium_bake.h"
#include "core/progress.h"

namespace neph::render {

class SlicingEngine {
  public:
    /// Renders the scene-referred picture with its background into `linear` (RGBA32F, A = 1 -
    /// transmittance). `lightIsValid` says that nothing but what the eye sees has changed since the
    /// last whole frame. Asks `progress` between bands of slices and of rows; throws Cancelled.
    void render(const FrameInputs& inputs, const RegularGrid& grid, const MediumTextures& medium,
                const gl::Texture* noise, gl::ProgramCache& programs, const gl::Texture& linear,
                bool lightIsValid, const Progress& progress);

    const SlicePlan& plan() const { return plan_; }
    std::size_t bytes() const { return light_.bytes() + eye_.bytes() + phases_.bytes(); }

  private:
    void resize(const FrameInputs& inputs);
    void uploadPhases(const Look& look, const MediumPlan& plan);
    void marchLight(const gl::Program& program, int slices, const Progress& progress);
    void carryLight(int fromLayer);
    int marchBatch(const FrameInputs& inputs, const MediumTextures& medium,
                   gl::ProgramCache& programs, int slices, bool keepLight,
                   const Progress& progress);

    SlicePlan plan_;
    int batch_ = 0;  ///< slices whose light is held at a time
    gl::Texture light_, eye_;
    gl::Buffer block_, phases_;
    Look phaseLook_;  ///< the look and plan that `phases_` was made of
    MediumPlan phasePlan_;
    bool havePhases_ = false;
};

}  // namespace neph::render
