// file_list.h: from what a user names (files, folders, samples, nothing) to what is opened.
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace neph {

/// The files and folders named. A name that is no path here may be that of a bundled sample
/// ("supercell"); nothing stands for the bundled storm. Throws Error for what does not exist.
std::vector<std::filesystem::path> listFiles(std::span<const std::string> named);

/// Each folder of `paths` replaced by the regular files in it whose names do not open with '.', in
/// order of name. A folder that cannot be listed gives none.
std::vector<std::filesystem::path> filesIn(std::span<const std::filesystem::path> paths);

}  // namespace neph
