// render_request.cpp: sizes, shares, kinds of files.
#include "app/cli/render/render_request.h"

#include <fmt/format.h>

#include <charconv>

namespace neph {
namespace {

constexpr int kMaxSidePx = 65535;
constexpr int kMaxSamples = 65536;

}  // namespace

OutputKind kindOf(const std::filesystem::path& out) {
    const std::string extension = out.extension().string();
    if (extension == ".png") return OutputKind::png;
    if (extension == ".exr") return OutputKind::exr;
    if (extension == ".mp4") return OutputKind::mp4;
    throw UsageError({"--out " + out.string(), "the kind of file is not known",
                      extension.empty() ? "no extension" : extension, ".png, .exr or .mp4", ""});
}

SamplePlan planSamples(const SampleRequest& request, const ParameterSet& drawn) {
    const EngineTraits& engine = traitsOf(drawn.look.engine);
    if (engine.refinement == Refinement::once) return {};
    if (engine.refinement == Refinement::averages) {
        return {request.samples.value_or(engine.samples), 0.0};
    }
    const bool untilError = !request.samples || request.error;
    return {request.samples.value_or(kMaxSamples),
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

}  // namespace neph
