// series_watch_test.cpp: growth is told once, when it has come to rest.
#include "core/dataset/series_watch.h"

#include <doctest/doctest.h>

#include <array>
#include <atomic>
#include <fstream>

#include "tests/temporary_folder.h"

using namespace neph;

namespace {

using namespace std::chrono_literals;

std::optional<std::vector<FileStamp>> waitForChange(SeriesWatch& watch) {
    for (int i = 0; i < 5000; ++i) {
        if (auto change = watch.takeChange()) return change;
        std::this_thread::sleep_for(1ms);
    }
    return {};
}

}  // namespace

TEST_CASE("A file that grows and a new file in a folder are told once each") {
    const TemporaryFolder folder;
    std::ofstream(folder / "a") << "1";
    const std::vector<std::filesystem::path> paths{folder.path()};
    std::atomic<int> woken = 0;
    SeriesWatch watch([&] { ++woken; }, 2ms);
    watch.watch(paths, stampsOf(paths));
    std::this_thread::sleep_for(30ms);
    CHECK_FALSE(watch.takeChange().has_value());
    std::ofstream(folder / "a", std::ios::app) << "2";
    const auto grown = waitForChange(watch);
    REQUIRE(grown.has_value());
    REQUIRE(grown->size() == 1);
    CHECK(grown->front().bytes == 2);
    CHECK(woken >= 1);
    std::ofstream(folder / "b") << "1";
    const auto more = waitForChange(watch);
    REQUIRE(more.has_value());
    CHECK(more->size() == 2);
    std::this_thread::sleep_for(30ms);
    CHECK_FALSE(watch.takeChange().has_value());
}

TEST_CASE("What grew between reading and watching is told, too") {
    const TemporaryFolder folder;
    std::ofstream(folder / "a") << "1";
    const std::vector<std::filesystem::path> paths{folder / "a"};
    const auto seen = stampsOf(paths);
    std::ofstream(folder / "a", std::ios::app) << "2";
    SeriesWatch watch({}, 2ms);
    watch.watch(paths, seen);
    CHECK(waitForChange(watch).has_value());
}

TEST_CASE("While a file grows from look to look it is left alone, but not for ever") {
    const TemporaryFolder folder;
    std::ofstream file(folder / "a");
    const std::vector<std::filesystem::path> paths{folder / "a"};
    SeriesWatch watch({}, 20ms);
    watch.watch(paths, stampsOf(paths));
    int writes = 0;
    std::optional<std::vector<FileStamp>> change;
    for (; writes < 2000 && !change; ++writes) {
        file << "more" << std::flush;
        std::this_thread::sleep_for(1ms);
        change = watch.takeChange();
    }
    REQUIRE(change.has_value());
    CHECK(writes > 40);  // not at the second look
}

TEST_CASE("Nothing is told once nothing is watched, and a look can be asked for") {
    const TemporaryFolder folder;
    std::ofstream(folder / "a") << "1";
    const std::vector<std::filesystem::path> paths{folder / "a"};
    SeriesWatch watch({}, 1h);
    watch.watch(paths, stampsOf(paths));
    std::ofstream(folder / "a", std::ios::app) << "2";
    std::optional<std::vector<FileStamp>> change;
    for (int i = 0; i < 1000 && !change; ++i) {
        watch.lookNow();
        std::this_thread::sleep_for(2ms);
        change = watch.takeChange();
    }
    CHECK(change.has_value());
    watch.stop();
    std::ofstream(folder / "a", std::ios::app) << "3";
    watch.lookNow();
    std::this_thread::sleep_for(20ms);
    CHECK_FALSE(watch.takeChange().has_value());
}
