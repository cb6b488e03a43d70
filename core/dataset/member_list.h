// member_list.h: which runs are the members of an ensemble, and what each is called.
//
// A run is named as elsewhere, by a file, a folder or a pattern ("out/mem01/wrfout_d01_*"). A
// single folder stands for the members in it: its subfolders, or its files by the number of a
// member in their names (mem01, _m01, ens3, pert002).
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace neph {

/// One run of an ensemble.
struct MemberFiles {
    std::string name;  ///< the part of its name that tells it from the others
    std::vector<std::filesystem::path> paths;  ///< files and folders of one series
};

/// The members, and how they were found.
struct MemberList {
    std::vector<MemberFiles> members;  ///< two at least, names all different
    std::string taken;                 ///< where a folder was searched: one sentence; or empty
};

/// The members that `runs` name. Throws Error if a run is not there, is named twice, or if there
/// are fewer than two.
MemberList listMembers(std::span<const std::string> runs);

/// The files and folders of one run, named or by a pattern. Throws Error if there are none.
std::vector<std::filesystem::path> filesOfRun(const std::string& run);

/// Files and folders of all members, for whoever watches them.
std::vector<std::filesystem::path> pathsOf(std::span<const MemberFiles> members);

/// The parts in which texts differ: words between '_', '-', '.', '/' and spaces that all have at
/// their beginning or end are left out. As many as there are texts, all different if the texts are.
std::vector<std::string> differingParts(std::span<const std::string> texts);

}  // namespace neph
