// shots.cpp: counting images and naming their files.
#include "app/cli/render/shots.h"

#include <fmt/format.h>

#include <cmath>

namespace neph {
namespace {

int framesOf(const RenderRequest& request, const CameraPath& path) {
    const double frames = request.frames > 0
                              ? request.frames
                              : std::floor(durationS(path) * request.fps + 1e-6) + 1.0;
    if (frames <= kMaxFrames) return static_cast<int>(frames);
    throw UsageError({.where = "--path",
                      .what = "these are too many images",
                      .found = fmt::format("{:.0f}", frames),
                      .expected = fmt::format("at most {}", kMaxFrames),
                      .hint = "--frames or a smaller --fps"});
}

}  // namespace

std::filesystem::path numbered(const std::filesystem::path& file, int number) {
    return file.parent_path() /
           fmt::format("{}_{:04}{}", file.stem().string(), number, file.extension().string());
}

std::vector<Shot> planShots(const RenderRequest& request, const std::optional<CameraPath>& path,
                            const std::vector<int>& times) {
    const std::filesystem::path out = request.out;
    std::vector<Shot> shots;
    if (!path) {
        for (const int time : times) {
            shots.push_back({time, {}, times.size() > 1 ? numbered(out, time) : out});
        }
        return shots;
    }
    if (request.scene.times && !path->withTime && times.size() > 1) {
        throw UsageError({request.scene.times->typed, "this path does not go through the times", "",
                          "INDEX", "\"with_time\": true in the path's file"});
    }
    const int frames = framesOf(request, *path);
    for (int i = 0; i < frames; ++i) {
        const double atS = frames > 1 ? durationS(*path) * i / (frames - 1) : 0.0;
        const int index = timeAt(*path, atS, static_cast<int>(times.size())).value_or(0);
        shots.push_back(
            {times.at(static_cast<std::size_t>(index)), atS, frames > 1 ? numbered(out, i) : out});
    }
    return shots;
}

}  // namespace neph
