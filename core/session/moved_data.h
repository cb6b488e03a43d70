// moved_data.h: finds data of a session that have been moved.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/session/session_state.h"

namespace neph {

/// Names in `state` that do not exist, each once.
std::vector<std::string> missingData(const SessionState& state);

/// Replaces `missing` by `found`, or by the file of the same name in the folder `found`, and tries
/// the same move for all other missing names. Returns how many names were replaced.
int moveData(SessionState& state, const std::string& missing, const std::filesystem::path& found);

}  // namespace neph
