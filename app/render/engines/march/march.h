// march.h: the engine of everyday use: light once for every view, then rays through a packed
// medium. docs/performance.md
#pragma once
#include <optional>
#include <tuple>
#include <vector>

#include "app/gl/objects.h"
#include "app/gl/program.h"
#include "app/render/engines/march/cloudy_air.h"
#include "app/render/engines/march/diffuse_light.h"
#include "app/render/engines/march/packed_medium.h"
#include "app/render/frame/frame_block.h"
#include "app/render/frame/integrator.h"
#include "app/render/light/light_layers.h"
#include "app/render/light/slice_plan.h"
#include "app/render/medium/phase_texture.h"

namespace neph::render {

class MarchEngine final : public Integrator {
  public:
    /// A frame that was cancelled leaves the light as it was; draft light is redone for the first
    /// frame that asks for full light.
    Stage stageFor(const FrameInputs& inputs, std::optional<Stage> changed) const override;
    void prepare(const Look& look, RenderContext& context) override;
    void render(const FrameRequest& frame, RenderContext& context) override;
    void describe(const FrameInputs& inputs, RenderContext& context) override;
    bool hasNewerLight() const override;
    std::size_t lightBytes() const override {
        return light_.bytes() + (diffuse_ ? diffuse_->bytes() : 0);
    }
    std::size_t otherBytes() const override;
    bool floor(const FrameRequest& frame, RenderContext& context) override;

  private:
    void carryLight(const FrameRequest& frame, const PackedMedium& medium, RenderContext& context);
    void takeLightNodes(const FrameRequest& frame, const PackedMedium& medium,
                        RenderContext& context);
    void lightToMedium(const std::vector<glm::ivec4>& blocks, const PackedMedium& medium,
                       gl::ProgramCache& programs);
    void bind(const FrameRequest& frame, const PackedMedium& medium, RenderContext& context,
              glm::ivec2 batch);
    void lookThroughAir(const FrameRequest& frame, RenderContext& context);
    void openCounts(glm::ivec2 sizePx);
    void march(const FrameRequest& frame, const gl::Program& program, const Progress& progress);
    SampleCounts counts() const;
    std::vector<std::string> eyeNames(const FrameInputs& inputs, const PackedMedium& medium,
                                      bool floor) const;

    SlicePlan plan_;  ///< of the light
    int steps_ = 0;   ///< along the diagonal of what is occupied
    LightLayers light_;
    std::optional<Look> lit_;  ///< what the light in the medium was computed for
    bool lightIsDraft_ = false;
    int lastLayer_ = 0;  ///< of the light that is held: what is left behind the last slice
    PhaseTexture phases_;
    bool full_ = false;                    ///< the light that is held is of full transport
    std::optional<DiffuseLight> diffuse_;  ///< since full transport was first wanted
    /// Version of the medium that it knows, voxels that were asked for, periodic sides.
    std::tuple<std::uint64_t, int, bool> diffuseOf_{0, 0, false};
    CloudyAir cloudyAir_;
    FrameBlock bound_{};
    gl::Buffer block_, counts_, blocks_;
    gl::Texture blueNoise_;
    gl::Texture floor_;  ///< RGBA16; only to measure
    gl::Texture taken_;  ///< R32UI: samples of each pixel; only when profiled
};

}  // namespace neph::render
