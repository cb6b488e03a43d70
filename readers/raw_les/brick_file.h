// brick_file.h: binary files without headers ("bricks"), described by a JSON sidecar.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "readers/les/contents.h"

namespace les {

/// 80 for a sidecar, 0 otherwise.
int scoreSidecar(const std::string& path);

/// Opens a sidecar. The size of every file is checked before anything is read. Throws Error.
std::unique_ptr<neph::plugin::File> openBrick(const std::string& sidecarPath);

/// The sidecars in a folder, sorted.
std::vector<std::string> sidecars(const std::string& folder);

}  // namespace les
