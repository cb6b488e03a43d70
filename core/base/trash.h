// trash.h: deletes files so that they can be restored, as desktops do (freedesktop.org Trash
// specification 1.0).
#pragma once
#include <filesystem>

namespace neph {

/// Moves a file to the trash of the user's home, $XDG_DATA_HOME/Trash; returns its new path. Throws
/// Error, and then the file is where it was.
std::filesystem::path moveToTrash(const std::filesystem::path& file);

}  // namespace neph
