// render_command.h: `nephoscope render`: pictures to files, without a display.
#pragma once
#include <string>

#include "app/scene.h"

namespace neph {

struct RenderOptions {
    SceneOptions scene;
    std::string out = "nephoscope.png";
    std::string size = "1280x720";
    std::string engine;           ///< as view.engine; empty, here and below: as the look says
    std::string quality;          ///< as view.quality
    std::string planes;           ///< as view.planes
    int samples = 8;              ///< pictures that the march averages
    std::string format = "half";  ///< of EXR
    bool profile = false;         ///< say what each picture cost
};

/// Returns 0; throws Error or UsageError.
int runRender(const RenderOptions& options);

/// "WxH" in pixels, each 1 to 16384. Throws UsageError.
glm::ivec2 parseSize(const std::string& text);

/// P.png for the only picture, P_0003.png for time 3 of several.
std::filesystem::path outputName(const std::filesystem::path& out, int time, bool several);

}  // namespace neph
