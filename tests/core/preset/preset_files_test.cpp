// preset_files_test.cpp: presets kept, copied, renamed and thrown away, and what is refused.
#include "core/preset/preset_files.h"

#include <doctest/doctest.h>

#include <fstream>
#include <regex>
#include <sstream>

#include "core/base/error.h"
#include "core/base/trash.h"
#include "tests/environment.h"
#include "tests/temporary_folder.h"
#include "tests/text.h"

using namespace neph;

namespace {

namespace fs = std::filesystem;

std::string textOf(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

/// A home with a preset of the user's, "mine", and a program with one bundled, "storm".
struct Library {
    TemporaryFolder home, data;
    Environment xdg{"XDG_DATA_HOME", home.path().string()};
    Environment bundled{"NEPHOSCOPE_DATA_DIR", data.path().string()};

    Library() {
        fs::create_directory(data / "presets");
        savePreset(data / "presets" / "storm.json", {"A storm", "as bundled", {}, {}});
        saveOwnPreset("mine", {"Mine", "", {}, {}}, false);
    }
    fs::path own(const std::string& name) const {
        return home / "nephoscope" / "presets" / (name + ".json");
    }
};

}  // namespace

TEST_CASE("Saving replaces a preset of the user's when asked to, and no other") {
    const Library library;
    Preset other;
    other.title = "Other";
    CHECK_THROWS_WITH_AS(saveOwnPreset("mine", other, false), doctest::Contains("mine 2"), Error);
    CHECK(loadPreset(findPreset("mine")).preset.title == "Mine");
    CHECK(saveOwnPreset("mine", other, true) == library.own("mine"));
    CHECK(loadPreset(findPreset("mine")).preset.title == "Other");
    CHECK_THROWS_AS(saveOwnPreset("a/b", other, true), Error);
}

TEST_CASE("A preset saved under a bundled name hides the bundled one until it is deleted") {
    const Library library;
    CHECK(presetNameUse("storm") == PresetNameUse::bundled);
    CHECK(presetNameUse("storn") == PresetNameUse::free);
    saveOwnPreset("storm", {"My storm", "", {}, {}}, false);
    CHECK(presetNameUse("storm") == PresetNameUse::own);
    CHECK(loadPreset(findPreset("storm")).preset.title == "My storm");
    CHECK(loadPreset(library.data / "presets" / "storm.json").preset.title == "A storm");
    deletePreset("storm");
    CHECK(presetNameUse("storm") == PresetNameUse::bundled);
    CHECK(loadPreset(findPreset("storm")).preset.title == "A storm");
}

TEST_CASE("A bundled preset cannot be renamed, described again or deleted") {
    const Library library;
    CHECK_THROWS_WITH_AS(renamePreset("storm", "mine 2"), doctest::Contains("bundled"), Error);
    CHECK_THROWS_WITH_AS(describePreset("storm", {}), doctest::Contains("bundled"), Error);
    CHECK_THROWS_WITH_AS(deletePreset("storm"), doctest::Contains("bundled"), Error);
    CHECK(fs::exists(library.data / "presets" / "storm.json"));
    CHECK_THROWS_WITH_AS(deletePreset("stork"), doctest::Contains("did you mean storm?"), Error);
}

TEST_CASE("A copy holds the same bytes under the next free name") {
    const Library library;
    CHECK(freePresetName("new") == "new");
    CHECK(duplicatePreset("storm") == "storm 2");
    CHECK(duplicatePreset("storm") == "storm 3");
    CHECK(textOf(library.own("storm 2")) == textOf(library.data / "presets" / "storm.json"));
    CHECK(duplicatePreset("mine", "yours") == "yours");
    CHECK_THROWS_WITH_AS(duplicatePreset("storm", "yours"), doctest::Contains("already"), Error);
    std::ofstream(library.home / "foreign.json") << "{}";
    CHECK_THROWS_AS(duplicatePreset((library.home / "foreign.json").string()), Error);
    CHECK_FALSE(fs::exists(library.own("foreign")));
    savePreset(library.home / "foreign.json", {});
    CHECK(duplicatePreset((library.home / "foreign.json").string()) == "foreign");
}

TEST_CASE("Renaming moves the file, keys that are not known and all, and takes no other's name") {
    const Library library;
    std::ofstream(library.own("future"))
        << R"({"type": "nephoscope-look", "version": 1, "new_key": 1})";
    const std::string before = textOf(library.own("future"));
    renamePreset("future", "past");
    CHECK(textOf(library.own("past")) == before);
    CHECK_FALSE(fs::exists(library.own("future")));
    for (const char* taken : {"mine", "storm"}) {
        CHECK_THROWS_WITH_AS(renamePreset("past", taken), doctest::Contains("already"), Error);
    }
    CHECK_THROWS_AS(renamePreset("past", "../past"), Error);
    CHECK(textOf(library.own("past")) == before);
    CHECK_NOTHROW(renamePreset("past", "past"));
    CHECK_THROWS_WITH_AS(describePreset("past", {"t", "d"}), doctest::Contains("new_key"), Error);
    CHECK(textOf(library.own("past")) == before);
}

TEST_CASE("Describing changes the words and nothing else") {
    const Library library;
    Preset preset{"old", "old", {}, CameraPose{}};
    preset.look.sunElevationDeg = 12.345f;
    saveOwnPreset("mine", preset, true);
    describePreset("mine", {"new \"title\"", "two\nlines"});
    preset.title = "new \"title\"";
    preset.description = "two\nlines";
    CHECK(loadPreset(library.own("mine")).preset == preset);
}

TEST_CASE("What is deleted lies in the trash, with a note of where it was and when") {
    const Library library;
    saveOwnPreset("50 % ü", {"first", "", {}, {}}, false);
    const fs::path kept = deletePreset("50 % ü");
    CHECK(kept == library.home / "Trash" / "files" / "50 % ü.json");
    CHECK(loadPreset(kept).preset.title == "first");
    CHECK_FALSE(fs::exists(library.own("50 % ü")));
    const std::string note = textOf(library.home / "Trash" / "info" / "50 % ü.json.trashinfo");
    CHECK(note.starts_with("[Trash Info]\nPath=" + library.home.path().string()));
    CHECK(contains(note, "/nephoscope/presets/50%20%25%20%C3%BC.json\n"));
    CHECK(std::regex_search(
        note, std::regex("\nDeletionDate=\\d{4}-\\d{2}-\\d{2}T\\d{2}:\\d{2}:\\d{2}\n$")));
    saveOwnPreset("50 % ü", {"second", "", {}, {}}, false);
    CHECK(deletePreset("50 % ü").filename() == "50 % ü 2.json");
    CHECK(loadPreset(kept).preset.title == "first");
    CHECK(fs::exists(library.home / "Trash" / "info" / "50 % ü 2.json.trashinfo"));
}

TEST_CASE("Where the trash cannot be made, the file stays") {
    const Library library;
    std::ofstream(library.home / "Trash") << "a file, not a folder";
    CHECK_THROWS_WITH_AS(deletePreset("mine"), doctest::Contains("trash"), Error);
    CHECK(fs::exists(library.own("mine")));
    CHECK_THROWS_AS(moveToTrash(library.home / "no-such-file"), Error);
}

TEST_CASE("A file outside the list is never taken for the preset of the same name") {
    const Library library;
    CHECK(presetNameOf("mine") == "mine");
    CHECK(presetNameOf(library.own("mine").string()) == "mine");
    const fs::path other = library.home / "mine.json";
    savePreset(other, {});
    CHECK(presetNameOf(other.string()) == other.string());
    CHECK(presetLabel(other.string()) == "mine");
    CHECK_THROWS_AS(presetEntry(other.string()), Error);
}
