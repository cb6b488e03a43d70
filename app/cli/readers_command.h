// readers_command.h: `nephoscope readers`: which plugins were found, and why others were not taken;
// or what a reader took the variables of a file for.
#pragma once
#include <string>
#include <vector>

namespace neph {

struct ReadersRequest {
    std::vector<std::string> readers;  ///< libraries or folders, before those found
    std::vector<std::string> explain;  ///< files of one series; none: the list
    std::string map;                   ///< of the variables of an unknown file; or empty
};

/// Prints the list, or the explanation; returns the exit code: 0, or 1 when no reader was found.
/// Throws Error where one of `readers` is no reader, or a file cannot be opened.
int runReaders(const ReadersRequest& request);

}  // namespace neph
