// moved_data_test.cpp: data found again after a move.
#include "core/session/moved_data.h"

#include <doctest/doctest.h>

#include <fstream>

#include "tests/temporary_folder.h"

using namespace neph;

namespace {

namespace fs = std::filesystem;

SessionState with(std::vector<std::string> a, std::vector<std::string> b = {}) {
    SessionState state;
    state.slots.resize(2);
    state.slots[0].data = std::move(a);
    state.slots[1].data = std::move(b);
    return state;
}

void touch(const fs::path& file) {
    fs::create_directories(file.parent_path());
    std::ofstream(file) << "x";
}

}  // namespace

TEST_CASE("Missing data are named once, samples and what is there are not") {
    const TemporaryFolder folder;
    touch(folder / "there");
    const std::string there = (folder / "there").string(), gone = (folder / "gone").string();
    CHECK(missingData(with({there, gone, "cumulus"}, {gone, "/nowhere/x"})) ==
          std::vector<std::string>{gone, "/nowhere/x"});
    CHECK(missingData(with({})).empty());
}

TEST_CASE("Where one file has moved, the others of its tree are found by the same move") {
    const TemporaryFolder folder;
    for (const char* name : {"new/runs/may/a.nc", "new/runs/may/b.nc", "new/runs/june/c.nc"}) {
        touch(folder / name);
    }
    SessionState state = with({"/old/runs/may/a.nc", "/old/runs/may/b.nc", "/old/runs/may/z.nc"},
                              {"/old/runs/june/c.nc", "/other/d.nc", "/old/runs/may/a.nc"});
    const fs::path runs = folder / "new/runs";
    CHECK(moveData(state, "/old/runs/may/a.nc", runs / "may/a.nc") == 3);
    CHECK(state.slots[0].data ==
          std::vector<std::string>{runs / "may/a.nc", runs / "may/b.nc", "/old/runs/may/z.nc"});
    CHECK(state.slots[1].data ==
          std::vector<std::string>{runs / "june/c.nc", "/other/d.nc", runs / "may/a.nc"});
}

TEST_CASE("The folder that a file is in now is answer enough, and a renamed file moves alone") {
    const TemporaryFolder folder;
    touch(folder / "here/a.nc");
    touch(folder / "here/b.nc");
    touch(folder / "c-renamed.nc");
    SessionState state = with({"/old/a.nc", "/old/b.nc"});
    CHECK(moveData(state, "/old/a.nc", folder / "here/") == 2);
    CHECK(missingData(state).empty());
    state = with({"/old/c.nc", "/old/b.nc"});
    CHECK(moveData(state, "/old/c.nc", folder / "c-renamed.nc") == 1);
    CHECK(missingData(state) == std::vector<std::string>{"/old/b.nc"});
    CHECK(moveData(state, "/old/b.nc", folder / "nothing") == 0);
}
