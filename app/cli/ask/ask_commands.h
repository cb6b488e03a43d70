// ask_commands.h: `nephoscope probe`, `profile`, `section` and `series`: what data say at a place,
// over a column, along a cut and over time.
#pragma once
#include "app/cli/common/arguments.h"

namespace neph {

Command addProbe(CLI::App& app);
Command addProfile(CLI::App& app);
Command addSection(CLI::App& app);
Command addSeries(CLI::App& app);

}  // namespace neph
