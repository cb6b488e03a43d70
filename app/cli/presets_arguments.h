// presets_arguments.h: the grammar of `nephoscope presets` and its subcommands.
#pragma once
#include "app/cli/common/arguments.h"

namespace neph {

Command addPresets(CLI::App& app);

}  // namespace neph
