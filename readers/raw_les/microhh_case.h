// microhh_case.h: a MicroHH case directory: <name>.ini, grid.0000000, and fields named
// <variable>.<7 digits>.
//
// Fields are in C order (z, y, x), in the byte order of the machine that ran the model. They have
// no header, so every size is checked against the grid of the .ini.
#pragma once
#include <memory>
#include <string>

#include "readers/les/contents.h"

namespace les {

/// 80 for a case directory, its .ini and its grid.0000000; 5 for any other file of a case, for
/// which openMicrohh reports what to open instead; 0 otherwise.
int scoreMicrohh(const std::string& path);

/// Opens a path that scoreMicrohh accepts. Throws Error.
std::unique_ptr<neph::plugin::File> openMicrohh(const std::string& path);

}  // namespace les
