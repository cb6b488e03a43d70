// misuse.h: what is said of a command line that does not fit the grammar: which option, which
// command, and where the option belongs.
#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/cli/common/usage.h"

namespace neph {

/// The fault in our words. `app` is the program's grammar, after it was parsed.
UsageError misuse(const CLI::App& app, const CLI::ParseError& fault);

/// Throws UsageError where anything stands before `command`: the window would take it.
void refuseBefore(const CLI::App& app, const CLI::App& command);

/// A file that is not there may be a command that was mistyped. Throws UsageError.
void checkForCommand(const CLI::App& app, const std::vector<std::string>& files);

}  // namespace neph
