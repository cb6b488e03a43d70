// slicing.h: half-angle slicing, the method of [Riley03] §4.4.1 after [Kniss03].
//
// Light is carried from slice to slice in a float buffer seen from the sun; each batch of slices is
// then summed along the pixels' rays, which sample exactly the slices. Both passes are compute
// shaders.
#pragma once
#include "app/gl/objects.h"
#include "app/gl/program.h"
#include "app/render/frame/integrator.h"
#include "app/render/light/light_layers.h"
#include "app/render/light/slice_plan.h"
#include "app/render/medium/phase_texture.h"

namespace neph::render {

class SlicingEngine final : public Integrator {
  public:
    void prepare(const Look& look, RenderContext& context) override;
    void render(const FrameRequest& frame, RenderContext& context) override;
    void describe(const FrameInputs& inputs, RenderContext& context) override;
    std::size_t lightBytes() const override { return light_.bytes(); }
    std::size_t otherBytes() const override { return eye_.bytes() + phases_.bytes(); }

  private:
    void tellOpenSides(const Look& look, RenderContext& context);
    void resize(glm::ivec2 sizePx);
    void marchEye(const FrameInputs& inputs, const gl::Program& program, const Progress& progress);

    SlicePlan plan_;
    int batch_ = 0;  ///< slices whose light is held at a time
    LightLayers light_;
    gl::Texture eye_;
    gl::Buffer block_;
    PhaseTexture phases_;
    bool toldOpenSides_ = false;
};

}  // namespace neph::render
