// render_options.cpp: sizes, kinds of files and ranges.
#include "app/cli/render/render_options.h"

#include <fmt/format.h>

#include <charconv>
#include <string_view>
#include <type_traits>

#include "app/cli/render/film.h"
#include "app/cli/render/render_view.h"
#include "core/base/atomic_file.h"

namespace neph {
namespace {

constexpr int kMaxSidePx = 65535;
constexpr int kMaxSamples = 65536;
constexpr int kMaxSupersample = 4;
constexpr double kMinFps = 0.1, kMaxFps = 240.0;

/// What is no whole number within bounds.
template <typename Number>
void checkRange(std::string_view option, Number value, Number lo, Number hi) {
    if (value >= lo && value <= hi) return;
    throw UsageError(
        {.where = std::string(option),
         .what = "is outside its range",
         .found = fmt::format("{}", value),
         .expected = fmt::format("a {} from {} to {}",
                                 std::is_integral_v<Number> ? "whole number" : "number", lo, hi)});
}

void checkFilm(const RenderOptions& options) {
    if (options.transparent) {
        throw UsageError({.where = "--transparent",
                          .what = "a film is opaque",
                          .hint = "write pictures: --out frames.png"});
    }
    const glm::ivec2 size = filmSize(parseSize(options.size));
    if (size.x < 2 || size.y < 2) {
        throw UsageError({"--size", "is too small for a film", options.size, "2x2 or more", ""});
    }
    findFfmpeg();
}

}  // namespace

FileKind kindOf(const std::filesystem::path& out) {
    const std::string extension = out.extension().string();
    if (extension == ".png") return FileKind::png;
    if (extension == ".exr") return FileKind::exr;
    if (extension == ".mp4") return FileKind::mp4;
    throw UsageError({"--out " + out.string(), "the kind of file is not known",
                      extension.empty() ? "no extension" : extension, ".png, .exr or .mp4", ""});
}

SamplePlan planSamples(const RenderOptions& options, const ParameterSet& drawn) {
    const EngineTraits& engine = traitsOf(drawn.look.engine);
    if (engine.refinement == Refinement::once) return {};
    if (engine.refinement == Refinement::averages) {
        return {options.samples.value_or(engine.samples), 0.0};
    }
    const bool untilError = !options.samples || !options.error.empty();
    return {options.samples.value_or(kMaxSamples),
            untilError ? static_cast<double>(drawn.sampling.targetError) : 0.0};
}

double parseSplit(const std::string& text) {
    double at = 0.0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), at);
    if (fault == std::errc{} && end == text.data() + text.size() && at > 0.0 && at < 1.0) return at;
    throw UsageError({"--split", "cannot be read", text, "a share between 0 and 1", ""});
}

glm::ivec2 parseSize(const std::string& text) {
    glm::ivec2 size{0};
    const char* end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, size.x);
    if (width.ec == std::errc{} && width.ptr != end && *width.ptr == 'x') {
        const auto height = std::from_chars(width.ptr + 1, end, size.y);
        const bool fits =
            size.x >= 1 && size.y >= 1 && size.x <= kMaxSidePx && size.y <= kMaxSidePx;
        if (height.ec == std::errc{} && height.ptr == end && fits) return size;
    }
    throw UsageError({"--size", "cannot be read as a size", text,
                      fmt::format("WxH in pixels, each from 1 to {}, as 1280x720", kMaxSidePx),
                      ""});
}

void checkOptions(const RenderOptions& options) {
    const FileKind kind = kindOf(options.out);
    if (options.samples) checkRange("--samples", *options.samples, 1, kMaxSamples);
    checkRange("--supersample", options.supersample, 1, kMaxSupersample);
    checkRange("--fps", options.fps, kMinFps, kMaxFps);
    checkRange("--slot", options.slot, 0, 2);
    if (options.format != "half" && options.format != "float") {
        throw UsageError({"--format", "is not known", options.format, "half or float", ""});
    }
    if (parseRenderView(options.observer, options.view).given() &&
        (options.alongPath || !options.path.empty())) {
        throw UsageError({.where = options.view.empty() ? "--observer" : "--view",
                          .what = "there is a camera path as well",
                          .hint = "give one of the two"});
    }
    if (options.frames != 0 && options.path.empty() && !options.alongPath) {
        throw UsageError({.where = "--frames",
                          .what = "there is no camera path",
                          .hint = "--path FILE; --time chooses among the times of the data"});
    }
    if (!options.compare.splitAt.empty()) {
        parseSplit(options.compare.splitAt);
        if (!options.compare.wanted()) {
            throw UsageError({.where = "--split",
                              .what = "there is nothing to compare with",
                              .hint = "--preset-b, --time-b, or --session with --compare"});
        }
    }
    parseSize(options.size);
    if (kind == FileKind::mp4) checkFilm(options);
    checkReplaceable(options.out);  // now rather than after the work
}

}  // namespace neph
