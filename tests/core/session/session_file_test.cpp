// session_file_test.cpp: sessions bit for bit, where their data lie, and every way in which a file
// can be wrong.
#include "core/session/session_file.h"

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "core/base/error.h"
#include "tests/temporary_folder.h"
#include "tests/text.h"

using namespace neph;

namespace {

namespace fs = std::filesystem;

/// Two slots with something in every place.
SessionState full(const fs::path& folder) {
    SessionState state;
    SlotState a;
    a.data = {(folder / "run").string(), "/elsewhere/wrfout_d01"};
    constexpr double kFar = std::numeric_limits<double>::infinity();
    a.region = BoxM{{1000.0 / 3.0, 2.5e-9, -kFar}, {1e5, 2e5 + 0.1, kFar}};
    a.presetName = "Größe \"7\"\n";
    a.document.look.of(Species::rain).mixingScale = 1.0f / 3.0f;
    a.document.look.of(Species::snow).visible = false;
    a.document.sampling = {.quality = 1.0f / 3.0f, .targetError = 0.011f, .seed = 12345};
    a.document.camera = {{0.1f, 1.0f / 7.0f, -0.99f}, 0.123456789f, 359.99f, -89.9f, 5.0f};
    a.document.time = 12;
    a.document.bookmarks = {{"Von Süden", {}}, {"", a.document.camera}};
    a.document.pins = {{"Overshoot", {46875.0, 51875.5, 15150.25}}, {"", {-1.0, 0.0, 2.0}}};
    a.document.path = {{{0.0, {}}, {1.0 / 3.0, a.document.camera}}, false};
    SlotState b;
    b.data = {"cumulus"};
    state.slots = {a, b};
    state.active = 1;
    state.compare = CompareMode::split;
    state.splitAt = 0.7f;
    state.linkedCameras = false;
    return state;
}

SessionState parsed(const std::string& text) {
    std::vector<std::string> warnings;
    return parseSession(text, "my.json", "/data", warnings);
}

/// The message of the Error that the text is refused with; empty when it is taken.
std::string sessionRefusal(const std::string& text) {
    try {
        parsed(text);
    } catch (const Error& error) {
        return error.message();
    }
    return {};
}

std::string session(const std::string& keys) {
    return R"({"type": "nephoscope-session", "version": 1, )" + keys + "}";
}

std::string slot(const std::string& keys) {
    return session("\"slots\": [{" + keys + "}]");
}

}  // namespace

TEST_CASE("A session reads back from its file bit for bit") {
    const TemporaryFolder folder;
    const SessionState state = full(folder.path());
    saveSession(folder / "a.json", state);
    std::vector<std::string> warnings;
    CHECK(loadSession(folder / "a.json", warnings) == state);
    CHECK(warnings.empty());
    SessionState plain;
    plain.slots.resize(1);
    saveSession(folder / "a.json", plain);
    CHECK(loadSession(folder / "a.json") == plain);
}

TEST_CASE("Data under the file's folder or beside it are found when all of it has moved") {
    const TemporaryFolder folder;
    const fs::path here = folder / "project/sessions";
    fs::create_directories(here / "run");
    fs::create_directories(folder / "project/wrf");
    SessionState state;
    state.slots.resize(1);
    state.slots[0].data = {(here / "run/").string(), (folder / "project/wrf/a.nc").string(),
                           "/far/away/b.nc", "cumulus", here.string()};
    const std::string text = formatSession(state, here);
    CHECK(contains(text, R"("data": ["./run","../wrf/a.nc","/far/away/b.nc","cumulus","./."])"));
    std::vector<std::string> warnings;
    const SessionState moved = parseSession(text, "", "/new/place/sessions", warnings);
    CHECK(moved.slots[0].data == std::vector<std::string>{"/new/place/sessions/run",
                                                          "/new/place/wrf/a.nc", "/far/away/b.nc",
                                                          "cumulus", "/new/place/sessions"});
}

TEST_CASE("A name without a slash is a file beside the session where there is one") {
    const TemporaryFolder folder;
    std::ofstream(folder / "wrfout_d01") << "x";
    std::vector<std::string> warnings;
    const SessionState state =
        parseSession(slot(R"("data": ["wrfout_d01", "supercell"])"), "", folder.path(), warnings);
    CHECK(state.slots[0].data ==
          std::vector<std::string>{(folder / "wrfout_d01").string(), "supercell"});
}

TEST_CASE("Keys of a session that are missing take their defaults") {
    const SessionState state = parsed(slot(""));
    SessionState expected;
    expected.slots.resize(1);
    CHECK(state == expected);
}

TEST_CASE("Sessions from when looks held the sampling are read in full") {
    const SessionState old =
        parsed(slot(R"("look": {"view.quality": 2, "view.seed": 7, "view.exposure": 1})"));
    CHECK(old.slots[0].document.sampling == Sampling{.quality = 2.0f, .seed = 7});
    CHECK(old.slots[0].document.look.exposureEv == 1.0f);
    std::vector<std::string> warnings;
    const std::string text = slot(R"("sampling": {"view.seed": 7, "view.exposure": 1})");
    const SessionState state = parseSession(text, "my.json", "/data", warnings);
    CHECK(state.slots[0].document.sampling == Sampling{.seed = 7});
    CHECK(state.slots[0].document.look == Look{});
    REQUIRE(warnings.size() == 1);
    CHECK(contains(warnings[0], "my.json: slot A"));
    CHECK(contains(warnings[0], "view.exposure"));
}

