// render_request.h: what `nephoscope render` is asked for. Filled once, by render_arguments.cpp.
#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "app/cli/common/scene.h"
#include "app/cli/render/render_view.h"
#include "app/image_io/exr.h"

namespace neph {

inline constexpr int kMaxFrames = 100000;  ///< more than an hour at 25 per second

enum class OutputKind { png, exr, mp4 };

/// By the ending of the name. Throws UsageError.
OutputKind kindOf(const std::filesystem::path& out);

/// A second scene beside the first.
struct BesideRequest {
    bool slots = false;             ///< the two slots of the session
    std::string preset;             ///< of B, name or file; empty: A's
    std::optional<TimeRange> time;  ///< of B, one; none: A's
    std::string member;             ///< of B; empty: A's
    /// Share of the width that A takes; none: the session's, or half.
    std::optional<double> splitAt;
    bool wanted() const { return slots || !preset.empty() || time || !member.empty(); }
};

/// When an engine has samples enough.
struct SampleRequest {
    std::optional<int> samples;  ///< frames that the march averages; samples per pixel, reference
    bool error = false;          ///< --error was given: `samples` is a bound, not a goal
};

struct RenderRequest {
    SceneRequest scene;
    std::filesystem::path session;  ///< where what is empty in `scene` comes from; empty: none
    int slot = 0;                   ///< of the session, 1 or 2; 0: the one that was edited
    BesideRequest beside;
    std::filesystem::path out = "nephoscope.png";
    glm::ivec2 sizePx{1280, 720};
    int supersample = 1;     ///< rays per pixel, a side
    bool fixCamera = false;  ///< to the ground
    bool transparent = false;
    RenderView from;
    std::filesystem::path path;  ///< file of a camera path; empty: none
    bool alongPath = false;      ///< along the session's
    double fps = 25.0;           ///< of videos, and of frames along a path
    int frames = 0;              ///< along a path; 0: as `fps` says
    SampleRequest sampling;
    ExrPixels format = ExrPixels::half;
    bool denoise = false;  ///< a preview of the reference, without most of its noise
    bool profile = false;  ///< print what each image cost
    /// Seconds that the reference may be traced for the error of each image; none: no error.
    std::optional<double> measureErrorS;
    bool progress = false;  ///< as progress_lines.h
};

/// How many samples per image has at most, and the relative standard error at which the reference
/// has enough of them before.
struct SamplePlan {
    int samples = 1;
    double targetError = 0.0;
};
SamplePlan planSamples(const SampleRequest& request, const ParameterSet& drawn);

/// "WxH" in pixels, each 1 to 65535. Throws UsageError.
glm::ivec2 parseSize(const std::string& text);

/// A share between 0 and 1. Throws UsageError.
double parseSplit(const std::string& text);

}  // namespace neph
