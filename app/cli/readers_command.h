// readers_command.h: `nephoscope readers`: which plugins were found, and why others were not taken.
#pragma once

namespace neph {

/// Prints the list; returns the exit code: 0, or 1 when no reader was found.
int runReaders();

}  // namespace neph
