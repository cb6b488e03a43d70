// session_file.h: a session kept as JSON: what was open, how it was looked at, and from where.
//
// A file is {"type": "nephoscope-session", "version": 1, "active", "compare", "split_at",
// "linked_cameras", "linked_times", "slots": [{"data": [names], "region", "preset", "time", "look",
// "sampling", "camera", "bookmarks", "path"}, ...]}. Look and camera are spelled as in presets,
// sampling as the look; lengths are in metres, null is a side without bound. Data that lie under
// the file's folder or beside it are named from there ("./run", "../run"), so that both can be
// moved together; a name without a slash is that of a bundled sample. Files are untrusted: size,
// depth, duplicates and ranges are checked.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/session/session_state.h"

namespace neph {

inline constexpr std::string_view kSessionType = "nephoscope-session";
inline constexpr std::string_view kSessionEnding = ".nephoscope.json";  ///< of files that we name

/// `folder` is where the file is to lie.
std::string formatSession(const SessionState& state, const std::filesystem::path& folder);

/// Reads a session from text; `where` opens the messages. Names of data come out absolute. What is
/// unknown is added to `warnings`. Throws Error naming key, value and range.
SessionState parseSession(std::string_view text, std::string_view where,
                          const std::filesystem::path& folder, std::vector<std::string>& warnings);

/// Writes aside and renames. Throws Error when the place cannot be written.
void saveSession(const std::filesystem::path& file, const SessionState& state);

/// Throws Error; what was unknown is added to `warnings`.
SessionState loadSession(const std::filesystem::path& file, std::vector<std::string>& warnings);
SessionState loadSession(const std::filesystem::path& file);

}  // namespace neph
