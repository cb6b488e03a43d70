// atomic_file.h: writing a file so that a reader sees the old one or the new one, never a part.
#pragma once
#include <filesystem>
#include <functional>
#include <string_view>

namespace neph {

/// Calls `write` with the name of a new file beside `target`, flushes it to disk and renames it to
/// `target`. `write` may throw; the new file is then removed and `target` is untouched. Throws
/// Error when the folder is missing or cannot be written.
void replaceFile(const std::filesystem::path& target,
                 const std::function<void(const std::filesystem::path& aside)>& write);

/// Throws what replaceFile would throw for a `target` that is a folder, or whose folder is missing
/// or cannot be written: to be said before the work rather than after it.
void checkReplaceable(const std::filesystem::path& target);

/// replaceFile with plain text.
void replaceFile(const std::filesystem::path& target, std::string_view text);

}  // namespace neph
