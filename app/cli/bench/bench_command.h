// bench_command.h: `nephoscope bench`: what it takes to open data, to draw the modes of [Riley03]
// table 4, to follow a change, to grow, and to follow the mouse.
#pragma once
#include "app/cli/bench/bench_request.h"

namespace neph {

/// Tables on stderr, JSON to the file or stdout. Returns 0; throws Error or UsageError.
int runBench(const bench::BenchRequest& request);

}  // namespace neph
