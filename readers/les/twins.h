// twins.h: variables of one role and species.
#pragma once
#include <string>
#include <vector>

#include "readers/les/contents.h"

namespace les {

/// Adds sums of categories (addsUp() of names.h). Of other variables with one meaning the first
/// keeps its role; the others are returned, as "ql (like qc)".
std::vector<std::string> settleTwins(Contents& contents);

}  // namespace les
