// mutilation.h: real files with damage that is the same on every run.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

/// Files that form a data set. `opened` is the path to open: one of the files, or the folder.
struct FileSet {
    std::string name;
    std::filesystem::path folder;
    std::vector<std::string> files;  ///< one of them gets damaged
    std::string opened;              ///< empty: the folder
};

/// The bundled samples, files generated in `scratch`, and real model output if it is available.
std::vector<FileSet> fileSets(const std::filesystem::path& scratch);

/// Writes a copy of the set into `folder`, with damage number `number` in one of its files. Returns
/// a description of the damage.
std::string writeDamaged(const FileSet& set, std::uint64_t number,
                         const std::filesystem::path& folder);
