// info_command.h: `nephoscope info`: what a forecaster wants to know of a run before looking at it.
#pragma once
#include <string>
#include <vector>

namespace neph {

struct InfoOptions {
    std::vector<std::string> files;  ///< files of one series, or a folder; none: the bundled storm
    std::vector<std::string> readers;  ///< libraries or folders, before those found elsewhere
    std::string time;                  ///< INDEX, a:b or all; empty: what can be read in seconds
    std::string memory;                ///< as parseMemory; empty for what is remembered
    bool json = false;
};

/// Prints the summary; returns the exit code. Throws Error or UsageError.
int runInfo(const InfoOptions& options);

}  // namespace neph
