// reference.h: the engine that neglects nothing: paths of light through the very medium that half-
// angle slicing has, added up for as long as one likes. docs/accuracy.md
#pragma once
#include "app/gl/program.h"
#include "app/render/engines/reference/path_tracer.h"
#include "app/render/engines/reference/reference_layers.h"
#include "app/render/frame/frame_inputs.h"
#include "app/render/medium/medium_bake.h"
#include "core/base/progress.h"

namespace neph::render {

class ReferenceEngine {
  public:
    /// Takes in a medium that has changed.
    void prepare(const MediumTextures& medium, const RegularGrid& grid, const gl::Texture* noise,
                 gl::ProgramCache& programs);

    /// Adds one path a pixel, the first where inputs.sample is 0, and writes the mean into `linear`
    /// (RGBA32F, A: share of the paths that met a particle). Throws Cancelled.
    void render(const FrameInputs& inputs, const RegularGrid& grid, const MediumTextures& medium,
                const gl::Texture* noise, gl::ProgramCache& programs, const gl::Texture& linear,
                const Progress& progress);

    /// Of the picture so far.
    ReferenceProgress progress(gl::ProgramCache& programs);
    /// Means of the even and of the odd paths; empty before there are two.
    std::array<ImageF, 2> halves(glm::ivec2 sizePx) const;
    ReferenceLayers layers(const FrameInputs& inputs, const VolumeTextures& volume,
                           const MediumTextures& medium, const gl::Texture* noise,
                           gl::ProgramCache& programs) const;

    std::size_t bytes() const { return paths_.bytes() + tracer_.bytes(); }

  private:
    FrameBlock blockOf(const FrameInputs& inputs, const RegularGrid& grid,
                       const MediumTextures& medium) const;

    PathMedium paths_;
    PathTracer tracer_;
};

}  // namespace neph::render