TEST_CASE("Unknown keys of a session are left out with a warning that says where") {
    std::vector<std::string> warnings;
    parseSession(session(R"("splt_at": 0.5, "slots": [{}, {"camra": {}, "look": {"x": 1}}])"),
                 "my.json", "/data", warnings);
    REQUIRE(warnings.size() == 3);
    CHECK(contains(warnings[0], "\"split_at\"?"));
    CHECK(contains(warnings[1], "my.json: slot B"));
    CHECK(contains(warnings[1], "\"camera\"?"));
    CHECK(contains(warnings[2], "my.json: slot B"));
}

TEST_CASE("A wrong value in a session is refused with file, key and what is expected") {
    struct Case {
        std::string text;
        const char* key;
        const char* expected;
    };
    for (const Case& c :
         {Case{session(R"("active": 0)"), "slots", "one or two"},
          Case{session(R"("slots": [])"), "slots", "1 to 2"},
          Case{session(R"("slots": [{}, {}, {}])"), "slots", "1 to 2"},
          Case{session(R"("slots": [3])"), "slots", "braces"},
          Case{session(R"("slots": [{}], "active": 1)"), "active", "from 0 to 0"},
          Case{session(R"("slots": [{}], "active": -1)"), "active", "from 0 to 0"},
          Case{session(R"("slots": [{}], "compare": "both")"), "compare", "\"split\""},
          Case{session(R"("slots": [{}], "compare": 1)"), "compare", "quotes"},
          Case{session(R"("slots": [{}], "split_at": 1.5)"), "split_at", "0 to 1"},
          Case{session(R"("slots": [{}], "linked_times": 1)"), "linked_times", "true or false"},
          Case{slot(R"("data": "x")"), "data", "list"},
          Case{slot(R"("data": [""])"), "data", "names"},
          Case{slot(R"("data": [7])"), "data", "names"},
          Case{slot(R"("data": ["a\u0000b"])"), "data", "names"},
          Case{slot(R"("time": -1)"), "time", "whole number"},
          Case{slot(R"("time": 1.5)"), "time", "whole number"},
          Case{slot(R"("time": 1e12)"), "time", "whole number"},
          Case{slot(R"("region": {"lower_m": [0, 0, 0], "upper_m": [1, 0, 1]})"), "region", "less"},
          Case{slot(R"("region": {"lower_m": [0, 0]})"), "lower_m", "list of 3"},
          Case{slot(R"("region": {"lower_m": [0, 0, "a"]})"), "lower_m", "null"},
          Case{slot(R"("look": {"cloud.mixing_scale": 1000})"), "cloud.mixing_scale", "100"},
          Case{slot(R"("look": 1)"), "look", "braces"},
          Case{slot(R"("sampling": {"view.quality": 9})"), "view.quality", "8"},
          Case{slot(R"("sampling": [])"), "sampling", "braces"},
          Case{slot(R"("camera": {"fov_deg": 500})"), "fov_deg", "from"},
          Case{slot(R"("bookmarks": [{"camera": {"fov_deg": 500}}])"), "fov_deg", "from"},
          Case{slot(R"("bookmarks": [{"name": 1}])"), "name", "quotes"},
          Case{slot(R"("pins": [{"label": "a", "position_m": [1, 2]}])"), "position_m", "3"},
          Case{slot(R"("pins": [{"label": "a", "position_m": [1, 2, "3"]}])"), "position_m",
               "three lengths"},
          Case{slot(R"("pins": [{"label": "a"}])"), "position_m", "three lengths"},
          Case{slot(R"("path": {"keys": [{"at_s": -1, "camera": {}}]})"), "at_s", "0"},
          Case{slot(R"("path": [])"), "path", "braces"}}) {
        CAPTURE(c.text);
        const std::string text = sessionRefusal(c.text);
        CHECK(contains(text, "my.json"));
        CHECK(contains(text, c.key));
        CHECK(contains(text, c.expected));
    }
}

TEST_CASE("What is no session is refused by what it is") {
    CHECK(contains(sessionRefusal(R"({"type": "nephoscope-look", "version": 1})"),
                   "nephoscope-look"));
    CHECK(contains(sessionRefusal(R"({"type": "nephoscope-session", "version": 2})"), "version"));
    CHECK(contains(sessionRefusal("[1]"), "session"));
    CHECK(contains(sessionRefusal(slot(R"("time": 1, "time": 2)")), "\"time\" stands twice"));
    CHECK(contains(sessionRefusal(std::string(100000, '[')), "deep"));
    const std::string whole = formatSession(full("/data"), "/data");
    for (std::size_t size = 0; size + 2 < whole.size(); size += 101) {
        if (sessionRefusal(whole.substr(0, size)).empty()) FAIL("taken at " << size);
    }
    const TemporaryFolder folder;
    CHECK_THROWS_AS(loadSession(folder / "missing.json"), Error);
    CHECK_THROWS_WITH_AS(loadSession("/dev/zero"), doctest::Contains("16 MiB"), Error);
}

TEST_CASE("No camera and no file name keeps a session from being read again") {
    SessionState state;
    state.slots.resize(1);
    state.slots[0].document.camera.azimuthDeg = 725.0f;
    state.slots[0].document.camera.target.z = 9.0f;
    state.slots[0].data = {"/data/\xff\xfe"};
    const SessionState again = parsed(formatSession(state, "/data"));
    CHECK(again.slots[0].document.camera.target.z == kMaxTarget);
    CHECK(again.slots[0].data.size() == 1);
}
