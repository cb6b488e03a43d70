// file_kind_test.cpp: documents of ours told from data.
#include "core/session/file_kind.h"

#include <doctest/doctest.h>

#include <fstream>

#include "core/preset/preset.h"
#include "core/session/session_file.h"
#include "tests/temporary_folder.h"

using namespace neph;

TEST_CASE("Presets and sessions are told from data by what they say they are, not by their names") {
    const TemporaryFolder folder;
    savePreset(folder / "look", {});
    CHECK(kindOfFile(folder / "look") == FileKind::preset);
    SessionState state;
    state.slots.resize(1);
    saveSession(folder / "look.nc", state);
    CHECK(kindOfFile(folder / "look.nc") == FileKind::session);
    std::ofstream(folder / "broken.json")
        << " \n{ \"version\": 1,\n\"type\" : \"nephoscope-look\" nonsense";
    CHECK(kindOfFile(folder / "broken.json") == FileKind::preset);
    CHECK(kindOfFile(NEPH_TEST_SOURCE_DIR "/presets/default.json") == FileKind::preset);
}

TEST_CASE("All else is data: bricks, folders, devices, nothing, half a word") {
    const TemporaryFolder folder;
    CHECK(kindOfFile(NEPH_TEST_SOURCE_DIR "/samples/cumulus/cumulus.json") == FileKind::data);
    CHECK(kindOfFile(folder.path()) == FileKind::data);
    CHECK(kindOfFile("/dev/zero") == FileKind::data);
    CHECK(kindOfFile(folder / "missing") == FileKind::data);
    for (const char* text :
         {"", "{", "{\"type\"", "{\"type\":", "{\"type\": \"", "{\"type\": nephoscope-look",
          "[{\"type\": \"nephoscope-look\"}]", "\"type\": \"nephoscope-look\""}) {
        CAPTURE(text);
        std::ofstream(folder / "f.json") << text;
        CHECK(kindOfFile(folder / "f.json") == FileKind::data);
    }
}
