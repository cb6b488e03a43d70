// reference.h: the engine that traces every scatter: paths of light through the very medium that
// half- angle slicing has, added up for as long as one likes. docs/accuracy.md
#pragma once
#include <cstdint>

#include "app/render/engines/reference/path_tracer.h"
#include "app/render/frame/integrator.h"

namespace neph::render {

class ReferenceEngine final : public Integrator {
  public:
    void prepare(const Look& look, RenderContext& context) override;
    /// A: share of the paths that met a particle. Each frame adds one path per pixel.
    void render(const FrameRequest& frame, RenderContext& context) override;
    void describe(const FrameInputs& inputs, RenderContext& context) override;
    std::size_t otherBytes() const override { return paths_.bytes() + tracer_.bytes(); }
    std::optional<FrameLayers> layers(const FrameInputs& inputs, RenderContext& context) override;
    std::array<ImageF, 2> halves(glm::ivec2 sizePx) const override;

  private:
    PathMedium paths_;
    PathTracer tracer_;
    std::uint64_t pathsOf_ = 0;  ///< version of the medium that they belong to
};

}  // namespace neph::render
