// file_kind.h: what kind of file was named or dropped, from its first kilobytes.
#pragma once
#include <filesystem>

namespace neph {

enum class FileKind { data, preset, session };

/// `data` for everything else, including folders and unreadable files.
FileKind kindOfFile(const std::filesystem::path& path);

}  // namespace neph
