// render_options.h: what `nephoscope render` is told, as typed, and what of it is wrong from the
// start.
#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "app/cli/common/scene.h"

namespace neph {

/// A second scene beside the first, as typed.
struct CompareOptions {
    bool slots = false;   ///< the two slots of the session
    std::string preset;   ///< of B, name or file
    std::string time;     ///< of B, INDEX
    std::string splitAt;  ///< share of the width that A takes; empty: the session's, or half
    bool wanted() const { return slots || !preset.empty() || !time.empty(); }
};

struct RenderOptions {
    SceneOptions scene;
    std::string session;  ///< file; what it holds is where the options above start from
    int slot = 0;         ///< of the session, 1 or 2; 0: the one that was edited
    CompareOptions compare;
    std::string out = "nephoscope.png";
    std::string size = "1280x720";
    int supersample = 1;  ///< rays a pixel, a side
    bool transparent = false;
    std::string observer;  ///< as parseRenderView, as is `view`
    std::string view;
    std::string path;             ///< camera path, a file
    bool alongPath = false;       ///< along the session's
    double fps = 25.0;            ///< of films, and of pictures along a path
    int frames = 0;               ///< along a path; 0: as `fps` says
    std::string engine;           ///< as view.engine; empty, here and below: as the look says
    std::string quality;          ///< as view.quality
    std::string planes;           ///< as view.planes
    std::string error;            ///< percent, as view.target_error
    std::string seed;             ///< as view.seed
    std::optional<int> samples;   ///< pictures that the march averages, 8 unless told otherwise;
                                  ///< paths a pixel of the reference, unless the error tells
    std::string format = "half";  ///< of EXR
    bool profile = false;         ///< say what each picture cost
    bool progress = false;        ///< as progress_lines.h
};

enum class FileKind { png, exr, mp4 };

/// By the ending of the name. Throws UsageError.
FileKind kindOf(const std::filesystem::path& out);

/// How many samples a picture has at most, and the relative standard error at which the reference
/// has enough of them before.
struct SamplePlan {
    int samples = 1;
    double targetError = 0.0;
};
SamplePlan planSamples(const RenderOptions& options, const ParameterSet& drawn);

/// "WxH" in pixels, each 1 to 65535. Throws UsageError.
glm::ivec2 parseSize(const std::string& text);

/// A share between 0 and 1. Throws UsageError.
double parseSplit(const std::string& text);

/// Throws UsageError, or Error for what the machine lacks: before any work rather than after it.
void checkOptions(const RenderOptions& options);

}  // namespace neph
