// session_memory_test.cpp: what a session holds, reads ahead, cuts out and notices, with made-up
// data that count their reads.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <fstream>

#include "core/volume/memory_setting.h"
#include "tests/core/fake_series.h"
#include "tests/temporary_folder.h"
#include "tests/text.h"

using namespace neph;

namespace {

using namespace std::chrono_literals;

constexpr std::uint64_t kVolumeBytes = 8 * 8 * 4 * sizeof(float);  // one species of FakeDataset

/// Polls until `done`, and says whether it came to that within ten seconds.
bool pollUntil(Session& session, const auto& done) {
    const auto until = std::chrono::steady_clock::now() + 10s;
    while (std::chrono::steady_clock::now() < until) {
        session.poll();
        if (done()) return true;
        std::this_thread::sleep_for(1ms);
    }
    return false;
}

/// A session on FakeSeries, opened at time 0 of a file that may be appended to.
struct Opened {
    explicit Opened(std::uint64_t volumes = 100, int first = 0) {
        std::ofstream(folder / "fake") << "0";
        session.setBudget({volumes * kVolumeBytes, kSoftwareGpuBytes});
        session.open(std::array{(folder / "fake").string()}, first);
        REQUIRE(pollUntil(session, [&] { return session.shown() != nullptr; }));
    }
    void grow() const { std::ofstream(folder / "fake", std::ios::app) << "more"; }
    bool showsTime(int time) {
        return pollUntil(session, [&] {
            return !session.loading() && session.document.time == time &&
                   session.shown()->timeLabel == "time " + std::to_string(time);
        });
    }
    VolumeKey keyOf(int time) const {
        const RadiusPlan radii = planRadii(session.document.look, *session.info());
        return {time, (folder / "fake").string(), {{}, session.budget(), radii}};
    }
    bool says(std::string_view text) const {
        return std::ranges::any_of(
            session.messages, [&](const Message& message) { return contains(message.text, text); });
    }

    const TemporaryFolder folder;
    std::shared_ptr<FakeSeries> series = std::make_shared<FakeSeries>();
    Session session{openFake(series), {}, 5ms};
};

}  // namespace

TEST_CASE("The next times are read ahead, and one that was is shown by the very next poll") {
    Opened opened;
    Session& session = opened.session;
    REQUIRE(pollUntil(session, [&] { return session.timesHeld() == 6; }));
    CHECK_FALSE(session.loading());
    session.takeVolume();
    session.document.time = 4;
    session.poll();
    CHECK(session.shown()->timeLabel == "time 4");
    CHECK(session.takeVolume() != nullptr);
    for (int time = 0; time < 6; ++time) CHECK(opened.series->readsOf(time) == 1);
}

TEST_CASE("Never more is held than the bound, and the nearest times in the direction of steps") {
    Opened opened(3, 2);
    Session& session = opened.session;
    REQUIRE(pollUntil(session, [&] { return session.timesHeld() == 3; }));
    for (const int time : {3, 4, 5, 4, 3}) {
        session.document.time = time;
        REQUIRE(opened.showsTime(time));
        CHECK(session.cache().bytes() <= 3 * kVolumeBytes);
    }
    // Backwards from 3: 2 is next, 4 is behind.
    REQUIRE(pollUntil(session, [&] { return session.cache().holds(opened.keyOf(2)); }));
    const int before = opened.series->readsOf(2);
    session.document.time = 2;
    session.poll();
    CHECK(session.shown()->timeLabel == "time 2");
    CHECK(opened.series->readsOf(2) == before);
}

TEST_CASE("A bound of one volume reads nothing ahead") {
    Opened opened(1);
    std::this_thread::sleep_for(50ms);
    for (int i = 0; i < 20; ++i) opened.session.poll();
    CHECK(opened.series->readsOf(1) == 0);
    opened.session.document.time = 1;
    REQUIRE(opened.showsTime(1));
    CHECK(opened.session.cache().count() == 1);
}

