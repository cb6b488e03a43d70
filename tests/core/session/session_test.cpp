// session_test.cpp: opening, changing time and failing, with the bundled storm.
#include "core/session/session.h"

#include <doctest/doctest.h>

#include <array>
#include <chrono>
#include <fstream>
#include <thread>

#include "core/dataset/file_list.h"
#include "tests/temporary_folder.h"

using namespace neph;

namespace {

PluginHost testHost() {
    const std::array<std::filesystem::path, 1> places{NEPH_TEST_READER_DIR};
    return PluginHost(places);
}

/// Polls until nothing is under way; false after a minute.
bool settle(Session& session) {
    for (int i = 0; i < 60000; ++i) {
        session.poll();
        if (!session.loading()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
}

const std::string kStorm = NEPH_TEST_SOURCE_DIR "/samples/supercell";

std::string lastMessage(const Session& session) {
    return session.messages.empty() ? "" : session.messages.back().text;
}

}  // namespace

TEST_CASE("Opening a series shows its middle time, and the volume is handed over once") {
    Session session(testHost());
    session.open(std::array{kStorm});
    CHECK(session.loading());
    CHECK(session.info() == nullptr);
    REQUIRE(settle(session));
    REQUIRE(session.info() != nullptr);
    CHECK(session.info()->times.size() == 4);
    CHECK(session.document.time == 1);
    REQUIRE(session.shown() != nullptr);
    CHECK(session.shown()->timeLabel == "0001-01-01_01:00:00");
    CHECK(session.shown()->present[static_cast<std::size_t>(Species::cloud)]);
    CHECK_FALSE(session.shown()->present[static_cast<std::size_t>(Species::hail)]);
    CHECK_FALSE(session.shown()->empty());
    CHECK(session.takeVolume() != nullptr);
    CHECK(session.takeVolume() == nullptr);
}

TEST_CASE("A change of the time in the document brings that time, the newest wish first") {
    Session session(testHost());
    session.open(std::array{kStorm}, 0);
    REQUIRE(settle(session));
    CHECK(session.shown()->timeLabel == "0001-01-01_00:30:00");
    for (const int time : {1, 2, 3, 1}) {
        session.document.time = time;
        session.poll();
    }
    REQUIRE(settle(session));
    CHECK(session.shown()->timeLabel == "0001-01-01_01:00:00");
    session.document.time = 99;
    REQUIRE(settle(session));
    session.poll();
    REQUIRE(settle(session));
    CHECK(session.document.time == 3);
    CHECK(session.shown()->timeLabel == "0001-01-01_02:00:00");
}

TEST_CASE("A file that cannot be read is a message, and the last good data stay") {
    const TemporaryFolder folder;
    std::ofstream(folder / "bad.nc") << "not model output";
    Session session(testHost());
    session.open(std::array{kStorm}, 1);
    REQUIRE(settle(session));
    session.open(std::array{(folder / "bad.nc").string()});
    REQUIRE(settle(session));
    REQUIRE_FALSE(session.messages.empty());
    CHECK(session.messages.back().kind == Message::Kind::error);
    CHECK(lastMessage(session).find("bad.nc") != std::string::npos);
    CHECK(session.messages.back().serial > session.settledSerial);
    CHECK(session.info()->times.size() == 4);
    CHECK(session.shown()->timeLabel == "0001-01-01_01:00:00");
    CHECK(session.document.time == 1);
}

TEST_CASE("Opening other data starts a new history at the look that is there") {
    Session session(testHost());
    session.document.look.exposureEv = 2.0f;
    session.open(std::array{kStorm}, -1);
    REQUIRE(settle(session));
    CHECK(session.document.time == 3);
    CHECK(session.document.look.exposureEv == 2.0f);
    CHECK_FALSE(session.undo());
}

TEST_CASE("Data of another domain ask for a camera of their own, unless one comes with them") {
    const std::string cumulus = NEPH_TEST_SOURCE_DIR "/samples/cumulus";
    Session session(testHost());
    session.open(std::array{kStorm}, 0, {}, true);  // as a session file that has its camera
    REQUIRE(settle(session));
    CHECK_FALSE(session.takeUnframed());
    session.open(std::array{kStorm}, 1);  // the same domain: the camera fits it still
    REQUIRE(settle(session));
    CHECK_FALSE(session.takeUnframed());
    session.open(std::array{cumulus});
    REQUIRE(settle(session));
    CHECK(session.takeUnframed());
    CHECK_FALSE(session.takeUnframed());  // once
    session.document.time = 0;
    REQUIRE(settle(session));
    CHECK_FALSE(session.takeUnframed());
}

TEST_CASE("Metres of an older preset become cells of the data, now or when there are some") {
    const std::string cumulus = NEPH_TEST_SOURCE_DIR "/samples/cumulus";  // cells of 67 m
    const TemporaryFolder folder;
    std::ofstream(folder / "old.json") << R"({"type": "nephoscope-look", "version": 1,
        "look": {"cloud.noise_scale": 670}})";
    const auto cells = [](const Look& look) { return look.of(Species::cloud).noiseScaleCells; };
    Session before(testHost()), after(testHost());
    REQUIRE(before.loadPreset((folder / "old.json").string()));
    before.open(std::array{cumulus});
    REQUIRE(settle(before));
    CHECK(cells(before.document.look) == doctest::Approx(10.0));
    CHECK(before.presetLook == before.document.look);  // nothing is shown as changed
    after.open(std::array{cumulus});
    REQUIRE(settle(after));
    REQUIRE(after.loadPreset((folder / "old.json").string()));
    CHECK(cells(after.document.look) == doctest::Approx(10.0));
    CHECK(after.presetLook == after.document.look);
    before.open(std::array{kStorm});  // cells now, and so they stay
    REQUIRE(settle(before));
    CHECK(cells(before.document.look) == doctest::Approx(10.0));
}

