// readers_command.h: `nephoscope readers`: which plugins were found, and why others were not taken.
#pragma once
#include <span>
#include <string>

namespace neph {

/// Prints the list, with the libraries or folders in `named` before those found elsewhere; returns
/// the exit code: 0, or 1 when no reader was found. Throws Error where one of `named` is no reader.
int runReaders(std::span<const std::string> named);

}  // namespace neph
