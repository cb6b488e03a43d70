// bench_run.h: what the sections of `bench` share: the scene, the modes, grids, medians.
//
// Times are milliseconds, of the wall where not named otherwise. Other work on the machine slows
// some frames down, so rows take turns frame by frame and medians are told.
#pragma once
#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/bench/bench_request.h"
#include "app/render/renderer.h"
#include "core/camera/camera.h"
#include "core/grid/species.h"
#include "core/look/parameter.h"

namespace neph::bench {

using Json = nlohmann::ordered_json;

inline constexpr int kWarmUp = 2;  // rounds before those that count: caches, compilers of drivers

struct Mode {
    std::string_view id;
    Transport transport;
    PhaseMode phase;
    bool noise;
    double paperFps;  ///< [Riley03] table 4, on a GeForce FX 5800 Ultra; 0: not in it
};
inline constexpr std::array kModes{
    Mode{"uniform-low-albedo", Transport::lowAlbedo, PhaseMode::uniform, false, 5.1},
    Mode{"uniform-translucent", Transport::translucent, PhaseMode::uniform, false, 4.28},
    Mode{"per-field-translucent", Transport::translucent, PhaseMode::perField, false, 1.68},
    Mode{"per-field-noise-translucent", Transport::translucent, PhaseMode::perField, true, 1.18},
};

/// Of engines that scatter often.
inline constexpr Mode kFullMode{"per-field-noise-full", Transport::full, PhaseMode::perField, true,
                                0.0};

/// The mode as part of a look; the rest of it stays.
void setMode(Look& look, const Mode& mode, Engine engine);

/// What a run works on. The volumes are as they were read.
struct Run {
    const BenchRequest& request;
    ParameterSet parameters;
    CameraPose pose;
    SpeciesVolume volume;
    std::optional<SpeciesVolume> otherTime;  ///< none: the series has one time

    /// Sizes asked for, or the section's own.
    std::vector<glm::ivec2> sizesOr(glm::ivec2 own) const;
    /// Parameters and pose as they are; the camera turned by `turnDeg`.
    render::FrameInputs inputs(const RegularGrid& grid, glm::ivec2 sizePx, double turnDeg) const;
};

/// The size asked for along each side, or the data's own where that is finer.
glm::ivec3 sizeOn(const GridRequest& request, glm::ivec3 own);

/// A copy on the grid asked for.
SpeciesVolume onGrid(const SpeciesVolume& volume, const GridRequest& request);

/// Of an even number the mean of the middle two; 0 of none.
double medianOf(std::vector<double> values);
/// median_ms, min_ms and max_ms.
Json timesOf(std::span<const double> milliseconds);

/// A size or a grid as JSON, and for tables.
Json toJson(glm::ivec2 size);
Json toJson(glm::ivec3 size);
std::string textOf(glm::ivec2 size);
std::string textOf(glm::ivec3 size);
/// For tables: a number of that many decimals, "-" where there is none.
std::string cell(const Json& number, int decimals = 1);

/// Time of the eye pass on the GPU in a profiled frame; none where the engine does not say.
std::optional<double> eyeMilliseconds(const render::FrameStats& stats);

}  // namespace neph::bench
