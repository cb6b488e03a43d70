// frame_inputs.h: the plain values that one image is a function of, and what came of it.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "core/camera/camera.h"
#include "core/image/light_progress.h"
#include "core/image/reference_progress.h"
#include "core/look/parameter.h"

namespace neph::render {

/// Which pixels of a larger image are drawn.
struct ImagePart {
    glm::ivec2 wholePx{1};  ///< size of the larger image, whose aspect the camera has
    glm::ivec2 lowerPx{0};  ///< the part's lower left pixel, counted from the whole's
    bool operator==(const ImagePart&) const = default;
};

/// Look and sampling, and what follows.
struct FrameInputs : ParameterSet {
    Camera camera;
    glm::ivec2 sizePx{640, 480};
    std::optional<ImagePart> part;  ///< none: the whole
    int supersample = 1;            ///< a pixel is the mean of so many rays per side
    bool backdrop = true;           ///< sky and ground behind the medium; else it is transparent
    /// Slices, or steps of the march, along the diagonal of what is occupied; 0: as the look says.
    /// Interactive frames may ask for fewer. A given number fixes the step; else the march adapts
    /// it to the data.
    int planes = 0;
    /// Light at half the resolution, an eighth of the work, where it has to be computed: for a
    /// first image after a change. The march computes it in full for the next image without.
    bool draftLight = false;
    /// Full transport: wait until the light has settled; else show what there is, once there is
    /// any.
    bool settledLight = true;
    bool profile = false;  ///< fill in what FrameStats has for it alone, which costs a little
};

/// The pass that integrates the light along the rays of the image; `bench` reports its time.
inline constexpr std::string_view kEyePass = "eye";

/// Time of one pass on the GPU.
struct PassTime {
    std::string_view name;  ///< a literal, as "bake medium"
    double milliseconds = 0.0;
};

/// Bytes of one part on the GPU.
struct MemoryUse {
    std::string_view name;  ///< a literal: "species", "medium", "light", "air", "images", "noise"
    std::size_t bytes = 0;
    bool ofVoxels = false;  ///< grows with the grid
};

/// What the eye pass did, over all pixels.
struct SampleCounts {
    std::uint64_t rays = 0;        ///< that meet the occupied box
    std::uint64_t taken = 0;       ///< samples of the medium
    std::uint64_t skipped = 0;     ///< skips empty bricks
    std::uint64_t terminated = 0;  ///< rays that ended because nothing behind shows
};

/// What the last frame did, for the status line, the profile and `bench`.
struct FrameStats {
    Stage redone = Stage::resolve;  ///< earliest stage that was redone, with all after it
    bool bakedMedium = false;       ///< or put other detail into it
    bool marchedLight = false;
    bool marchedEye = false;
    int planes = 0;                       ///< slices, or steps along the diagonal
    glm::ivec3 lightSize{0};              ///< texels across and layers of the light
    double milliseconds = 0.0;            ///< wall time with the GPU finished
    std::vector<PassTime> passes;         ///< in the order they ran; only when profiled
    std::optional<SampleCounts> samples;  ///< of engines that count them; only when profiled
    double bytesPerSample = 0.0;         ///< fetched, caches not considered; 0: not known; likewise
    ReferenceProgress reference;         ///< of engines that converge
    std::optional<LightProgress> light;  ///< of full transport
};

}  // namespace neph::render
