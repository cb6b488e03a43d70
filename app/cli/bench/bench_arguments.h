// bench_arguments.h: the grammar of `nephoscope bench`.
#pragma once
#include "app/cli/common/arguments.h"

namespace neph {

Command addBench(CLI::App& app);

}  // namespace neph
