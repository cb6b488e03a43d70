// bench_command.h: `nephoscope bench`: frame times of the modes of [Riley03] table 4, and of
// opening.
#pragma once
#include <string>
#include <vector>

namespace neph {

struct BenchOptions {
    std::vector<std::string> files;    ///< none: the bundled storm
    std::vector<std::string> readers;  ///< libraries or folders, before those found elsewhere
    std::string json;                  ///< file for the result; empty: stdout
    bool openOnly = false;             ///< opening and the first picture alone
};

/// A table on stderr, JSON to the file or stdout. Returns 0; throws Error.
int runBench(const BenchOptions& options);

}  // namespace neph
