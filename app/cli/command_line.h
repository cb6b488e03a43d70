// command_line.h: from arguments to one of the commands, and from failures to exit statuses.
#pragma once

namespace neph {

/// Exit status: 0 done, 1 bad input or failed work, 2 bad usage. Errors go to stderr as "error:
/// ...".
int runCommandLine(int argc, char** argv);

}  // namespace neph
