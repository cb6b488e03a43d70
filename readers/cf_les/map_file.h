// map_file.h: the JSON file that says what the variables of an unknown file are, type
// "nephoscope-map". The schema is in docs/readers.md.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "readers/cf_les/models.h"

namespace cf {

/// The map for a file: FILE.map.json, that with the ending of FILE replaced, or
/// nephoscope-map.json in its folder; nothing if there is none.
std::optional<std::string> mapBeside(const std::string& path);

/// A row for one data set. Any text gives a Model or a Failure that names the key.
Model parseMap(std::string_view text);

/// The same of a file. Throws Failure.
Model readMap(const std::string& path);

}  // namespace cf
