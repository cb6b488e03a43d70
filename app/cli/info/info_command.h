// info_command.h: `nephoscope info`: what a forecaster wants to know of a run before looking at it.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/cli/common/scene.h"

namespace neph {

struct InfoRequest {
    std::vector<std::string> files;  ///< files of one series, or a folder; none: the bundled storm
    std::vector<std::string> members;  ///< runs of an ensemble, in place of files
    std::vector<std::string> readers;  ///< libraries or folders, before those found elsewhere
    std::string map;                   ///< of the variables of an unknown file; or empty
    std::optional<TimeRange> times;    ///< none: what can be read in seconds
    std::string memory;                ///< as parseMemory; empty for what is remembered
    bool json = false;
};

/// Prints the summary; returns the exit code. Throws Error or UsageError.
int runInfo(const InfoRequest& request);

}  // namespace neph
