// file_list.h: from what a user names (files, folders, nothing) to the files of one series.
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace neph {

/// A folder stands for the regular files in it whose names do not open with '.', in order of name;
/// nothing stands for the bundled storm. Throws Error for a path that does not exist and for an
/// empty folder.
std::vector<std::filesystem::path> listFiles(std::span<const std::string> named);

}  // namespace neph
