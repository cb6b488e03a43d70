// writing.h: whether a file that looks incomplete is still being written.
#pragma once
#include <optional>
#include <string>

namespace shared {

/// Why a file seems to be written at present, such as "it changed 12 s ago" or "process 4711 has
/// locked it"; nothing if it seems at rest. Takes no lock itself.
std::optional<std::string> beingWritten(const std::string& path);

}  // namespace shared
