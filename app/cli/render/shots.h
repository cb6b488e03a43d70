// shots.h: which images one command takes: times of the data, or places along a camera path.
#pragma once
#include <filesystem>
#include <optional>
#include <vector>

#include "app/cli/render/render_request.h"
#include "core/camera/camera_path.h"

namespace neph {

struct Shot {
    int time = 0;
    std::optional<double> pathS;  ///< along the path; none: the document's camera
    std::filesystem::path file;   ///< of an image of its own
};

/// One for each of `times`; or as many as the request says along `path`, which goes through `times`
/// where it is to be played with the data, and else stays at the first of them. Throws UsageError.
std::vector<Shot> planShots(const RenderRequest& request, const std::optional<CameraPath>& path,
                            const std::vector<int>& times);

/// P_0003.png from P.png and 3.
std::filesystem::path numbered(const std::filesystem::path& file, int number);

}  // namespace neph
