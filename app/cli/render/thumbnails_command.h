// thumbnails_command.h: `nephoscope thumbnails`: a small image of each preset on the bundled
// storm.
#pragma once
#include <string>
#include <vector>

#include "core/session/thumbnail.h"

namespace neph {

struct ThumbnailRequest {
    std::vector<std::string> presets;  ///< names or files; none: all
    glm::ivec2 sizePx = kThumbnailPx;
    std::string out;  ///< folder, for NAME.png; empty: where the preset browser looks for them
    bool progress = false;  ///< as progress_lines.h
};

/// In the cache only those are made that are not there yet. Returns 0, 1 when a preset could not be
/// shown, or 128 and the signal that ended it; throws Error or UsageError.
int runThumbnails(const ThumbnailRequest& request);

}  // namespace neph
