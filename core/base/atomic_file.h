// atomic_file.h: replaces a file so that others see the old one or the new one, never a part of it.
#pragma once
#include <filesystem>
#include <functional>
#include <string_view>

namespace neph {

/// Calls `write` with the name of a new file beside `target`, flushes it to disk and renames it to
/// `target`. If `write` throws, the new file is removed and `target` is untouched. Throws Error
/// when the folder is missing or cannot be written.
void replaceFile(const std::filesystem::path& target,
                 const std::function<void(const std::filesystem::path& aside)>& write);

/// Throws what replaceFile would throw for a `target` that is a folder, or whose folder is missing
/// or cannot be written, so that the user learns of it before the work rather than after it.
void checkReplaceable(const std::filesystem::path& target);

/// As above, with `text` as the content.
void replaceFile(const std::filesystem::path& target, std::string_view text);

}  // namespace neph
