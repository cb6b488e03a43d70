// march.h: the engine of everyday use: light once for every view, then rays through a packed
// medium. docs/performance.md
#pragma once
#include "app/gl/objects.h"
#include "app/gl/pass_timer.h"
#include "app/gl/program.h"
#include "app/render/engines/march/packed_medium.h"
#include "app/render/frame/frame_inputs.h"
#include "app/render/light/light_layers.h"
#include "app/render/light/slice_plan.h"
#include "app/render/medium/phase_texture.h"
#include "core/base/progress.h"

namespace neph::render {

class MarchEngine {
  public:
    /// How much of the detail the medium should hold for a picture: steps that are too long to show
    /// more than the voxels' need none of their own.
    static PackedDetail detailFor(const FrameInputs& inputs, const RegularGrid& grid,
                                  const PackedMedium& medium);

    /// Carries sunlight through the medium and leaves it there, at every voxel. Throws Cancelled.
    /// The medium holds the voxels' detail.
    void light(const FrameInputs& inputs, const VolumeTextures& volume, PackedMedium& medium,
               gl::ProgramCache& programs, const Progress& progress, gl::PassTimer& timer);

    /// Renders the scene-referred picture with its background into `linear` (RGBA32F, A = 1 -
    /// transmittance), or averages it with what is there where inputs.sample says so. Throws
    /// Cancelled.
    void eye(const FrameInputs& inputs, const RegularGrid& grid, const PackedMedium& medium,
             const gl::Texture* noise, gl::ProgramCache& programs, const gl::Texture& linear,
             const Progress& progress);

    /// The rays and samples of the last profiled picture, each a single fetch of RGBA16; the
    /// picture in `linear` is nonsense afterwards.
    void floor(const FrameInputs& inputs, const RegularGrid& grid, const PackedMedium& medium,
               gl::ProgramCache& programs, const gl::Texture& linear);

    /// Of the last picture that was profiled; waits for it.
    SampleCounts counts() const;
    /// Steps along the diagonal of what is occupied.
    int steps() const { return steps_; }
    const SlicePlan& plan() const { return plan_; }
    std::size_t lightBytes() const { return light_.bytes(); }
    std::size_t bytes() const;

  private:
    void bind(const FrameInputs& inputs, const RegularGrid& grid, const PackedMedium& medium,
              const gl::Texture* noise, glm::ivec2 batch);
    void lightToMedium(const std::vector<glm::ivec4>& blocks, const PackedMedium& medium,
                       gl::ProgramCache& programs);
    void march(const FrameInputs& inputs, const gl::Program& program, const gl::Texture& linear,
               const Progress& progress);

    SlicePlan plan_;
    int steps_ = 0;
    LightLayers light_;
    PhaseTexture phases_;
    int lastLayer_ = 0;  ///< of the light that is held: what is left behind the last slice
    gl::Buffer block_, counts_, blocks_;
    gl::Texture blueNoise_;
    gl::Texture floor_;  ///< RGBA16; only to measure
    gl::Texture taken_;  ///< R32UI: samples of each pixel; only when profiled
};

}  // namespace neph::render