TEST_CASE("Reading ahead yields to what is asked for, and is not begun again where it is that") {
    Opened opened;
    Session& session = opened.session;
    REQUIRE(pollUntil(session, [&] { return session.timesHeld() == 6; }));
    opened.series->times = 50;
    opened.series->slowMs = 300;
    session.open(std::array{(opened.folder / "fake").string()}, 0);
    REQUIRE(pollUntil(session, [&] { return session.info()->times.size() == 50; }));
    session.poll();  // begins to read time 1 ahead
    CHECK_FALSE(session.loading());
    session.document.time = 40;
    session.poll();
    CHECK(session.loading());
    const auto asked = std::chrono::steady_clock::now();
    REQUIRE(opened.showsTime(40));
    // Two reads of 300 ms one after the other would take 600.
    CHECK(std::chrono::steady_clock::now() - asked < 550ms);
    CHECK(opened.series->readsOf(1) == 1);  // by the first opening
}

TEST_CASE("A part of the domain is read alone, and undo and the eye's place stay") {
    Opened opened;
    Session& session = opened.session;
    session.document.camera.target = {0.5f, 0.5f, 0.5f};
    session.history.commit(session.document);
    session.document.look.exposureEv = 1.0f;
    session.history.commit(session.document);
    const Camera before = placeCamera(session.document.camera, session.shown()->grid, 1.0);
    session.setRegion(BoxM{{2000.0, 1000.0, -1e9}, {6000.0, 5000.0, 1e9}});
    REQUIRE(pollUntil(session, [&] { return session.shown()->grid.size.x == 4; }));
    CHECK(session.shown()->grid.originM == glm::dvec3(2000.0, 1000.0, 0.0));
    const Camera now = placeCamera(session.document.camera, session.shown()->grid, 1.0);
    CHECK(glm::length(now.eyeWorld - before.eyeWorld) < 1.0);
    CHECK(session.undo());
    CHECK(session.document.look.exposureEv == Look{}.exposureEv);
    const Camera undone = placeCamera(session.document.camera, session.shown()->grid, 1.0);
    CHECK(glm::length(undone.eyeWorld - before.eyeWorld) < 1.0);
    session.setRegion({});
    REQUIRE(pollUntil(session, [&] { return session.shown()->grid.size.x == 8; }));
}

TEST_CASE("The clouds' place is known: columns 2 to 4 of the lowest layer") {
    Opened opened;
    REQUIRE(opened.session.shown()->clouds.has_value());
    const BoxM clouds = *opened.session.shown()->clouds;
    CHECK(clouds.lowerM == glm::dvec3(2000.0, 0.0, 0.0));
    CHECK(clouds.upperM == glm::dvec3(5000.0, 8000.0, 500.0));
    CHECK(withMargin(clouds).upperM.x == doctest::Approx(5300.0));
}

TEST_CASE("A histogram counts each cell that holds something, in the decade of its value") {
    SpeciesVolume volume;
    volume.grid.size = {4, 2, 1};
    Array3f& cloud = volume.contentKgPerM3[static_cast<std::size_t>(Species::cloud)];
    cloud = Array3f(volume.grid.size);
    // kg/m³: two of 1.1 g/m³, one of 0.02 g/m³, one too small and one too large for the bins.
    cloud.values = {1.1e-3f, 1.1e-3f, 2e-5f, 1e-12f, 1.0f, 0.0f, 0.0f, 0.0f};
    const VolumeSummary summary = summarise(volume);
    const FieldHistogram& histogram = summary.histograms[static_cast<std::size_t>(Species::cloud)];
    CHECK(histogram.holding == Holding::content);
    CHECK(histogram.filled() == 5);
    CHECK(histogram.below == 1);
    CHECK(histogram.above == 1);
    CHECK(histogram.least == 1e-12f);
    CHECK(histogram.most == 1.0f);
    const auto countFrom = [&](double lower) {
        for (int bin = 0; bin < FieldHistogram::kBins; ++bin) {
            const double bound = FieldHistogram::lowerBound(Holding::content, bin);
            if (std::abs(bound / lower - 1.0) < 1e-9)
                return static_cast<int>(histogram.cells[static_cast<std::size_t>(bin)]);
        }
        return -1;
    };
    CHECK(countFrom(1e-3) == 2);
    CHECK(countFrom(1.7782794100389228e-5) == 1);  // 10^(-4.75)
    CHECK(countFrom(1e-4) == 0);
    CHECK(summary.histograms[static_cast<std::size_t>(Species::rain)].filled() == 0);
}

