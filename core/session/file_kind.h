// file_kind.h: what a file that is named or dropped is to the program, by its first kilobytes.
#pragma once
#include <filesystem>

namespace neph {

enum class FileKind { data, preset, session };

/// `data` for all that is neither of the others, folders and what cannot be read included.
FileKind kindOfFile(const std::filesystem::path& path);

}  // namespace neph
