// microhh_case.h: a MicroHH case directory: <name>.ini, grid.0000000, and fields <variable>.<7
// digits>.
//
// Fields are C order (z, y, x), as the machine that ran the model writes numbers; nothing in them
// says what they are, so that every size is checked against the grid of the .ini.
#pragma once
#include <memory>
#include <string>

#include "readers/raw_les/contents.h"

namespace raw {

/// 80 for a case directory and for the .ini or grid.0000000 of one; 5 for another file of a case,
/// whose open says what to open instead; 0 otherwise.
int scoreMicrohh(const std::string& path);

/// `path` as scored. Throws Error.
std::unique_ptr<neph::plugin::File> openMicrohh(const std::string& path);

}  // namespace raw
