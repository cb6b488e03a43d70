// file_list.h: from what a user names (files, folders, samples, or nothing) to the files to open.
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace neph {

/// The files and folders named. A name that is not a path here may be that of a bundled sample
/// ("supercell"); an empty list stands for the bundled storm. Throws Error if one does not exist.
std::vector<std::filesystem::path> listFiles(std::span<const std::string> named);

/// Replaces each folder of `paths` by the regular files in it whose names do not start with '.',
/// sorted by name. A folder that cannot be listed yields none.
std::vector<std::filesystem::path> filesIn(std::span<const std::filesystem::path> paths);

}  // namespace neph
