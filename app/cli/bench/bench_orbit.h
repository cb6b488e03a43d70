// bench_orbit.h: rows of frames of a camera that orbits, which take turns.
//
// A turn of a row (a mode drawn by an engine) is a frame that settles what does not depend on the
// camera, a frame that is timed, and one that is profiled, followed by its floor; the camera moves
// on before each.
#pragma once
#include <span>

#include "app/cli/bench/bench_run.h"

namespace neph::bench {

inline constexpr std::string_view kFloorText =
    "wall time of the rays and samples of the profiled image with one trilinear RGBA16 fetch "
    "each";
inline constexpr std::string_view kBandwidthText =
    "samples x bytes per sample / time of the eye pass, caches not considered; bytes per sample: "
    "march "
    "8 texels x 4 B (RG16F) + a quarter of 8 texels x 4 B for each texture of the mixture + 4 B of "
    "noise; slicing 8 texels x (16 B for each texture of the medium + 4 B for each kind of noise) "
    "+ 4 texels x 4 B of light; floor 8 texels x 8 B";

/// What all rows of one table have in common.
struct OrbitPlan {
    RegularGrid grid;
    glm::ivec2 sizePx{0};
    int steps = 0;
};

struct Row {
    Engine engine{};
    const Mode* mode = nullptr;
    std::vector<double> frameMs{}, eyeMs{}, floorMs{}, samples{}, rays{};
    double bytesPerSample = 0.0;  ///< fetched, caches not considered
    int framesWithLight = 0;      ///< that had to redo light or medium besides the eye pass

    /// Times of frames, of the eye pass and of the floor; null where an engine does not say.
    Json toJson() const;
};

/// Uploads `volume` on the grid asked for, which it returns.
RegularGrid upload(const SpeciesVolume& volume, const GridRequest& request,
                   render::Renderer& renderer);

/// Fills in the rows.
void orbitAll(const Run& run, const OrbitPlan& plan, render::Renderer& renderer,
              std::span<Row> rows);

}  // namespace neph::bench
