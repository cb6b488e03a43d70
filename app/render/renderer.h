// renderer.h: the one object that turns a volume and FrameInputs into an image.
//
// Owns the GPU cache, which may be thrown away at any moment and is rebuilt from the volume and the
// inputs. Needs a current GL context for its whole life. A shader that fails to compile leaves the
// last good one in place and says so in messages().
#pragma once
#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/render/frame/accumulation.h"
#include "app/render/frame/frame_inputs.h"
#include "app/render/frame/frame_layers.h"
#include "core/base/progress.h"
#include "core/grid/species.h"
#include "core/image/image.h"

namespace neph::render {

class Renderer {
  public:
    /// `shaderDir` holds lib/, shared/ and pass/. Throws Error when a shader fails the first time.
    explicit Renderer(const std::filesystem::path& shaderDir);
    /// One that draws the volume of this one, and leaves alone what this one shows: they share
    /// volume, programs and noise, and each has a medium and images of its own. What the other one
    /// draws is of the volume there is now, whatever comes later.
    std::unique_ptr<Renderer> beside() const;
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// `wake` is called, from any thread, when hasNewerLight() has become true.
    void setWake(std::function<void()> wake);
    /// Whether the last frame would look better by now, with light that was worked out since.
    bool hasNewerLight() const;

    /// Uploads; the volume may be dropped afterwards. An empty volume (no species, all zero) is a
    /// clear sky.
    void setVolume(const SpeciesVolume& volume);

    /// Renders into the renderer's own textures; only what the change since the last frame touches
    /// is redone.
    ///
    /// `progress` is asked every few milliseconds of drawing; where it returns false, Cancelled is
    /// thrown and the display texture keeps the last whole image.
    FrameStats render(const FrameInputs& inputs, const Progress& progress = {});

    /// The same, as one more sample of `image`: the first starts it, those after it have the same
    /// inputs but for tones and `profile`. A frame that is cancelled does not count and may be
    /// asked for again.
    FrameStats render(const FrameInputs& inputs, Accumulation& image,
                      const Progress& progress = {});

    /// Shows the last image, and whatever was added to it, with the tones of `look`, which is its
    /// own but for them.
    FrameStats retone(const Look& look);

    /// Repeats the rays and exactly the samples of the last frame, which was profiled, with a
    /// single trilinear fetch of RGBA16 each: the floor that its eye pass is measured against.
    /// Wall time, ms; none where the engine cannot. What is shown is to be rendered again.
    std::optional<double> floorMilliseconds();

    /// Tone-mapped RGBA8 texture of the last frame, for ImGui (row 0 is the bottom of the image);
    /// 0 before the first. Or of the preview that takes its place.
    unsigned displayTexture() const;
    /// Of that texture.
    glm::ivec2 displaySizePx() const;

    /// The last frame as linear scene-referred RGBA (premultiplied; A = 1 - transmittance), row 0
    /// on top.
    ImageF readLinear() const;
    /// The last frame as shown: sRGB, row 0 on top; straight alpha, to be put over others in linear
    /// light, which is 1 where there is a backdrop.
    Image8 readDisplay() const;

    /// Puts `image`, linear and of any size, on the screen in place of that of `of`, in its tones:
    /// a preview, until hidePreview() or a frame of something else. The image itself and all that
    /// is read of it but what is displayed stay as they are. May be called while a frame asks its
    /// `progress`.
    void showPreview(const ImageF& image, const FrameInputs& of);
    void hidePreview();
    /// Whether that is what is displayed.
    bool showsPreview() const;

    /// What the engine knows of the last frame besides, one value per ray; none of most engines.
    std::optional<FrameLayers> readLayers() const;
    /// Its halves alone, which are read at once; empty where there are none.
    std::array<ImageF, 2> readHalves() const;

    /// The largest image that can be rendered at once, rays per side.
    int largestSidePx() const;

    /// GL renderer string, for provenance and bench.
    std::string deviceName() const;
    /// Bytes held on the GPU, by part and in all; what beside() shares is left to the first.
    std::vector<MemoryUse> memory() const;
    std::size_t gpuBytes() const;
    /// Problems since the last call, newest last: shader file, line, reason.
    std::vector<std::string> takeMessages();
    /// Re-reads shader files that have changed on disk.
    void reloadChangedShaders();

  private:
    struct Impl;
    explicit Renderer(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace neph::render
