// workbench.h: the window: data, look and camera under the user's hands.
#pragma once
#include "app/cli/common/scene.h"

namespace neph {

/// Runs until the window is closed; returns 0. Throws Error when there is no display.
int runWorkbench(const WorkbenchRequest& request);

}  // namespace neph
