// mutilation.h: real files, damaged in ways that are the same on every run.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

/// Files that belong together. What is opened is `opened`, a file of them or the folder itself.
struct Patient {
    std::string name;
    std::filesystem::path folder;
    std::vector<std::string> files;  ///< those that are damaged and copied
    std::string opened;              ///< empty: the folder
};

/// The bundled samples, files that tests make below `scratch`, and real output where it is there.
std::vector<Patient> patients(const std::filesystem::path& scratch);

/// Puts a copy of the patient into `folder` with the damage of number `number` in one of its
/// files. Says what was done.
std::string mutilate(const Patient& patient, std::uint64_t number,
                     const std::filesystem::path& folder);