TEST_CASE("A region without a cell is an error, and what was shown stays") {
    Opened opened;
    Session& session = opened.session;
    session.setRegion(BoxM{{90e3, 90e3, 0.0}, {95e3, 95e3, 1e3}});
    REQUIRE(pollUntil(session, [&] { return opened.says("holds no cell"); }));
    CHECK_FALSE(session.region().has_value());
    CHECK(session.shown()->grid.size.x == 8);
}

TEST_CASE("A smaller budget has the data averaged and says so") {
    Opened opened;
    Session& session = opened.session;
    session.setBudget({kVolumeBytes / 2, kSoftwareGpuBytes});
    REQUIRE(pollUntil(session, [&] { return session.shown()->plan.coarsening == 2; }));
    CHECK(session.shown()->grid.size == glm::ivec3(4, 4, 4));
    CHECK(session.cache().bytes() == kVolumeBytes / 4);
    CHECK(opened.says("averaged"));
}

TEST_CASE("New times of a grown file are noticed, and the shown time stays") {
    Opened opened;
    Session& session = opened.session;
    opened.session.document.time = 5;
    REQUIRE(opened.showsTime(5));
    opened.series->times = 8;
    opened.grow();
    REQUIRE(pollUntil(session, [&] { return session.info()->times.size() == 8; }));
    CHECK(opened.says("2 new times, up to time 7"));
    REQUIRE(opened.showsTime(5));
    // The last one that the file had may have been half written.
    REQUIRE(pollUntil(session, [&] { return session.timesHeld() == 8; }));
    CHECK(opened.series->readsOf(5) == 2);
    CHECK(opened.series->readsOf(4) == 1);
}

TEST_CASE("Whoever follows goes from the last time to the new last one, and nobody else") {
    Opened opened;
    Session& session = opened.session;
    session.follow = true;
    opened.series->times = 7;
    opened.grow();
    REQUIRE(pollUntil(session, [&] { return session.info()->times.size() == 7; }));
    CHECK(opened.showsTime(0));
    session.document.time = 6;
    REQUIRE(opened.showsTime(6));
    opened.series->times = 8;
    opened.grow();
    CHECK(opened.showsTime(7));
}

TEST_CASE("A half-written last time is no error, and is shown when it is whole") {
    Opened opened;
    Session& session = opened.session;
    session.follow = true;
    session.document.time = 5;
    REQUIRE(opened.showsTime(5));
    opened.series->failing = 6;
    opened.series->times = 7;
    opened.grow();
    REQUIRE(pollUntil(session, [&] { return opened.says("half written"); }));
    CHECK(std::ranges::none_of(session.messages, [](const Message& message) {
        return message.kind == Message::Kind::error;
    }));
    REQUIRE(opened.showsTime(5));
    opened.series->failing = -1;
    opened.grow();
    CHECK(opened.showsTime(6));
}

TEST_CASE("A time that cannot be read goes back to what was shown, and can be asked for again") {
    Opened opened(1);
    Session& session = opened.session;
    opened.series->failing = 3;
    for (int i = 0; i < 2; ++i) {
        session.messages.clear();
        session.document.time = 3;
        REQUIRE(pollUntil(session, [&] { return opened.says("half written"); }));
        CHECK(session.messages.back().kind == Message::Kind::error);
        CHECK(session.document.time == 0);
    }
}
