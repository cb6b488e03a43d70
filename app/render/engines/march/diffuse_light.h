// diffuse_light.h: light scattered any number of times, in the medium of the march: its voxels of
// light, the work in the background that solves them, and what of it lies on the GPU.
// docs/transport.md
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "app/gl/objects.h"
#include "app/gl/program.h"
#include "app/render/engines/march/packed_medium.h"
#include "app/render/frame/frame_block.h"
#include "app/render/frame/frame_inputs.h"
#include "core/image/light_progress.h"
#include "core/transport/light_grid.h"
#include "core/transport/light_work.h"

namespace neph::render {

class DiffuseLight {
  public:
    /// `wake` as LightWork has it.
    explicit DiffuseLight(std::function<void()> wake) : work_(std::move(wake)) {}

    /// Takes over the medium, which holds the voxels' detail and is bound with its frame block.
    void takeMedium(const FrameInputs& inputs, const RegularGrid& grid, const PackedMedium& medium,
                    const gl::Program& nodes);
    /// Numbers of the block that are its own. `classes` are those of the block.
    void fill(FrameBlock& block, const Look& look, const std::vector<MediumClass>& classes,
              const SkyTextures& sky);

    /// Asks for the light of a look, and takes over the newest there is: waits for the first, or
    /// with `settled` for the last. Throws Cancelled.
    void update(const Look& look, const SkyTextures& sky, bool settled, const Progress& progress);
    /// What the voxels of light send towards the eye of the block, which is bound.
    void lookFrom(const FrameBlock& block, const SkyTextures& sky, const gl::Program& sourceToEye);
    void bind() const;
    /// What the light around clouds sends towards the eye of the block, which is bound; `program`:
    /// march/light_around.comp.
    void lookAround(const gl::Program& program);
    /// Tells march/cloudy_air.comp where its nodes are.
    void placeAround(const gl::Program& program) const;
    /// Whether some of the light that is shown is balanced: BALANCED of source_to_eye.comp.
    bool isBalanced() const { return shown_ && !shown_->balanced.empty(); }

    /// Whether there is light of this medium that was not taken over yet.
    bool hasNewer() const;
    /// Of what is shown.
    LightProgress progress() const;
    std::size_t bytes() const;

  private:
    LightClass lightClassOf(const MediumClass& c);
    void uploadThickness(const std::vector<float>& ofNodes);
    void upload(const LightState& state);
    void uploadAround(const std::array<LightAround, kLightParts>& around);
    void lightGround(const FrameBlock& block, const SkyTextures& sky);

    LightWork work_;
    LightGrid grid_;
    double seaLevelM_ = 0.0;  ///< altitude of the lower corner of the medium's grid
    std::shared_ptr<const LightMedium> medium_;  ///< as it was asked for
    LightGrid shownGrid_;                        ///< of what is on the GPU
    LightGrid wholeGrid_;                        ///< of the medium that it is of
    std::shared_ptr<const LightState> shown_;    ///< what is on the GPU
    LightRequest asked_;
    std::vector<std::pair<PhaseSpec, PhaseMoments>> phases_;  ///< that were met
    gl::Texture thickness_;                                   ///< R8, half of lightThickness
    gl::Texture source_;                                      ///< RGBA16F, of source_to_eye.comp
    bool hasMoments_ = false;                   ///< where the domain repeats: they are in `source_`
    gl::Texture groundLight_;                   ///< RGBA16F
    gl::Texture aroundMolecules_, aroundHaze_;  ///< RGBA16F, of light_around.comp
    std::shared_ptr<const std::array<LightAround, kLightParts>> shownAround_;
    gl::Buffer extinctions_, nodes_, moments_, balanced_, aroundMoments_;
};

}  // namespace neph::render
