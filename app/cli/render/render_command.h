// render_command.h: `nephoscope render`: images and videos to files, without a display.
#pragma once
#include "app/cli/render/render_request.h"

namespace neph {

/// Returns 0, or 128 and the signal that ended it; throws Error or UsageError.
int runRender(const RenderRequest& request);

}  // namespace neph
