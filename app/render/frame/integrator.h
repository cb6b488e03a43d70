// integrator.h: the seam between the renderer and the engines.
//
// An engine is a row of core/look/engine_rows.inc and a folder app/render/engines/ID, which
// defines makeIntegrator<Engine::ID>. The renderer decides what a change makes necessary, asks the
// integrator for it, and shows what it left in a texture; it knows no engine by name.
#pragma once
#include <array>
#include <cstddef>
#include <memory>
#include <optional>

#include "app/gl/objects.h"
#include "app/render/frame/frame_inputs.h"
#include "app/render/frame/frame_layers.h"
#include "app/render/frame/render_context.h"
#include "core/image/image.h"

namespace neph::render {

/// One frame to draw.
struct FrameRequest {
    const FrameInputs& inputs;   ///< `supersample` is 1: a pixel is a ray
    Stage from = Stage::medium;  ///< the earliest stage to redo; Stage::eye at the latest
    int sample = 0;              ///< frames that `linear` is the mean of; 0: it is a new image
    const gl::Texture& linear;   ///< RGBA32F: scene-referred radiance; A = 1 - transmittance
};

class Integrator {
  public:
    virtual ~Integrator() = default;

    /// The earliest stage to redo. `changed`: as the differences from the image that is shown have
    /// it; none where there is no such image.
    virtual Stage stageFor(const FrameInputs& inputs, std::optional<Stage> changed) const;

    /// Brings the medium up to date with the look.
    virtual void prepare(const Look& look, RenderContext& context) = 0;

    /// Renders the scene with its background into `linear`, or adds one more sample. Throws
    /// Cancelled.
    virtual void render(const FrameRequest& frame, RenderContext& context) = 0;

    /// Fills in what the statistics have of the image that is shown, of which `inputs` are.
    virtual void describe(const FrameInputs& inputs, RenderContext& context) = 0;

    /// On the GPU, besides the medium: of light, and of all else.
    virtual std::size_t lightBytes() const { return 0; }
    virtual std::size_t otherBytes() const = 0;

    // What an engine need not be able to do.

    /// Whether work in the background has brought light that is better than that of the last frame.
    virtual bool hasNewerLight() const { return false; }

    /// Repeats the rays and samples of the profiled frame before with a single trilinear fetch of
    /// RGBA16 each, to measure against; `linear` is nonsense afterwards. False: it cannot.
    virtual bool floor(const FrameRequest& frame, RenderContext& context);

    /// What else is known of the image that is shown.
    virtual std::optional<FrameLayers> layers(const FrameInputs& inputs, RenderContext& context);

    /// Means of its even and of its odd samples; empty where there are no two.
    virtual std::array<ImageF, 2> halves(glm::ivec2 sizePx) const;
};

/// Defined in the folder of each engine.
template <Engine engine>
std::unique_ptr<Integrator> makeIntegrator();

}  // namespace neph::render
