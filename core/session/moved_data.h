// moved_data.h: data of a session that are no longer where they were.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/session/session_state.h"

namespace neph {

/// Names in `state` under which there is nothing, each once.
std::vector<std::string> missingData(const SessionState& state);

/// Puts `found`, or the file of the same name in the folder `found`, in the place of `missing`, and
/// tries the same move for whatever else is missing. Returns how many names were replaced.
int moveData(SessionState& state, const std::string& missing, const std::filesystem::path& found);

}  // namespace neph
