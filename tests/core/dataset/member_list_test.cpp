// member_list_test.cpp: which runs are members, and what they are called.
#include "core/dataset/member_list.h"

#include <doctest/doctest.h>

#include <fstream>

#include "core/base/error.h"
#include "tests/temporary_folder.h"

using neph::differingParts, neph::Error, neph::listMembers, neph::MemberList;
using Texts = std::vector<std::string>;

namespace {

void touch(const std::filesystem::path& file) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << "x";
}

Texts namesOf(const MemberList& list) {
    Texts names;
    for (const auto& member : list.members) names.push_back(member.name);
    return names;
}

}  // namespace

TEST_CASE("members are called by the words in which their names differ") {
    CHECK(differingParts(Texts{"wrfout_mem01_d01.nc", "wrfout_mem02_d01.nc"}) ==
          Texts{"mem01", "mem02"});
    CHECK(differingParts(Texts{"a/x/out", "b/y/out"}) == Texts{"a/x", "b/y"});
    CHECK(differingParts(Texts{"control", "warm"}) == Texts{"control", "warm"});
    CHECK(differingParts(Texts{"run_1", "run_1_b"}) == Texts{"1", "1_b"});
    // Words that agree with nothing left between them are not left out.
    CHECK(differingParts(Texts{"run", "run_b"}) == Texts{"run", "run_b"});
}

TEST_CASE("a folder stands for its subfolders, or for files by the number in their names") {
    const TemporaryFolder folder;
    touch(folder.path() / "folders" / "mem01" / "out_1.nc");
    touch(folder.path() / "folders" / "mem02" / "out_1.nc");
    touch(folder.path() / "folders" / "plots" / "a.png");
    const MemberList byFolder = listMembers(Texts{(folder.path() / "folders").string()});
    CHECK(namesOf(byFolder) == Texts{"mem01", "mem02"});
    CHECK(byFolder.taken.find("2 folders") != std::string::npos);

    for (const char* name : {"out_d01_m01_1.nc", "out_d01_m01_2.nc", "out_d01_m02_1.nc"}) {
        touch(folder.path() / "files" / name);
    }
    const MemberList byFile = listMembers(Texts{(folder.path() / "files").string()});
    CHECK(namesOf(byFile) == Texts{"m01", "m02"});
    CHECK(byFile.members[0].paths.size() == 2);

    // Domains of a nest are no members.
    touch(folder.path() / "nest" / "out_d01.nc");
    touch(folder.path() / "nest" / "out_d02.nc");
    CHECK_THROWS_WITH_AS(listMembers(Texts{(folder.path() / "nest").string()}),
                         doctest::Contains("no members of an ensemble"), Error);
}

TEST_CASE("runs may be files, folders and patterns, and are named by what differs") {
    const TemporaryFolder folder;
    for (const char* member : {"warm", "cold"}) {
        touch(folder.path() / member / "out_1.nc");
        touch(folder.path() / member / "out_2.nc");
    }
    const MemberList list = listMembers(Texts{(folder.path() / "warm" / "out_*.nc").string(),
                                              (folder.path() / "cold" / "out_*.nc").string()});
    CHECK(namesOf(list) == Texts{"warm", "cold"});
    CHECK(list.members[1].paths.size() == 2);
    CHECK(neph::pathsOf(list.members).size() == 4);

    const std::string warm = (folder.path() / "warm").string();
    CHECK_THROWS_WITH_AS(listMembers(Texts{warm, warm + "/"}), doctest::Contains("named twice"),
                         Error);
    CHECK_THROWS_WITH_AS(listMembers(Texts{warm + "/out_1.nc"}), doctest::Contains("two members"),
                         Error);
    CHECK_THROWS_WITH_AS(listMembers(Texts{warm, warm + "/*.grb"}),
                         doctest::Contains("matches no file"), Error);
}