TEST_CASE("Loading a preset is one step that undo takes back") {
    const TemporaryFolder folder;
    Preset preset;
    preset.look.exposureEv = 1.5f;
    preset.look.of(Species::rain).visible = false;
    preset.camera = CameraPose{};
    preset.camera->distance = 0.3f;
    savePreset(folder / "mine.json", preset);
    Session session(testHost());
    const Document before = session.document;
    session.loadPreset((folder / "mine.json").string());
    CHECK(session.document.look == preset.look);
    CHECK(session.document.camera == *preset.camera);
    CHECK(session.homeCamera == *preset.camera);
    CHECK(session.presetName == (folder / "mine.json").string());
    CHECK(session.presetLook == preset.look);
    CHECK(session.undo());
    CHECK(session.document == before);
    CHECK(session.redo());
    CHECK(session.document.look == preset.look);
}

TEST_CASE("A preset that is wrong changes nothing and says why") {
    const TemporaryFolder folder;
    std::ofstream(folder / "bad.json") << "{";
    Session session(testHost());
    const Document before = session.document;
    session.loadPreset((folder / "bad.json").string());
    CHECK(session.document == before);
    REQUIRE_FALSE(session.messages.empty());
    CHECK(session.messages.back().kind == Message::Kind::error);
    session.loadPreset("no-such-preset");
    CHECK(lastMessage(session).find("no-such-preset") != std::string::npos);
}

TEST_CASE("A session may end while data are being opened") {
    for (int round = 0; round < 3; ++round) {
        Session session(testHost());
        session.open(std::array{kStorm});
        std::this_thread::sleep_for(std::chrono::milliseconds(20 * round));
    }
}

TEST_CASE("A folder stands for its files in order of name, nothing for the bundled storm") {
    const TemporaryFolder folder;
    std::ofstream(folder / "b") << "2";
    std::ofstream(folder / "a") << "1";
    std::ofstream(folder / ".hidden") << "0";
    std::filesystem::create_symlink("loop", folder / "loop");  // leads nowhere
    const auto files = filesIn(listFiles(std::array{folder.path().string()}));
    REQUIRE(files.size() == 2);
    CHECK(files[0].filename() == "a");
    CHECK(files[1].filename() == "b");
    CHECK(filesIn(listFiles({})).size() == 4);
    CHECK_THROWS_AS(listFiles(std::array{(folder / "missing").string()}), Error);
    const TemporaryFolder empty;
    CHECK(filesIn(std::array{empty.path()}).empty());
}

TEST_CASE(
    "A look that takes radii from the model has the time read again, and one that does not again") {
    Session session(testHost());
    session.open(std::array{kStorm});
    REQUIRE(settle(session));
    REQUIRE(session.takeVolume() != nullptr);
    session.document.look.of(Species::ice).mixingScale = 2.0f;
    REQUIRE(settle(session));
    CHECK(session.takeVolume() == nullptr);
    session.document.look.of(Species::ice).radiusSource = RadiusSource::file;
    REQUIRE(settle(session));
    const auto sized = session.takeVolume();
    REQUIRE(sized != nullptr);
    CHECK(sized->holding(Species::ice) == Holding::extinction);
    CHECK(sized->holding(Species::cloud) == Holding::content);
    session.document.look.of(Species::ice).radiusSource = RadiusSource::constant;
    REQUIRE(settle(session));
    const auto again = session.takeVolume();
    REQUIRE(again != nullptr);
    CHECK(again->holding(Species::ice) == Holding::content);
}
