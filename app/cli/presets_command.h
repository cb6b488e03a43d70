// presets_command.h: `nephoscope presets`: what there is, what is in it, and whether it is right.
#pragma once
#include <string>
#include <vector>

namespace neph {

int runPresetsList();
/// Prints the whole preset as JSON. Throws Error.
int runPresetsShow(const std::string& nameOrFile);
/// 0 when every file is right and knows no unknown keys, else 1 with what is wrong on stderr.
int runPresetsCheck(const std::vector<std::string>& files);
/// Prints the reference of all parameters, docs/parameters.md.
int runPresetsParameters();

/// The reference page, in Markdown, from the look table.
std::string parameterReference();

}  // namespace neph
