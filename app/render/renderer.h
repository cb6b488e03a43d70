// renderer.h: the one object that turns a volume and FrameInputs into a picture.
//
// Owns the GPU cache, which may be thrown away at any moment and is rebuilt from the volume and the
// inputs. Needs a current GL context for its whole life. A shader that fails to compile leaves the
// last good one in place and says so in messages().
#pragma once
#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/render/engines/reference/reference_layers.h"
#include "app/render/frame/frame_inputs.h"
#include "core/base/progress.h"
#include "core/grid/species.h"
#include "core/image/image.h"

namespace neph::render {

class Renderer {
  public:
    /// `shaderDir` holds lib/, shared/ and pass/. Throws Error when a shader fails the first time.
    explicit Renderer(const std::filesystem::path& shaderDir);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Uploads; the volume may be dropped afterwards. An empty volume (no species, all zero) is a
    /// clear sky.
    void setVolume(const SpeciesVolume& volume);

    /// Renders into the renderer's own textures; only what the change since the last frame touches
    /// is redone.
    ///
    /// `progress` is asked every few milliseconds of drawing; where it returns false, Cancelled is
    /// thrown and the display texture keeps the last whole picture.
    FrameStats render(const FrameInputs& inputs, const Progress& progress = {});

    /// Draws the picture of `inputs` with the march, then its rays and exactly its samples once
    /// more with a single trilinear fetch of RGBA16 each: the floor that its eye pass is measured
    /// against. Returns the wall time of the second, ms. The next render() begins anew.
    double floorMilliseconds(const FrameInputs& inputs);

    /// Tone-mapped RGBA8 texture of the last frame, for ImGui (row 0 is the bottom of the picture);
    /// 0 before the first.
    unsigned displayTexture() const;

    /// The last frame as linear scene-referred RGBA (premultiplied; A = 1 - transmittance), row 0
    /// on top.
    ImageF readLinear() const;
    /// The last frame as shown: sRGB, row 0 on top; straight alpha, to be put over others in linear
    /// light, which is 1 where there is a backdrop.
    Image8 readDisplay() const;

    /// What the reference knows of the last frame besides, a value a ray; empty where another
    /// engine drew it.
    ReferenceLayers readReference() const;
    /// The halves alone, which are read at once.
    std::array<ImageF, 2> readHalves() const;

    /// The largest picture that can be rendered at once, rays a side.
    int largestSidePx() const;

    /// GL renderer string, for provenance and bench.
    std::string deviceName() const;
    /// Bytes held on the GPU, by part and in all.
    std::vector<MemoryUse> memory() const;
    std::size_t gpuBytes() const;
    /// Problems since the last call, newest last: shader file, line, reason.
    std::vector<std::string> takeMessages();
    /// Re-reads shader files that have changed on disk.
    void reloadChangedShaders();

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace neph::render
