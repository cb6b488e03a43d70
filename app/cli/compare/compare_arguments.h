// compare_arguments.h: the grammar of `nephoscope compare`.
#pragma once
#include "app/cli/common/arguments.h"

namespace neph {

Command addCompare(CLI::App& app);

}  // namespace neph
