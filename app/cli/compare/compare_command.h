// compare_command.h: `nephoscope compare`: how far images, or what engines draw of one view, are
// from a reference.
#pragma once
#include "app/cli/compare/compare_request.h"

namespace neph {

/// Returns 0, or 128 and the signal that ended it; throws Error or UsageError.
int runCompare(const CompareRequest& request);

}  // namespace neph
