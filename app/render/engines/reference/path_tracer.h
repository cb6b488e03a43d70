// path_tracer.h: carries paths of light through a medium and sums up what they bring.
//
// A pass is one path per pixel. Lanes on the GPU carry paths in pieces of a few milliseconds and
// take the next path as soon as one ends, from passes to come where need be, so that neither a long
// path nor a large image holds anything up. Results are stored by path and added up pass by pass:
// the same seed gives the same sums. docs/architecture.md
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "app/gl/objects.h"
#include "app/gl/program.h"
#include "app/render/engines/reference/path_medium.h"
#include "app/render/frame/frame_block.h"
#include "core/base/progress.h"
#include "core/image/reference_progress.h"
#include "core/sky/air_bands.h"

namespace neph::render {
namespace block {
#include "shaders/shared/reference_blocks.glsl"
}

/// Angular radius of the sun's disc at its mean distance, rad.
inline constexpr double kSunRadiusRad = 0.004675;

struct TraceSetup {
    FrameBlock block{};                     ///< `image` and `whole` have the size
    bool periodic = false;                  ///< in x and y
    std::optional<AirBands> air;            ///< that paths meet within the grid
    const gl::Buffer* detectors = nullptr;  ///< where paths begin; none: at the eye
    int seed = 0;
    int maxScatterings = 0;  ///< 0: no limit
    double sunRadiusRad = kSunRadiusRad;
};

/// Sums over paths, a value per pixel, row 0 at the bottom. Halves: even and odd passes.
struct TraceSums {
    std::array<std::vector<glm::vec4>, 2> halves;  ///< radiance; w: paths that met a particle
    std::vector<glm::vec4> squares;  ///< of radiance; w: distances to the first particle, m
};

class PathTracer {
  public:
    /// Forgets what there is. The medium is bound by pass().
    void restart(const TraceSetup& setup);

    /// Until one more pass is whole; the mean of all goes into `mean` (RGBA32F; A: share of paths
    /// that met a particle). Throws Cancelled, and goes on from there when called again.
    void pass(const MediumTextures& medium, const PathMedium& paths, const gl::Texture* noise,
              gl::ProgramCache& programs, const gl::Texture& mean, const Progress& progress);

    int passes() const { return firstPass_; }
    /// Whether the first pass of `setup` is under way.
    bool isIn(const TraceSetup& setup) const;
    /// Root mean variance of the mean over all pixels and channels, as a share of their mean: the
    /// relative standard error. Infinite before there are two passes.
    double relativeError(gl::ProgramCache& programs);
    /// Since restart(); the error is read back from the GPU.
    ReferenceProgress progress(gl::ProgramCache& programs);
    std::uint64_t faults() const { return progress_.faults; }
    TraceSums readSums() const;
    std::size_t bytes() const;

  private:
    glm::ivec2 sizePx() const { return {setup_.block.image.x, setup_.block.image.y}; }
    int pathsAPass() const { return sizePx().x * sizePx().y; }
    void prepare(const MediumTextures& medium, gl::ProgramCache& programs);
    const gl::Program& tracing(const MediumTextures& medium, const PathMedium& paths,
                               const gl::Texture* noise, gl::ProgramCache& programs);
    void carry(const gl::Program& program);
    void gather(gl::ProgramCache& programs, const gl::Texture& mean);

    TraceSetup setup_;
    int lanes_ = 0;
    int rounds_ = 0;     ///< of each lane in one dispatch
    int firstPass_ = 0;  ///< the oldest that is not whole
    std::uint32_t firstTicket_ = 0;
    block::CounterBlock counters_{};
    ReferenceProgress progress_;  ///< without samples and error
    gl::Buffer block_, lanesBuffer_, countersBuffer_, results_, rows_;
    std::array<gl::Texture, 2> halves_;
    gl::Texture squares_, sunDepth_;
};

}  // namespace neph::render
