// workbench.cpp: the window and its loop.
#include "app/workbench.h"

#include <cstdlib>

namespace neph {

int runWorkbench(const SceneOptions&) {
    throw Error({"", "there is no display for the workbench", "neither DISPLAY nor WAYLAND_DISPLAY",
                 "", "nephoscope render --out storm.png writes a picture without one"});
}

}  // namespace neph
