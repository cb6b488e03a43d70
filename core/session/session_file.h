// session_file.h: a session saved as JSON: what was open, how it was shown, and the cameras.
//
// A file is {"type": "nephoscope-session", "version": 1, "active", "compare", "split_at",
// "linked_cameras", "linked_times", "slots": [{"data": [names], "members", "region", "preset",
// "time", "member", "look", "sampling", "camera", "bookmarks", "path", "pins"}, ...]}. "members" is
// true where each name is a run of an ensemble; "member" is the index of the one that is shown, or
// "mean". Look, sampling and camera are written as in presets, lengths are in metres, null is an
// unlimited side. Data below the folder of the file or beside it are named relative to it ("./run",
// "../run"), so that both can be moved together; a name without a slash is that of a bundled
// sample. Files are untrusted: size, depth, duplicate keys and ranges are checked.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/session/session_state.h"

namespace neph {

inline constexpr std::string_view kSessionType = "nephoscope-session";
inline constexpr std::string_view kSessionEnding = ".nephoscope.json";  ///< of files that we name

/// `folder` is the one that the file will be in.
std::string formatSession(const SessionState& state, const std::filesystem::path& folder);

/// Reads a session from text; `where` starts the messages. Names of data become absolute. Unknown
/// keys are added to `warnings`. Throws Error naming key, value and range.
SessionState parseSession(std::string_view text, std::string_view where,
                          const std::filesystem::path& folder, std::vector<std::string>& warnings);

/// Replaces the file. Throws Error if it cannot be written.
void saveSession(const std::filesystem::path& file, const SessionState& state);

/// Throws Error; unknown keys are added to `warnings`.
SessionState loadSession(const std::filesystem::path& file, std::vector<std::string>& warnings);
SessionState loadSession(const std::filesystem::path& file);

}  // namespace neph
