// shots.cpp: counting pictures and naming their files.
#include "app/cli/render/shots.h"

#include <fmt/format.h>

#include <cmath>

namespace neph {
namespace {

constexpr int kMostFrames = 100000;  // more than an hour at 25 a second

int framesOf(const RenderOptions& options, const CameraPath& path) {
    const double frames = options.frames > 0
                              ? options.frames
                              : std::floor(durationS(path) * options.fps + 1e-6) + 1.0;
    if (frames <= kMostFrames) return static_cast<int>(frames);
    throw UsageError({.where = "--path",
                      .what = "these are too many pictures",
                      .found = fmt::format("{:.0f}", frames),
                      .expected = fmt::format("at most {}", kMostFrames),
                      .hint = "--frames or a smaller --fps"});
}

}  // namespace

std::filesystem::path numbered(const std::filesystem::path& file, int number) {
    return file.parent_path() /
           fmt::format("{}_{:04}{}", file.stem().string(), number, file.extension().string());
}

std::vector<Shot> planShots(const RenderOptions& options, const std::optional<CameraPath>& path,
                            const std::vector<int>& times) {
    const std::filesystem::path out = options.out;
    std::vector<Shot> shots;
    if (!path) {
        for (const int time : times) {
            shots.push_back({time, {}, times.size() > 1 ? numbered(out, time) : out});
        }
        return shots;
    }
    const int frames = framesOf(options, *path);
    for (int i = 0; i < frames; ++i) {
        const double atS = frames > 1 ? durationS(*path) * i / (frames - 1) : 0.0;
        const int index = timeAt(*path, atS, static_cast<int>(times.size())).value_or(0);
        shots.push_back(
            {times.at(static_cast<std::size_t>(index)), atS, frames > 1 ? numbered(out, i) : out});
    }
    return shots;
}

}  // namespace neph
