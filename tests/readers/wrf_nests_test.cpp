// wrf_nests_test.cpp: domains of nested runs of WRF as one data set, and nests that move from file
// to file.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <thread>

#include "core/session/session.h"
#include "core/volume/held_volume.h"
#include "core/volume/nested_volume.h"
#include "tests/readers/nested_run.h"
#include "tests/readers/reader_host.h"
#include "tests/temporary_folder.h"

using namespace neph;

namespace {

const std::vector<std::string> kTwoTimes{"2021-08-14_18:00:00", "2021-08-14_18:10:00"};

const NestedDomain kOuter;
const NestedDomain kInner = kOuter.nest(2, 4, 3, 15, 12);

HeldVolume read(Dataset& dataset, int time, const VolumeRequest& request = {}) {
    return readVolume(dataset, time, request);
}

bool noted(const std::vector<std::string>& notes, std::string_view text) {
    return std::ranges::any_of(notes,
                               [&](const std::string& note) { return contains(note, text); });
}

float cloudAt(const HeldVolume& held, int x, int y) {
    return held.volume->content(Species::cloud).at(x, y, 1);
}

}  // namespace

TEST_CASE("Domains of one run are one data set, with the outermost one's place and times") {
    const TemporaryFolder folder;
    kOuter.write(folder / "wrfout_d01", kTwoTimes);
    kInner.write(folder / "wrfout_d02", kTwoTimes);
    for (const bool byFolder : {true, false}) {
        CAPTURE(byFolder);
        std::vector<std::filesystem::path> named{folder.path()};
        if (!byFolder) named = {folder / "wrfout_d02", folder / "wrfout_d01"};
        const auto dataset = openFiles(named);
        CHECK(dataset->info().size == glm::ivec3(12, 10, 5));
        REQUIRE(dataset->nests().size() == 1);
        const Nest& nest = dataset->nests()[0];
        CHECK(nest.name == "d02");
        CHECK(nest.ratio == 3);
        REQUIRE(nest.at.size() == 2);
        REQUIRE(nest.at[1].has_value());
        CHECK(nest.at[1]->time == 1);
        CHECK(nest.at[1]->cornerCells == glm::ivec2(9, 6));
        CHECK_FALSE(nest.moves());
        CHECK(hasNote(dataset->info(), "d02 (1 km) composed within d01 (3 km)"));
        CHECK_FALSE(hasNote(dataset->info(), "left out"));
        CHECK(dataset->filesAt(1) ==
              std::vector<std::filesystem::path>{folder / "wrfout_d01", folder / "wrfout_d02"});
    }
    CHECK(openFiles({folder / "wrfout_d02"})->nests().empty());
}

TEST_CASE("The volume of two domains is the nest inside, its parent outside, and mixed between") {
    const TemporaryFolder folder;
    kOuter.write(folder / "wrfout_d01", kTwoTimes);
    kInner.write(folder / "wrfout_d02", kTwoTimes);
    const auto dataset = openFiles({folder.path()});
    const HeldVolume held = read(*dataset, 1);
    const RegularGrid& grid = held.volume->grid;
    CHECK(grid.size == glm::ivec3(36, 30, grid.size.z));
    CHECK(grid.spacingM.x == doctest::Approx(1000.0));
    CHECK(held.volume->timeLabel == kTwoTimes[1]);
    CHECK(held.volume->nativeCellM == doctest::Approx(1000.0));
    const float outside = cloudAt(held, 0, 0);
    REQUIRE(outside > 0.0f);
    CHECK(cloudAt(held, 16, 12) == doctest::Approx(3.0f * outside).epsilon(1e-5));
    CHECK(cloudAt(held, 8, 12) == doctest::Approx(outside).epsilon(1e-5));
    for (int x = 9; x < 14; ++x) {
        CAPTURE(x);
        CHECK(cloudAt(held, x, 12) > cloudAt(held, x - 1, 12));
        CHECK(cloudAt(held, x, 12) < 3.0f * outside);
    }
    CHECK(contains(describe(held.summary.plan, dataset->info()),
                   "d02 (1 km) within d01 (3 km), shown at 1 km."));
}

TEST_CASE("A region shows the nests in it, and memory decides how finely") {
    const TemporaryFolder folder;
    kOuter.write(folder / "wrfout_d01", kTwoTimes);
    kInner.write(folder / "wrfout_d02", kTwoTimes);
    const auto dataset = openFiles({folder.path()});
    const ReadPlan full = planShown(*dataset, 0);
    VolumeRequest tight;
    tight.budget.gpu = full.gpuBytes / 4;
    const HeldVolume coarse = read(*dataset, 0, tight);
    CHECK(coarse.volume->grid.spacingM.x == doctest::Approx(2000.0));
    CHECK(contains(coarse.summary.plan.nested, "shown at 2 km: at 1 km it would take"));
    const BoxM east{{30000.0, 0.0, -1e4}, {36000.0, 30000.0, 1e5}};
    const ReadPlan apart = planShown(*dataset, 0, east);
    CHECK(apart.nested.empty());
    CHECK(apart.grid.spacingM.x == doctest::Approx(3000.0));
    // A part has the values that it has in the whole.
    VolumeRequest part;
    part.region = BoxM{{6000.0, 6000.0, -1e4}, {21000.0, 24000.0, 1e5}};
    const HeldVolume whole = read(*dataset, 0), some = read(*dataset, 0, part);
    REQUIRE(some.volume->grid.size == glm::ivec3(15, 18, whole.volume->grid.size.z));
    for (int y = 0; y < 18; ++y) {
        for (int x = 0; x < 15; ++x) {
            CHECK(cloudAt(some, x, y) == doctest::Approx(cloudAt(whole, x + 6, y + 6)));
        }
    }
    // So has a layer of it, on levels that are a subset.
    const RegularGrid& grid = whole.volume->grid;
    part.region->lowerM.z = grid.originM.z + 1.2 * grid.spacingM.z;
    part.region->upperM.z = grid.originM.z + 2.8 * grid.spacingM.z;
    const HeldVolume layer = read(*dataset, 0, part);
    REQUIRE(layer.volume->grid.size.z == 2);
    CHECK(layer.volume->grid.originM.z == doctest::Approx(grid.originM.z + grid.spacingM.z));
    CHECK(layer.volume->content(Species::cloud).at(8, 8, 0) ==
          doctest::Approx(cloudAt(whole, 14, 14)));
    CHECK(layer.summary.domainHeightsM.y == doctest::Approx(grid.upperM().z));
}

TEST_CASE("A nest without output at a time is absent there, and times in between are noted") {
    const TemporaryFolder folder;
    kOuter.write(folder / "wrfout_d01", kTwoTimes);
    kInner.write(folder / "wrfout_d02",
                 {"2021-08-14_18:05:00", "2021-08-14_18:09:58", "2021-08-14_18:15:00"});
    const auto dataset = openFiles({folder.path()});
    REQUIRE(dataset->nests().size() == 1);
    const Nest& nest = dataset->nests()[0];
    CHECK_FALSE(nest.at[0].has_value());
    REQUIRE(nest.at[1].has_value());
    CHECK(nest.at[1]->time == 1);
    CHECK(hasNote(dataset->info(), "d02 is there at 1 of the 2 times of d01"));
    CHECK(hasNote(dataset->info(), "d02 has 2 more times, at which d01 has none"));
    const HeldVolume without = read(*dataset, 0);
    CHECK(without.volume->grid.size.x == 12);
    CHECK(without.volume->cellM() == read(*dataset, 1).volume->cellM());
    CHECK(noted(without.volume->notes, "d02 is absent, without output at this time"));
}

TEST_CASE("Nests within nests, and siblings, are all composed") {
    const TemporaryFolder folder;
    const NestedDomain third = kInner.nest(3, 6, 5, 12, 12, 3);
    const NestedDomain sibling = kOuter.nest(4, 10, 7, 6, 6, 2);
    kOuter.write(folder / "wrfout_d01", kTwoTimes);
    kInner.write(folder / "wrfout_d02", kTwoTimes);
    third.write(folder / "wrfout_d03", kTwoTimes);
    sibling.write(folder / "wrfout_d04", kTwoTimes);
    const auto dataset = openFiles({folder.path()});
    REQUIRE(dataset->nests().size() == 3);
    CHECK(dataset->nests()[2].name == "d03");
    CHECK(dataset->nests()[2].ratio == 9);
    CHECK(dataset->nests()[2].at[0]->cornerCells == glm::ivec2(42, 30));
    CHECK(dataset->nests()[0].name == "d04");
    CHECK(dataset->nests()[0].at[0]->cornerCells == glm::ivec2(18, 12));
    // The middle of d03, in cells of a ninth of the outermost.
    const HeldVolume held = read(*dataset, 0);
    CHECK(held.volume->grid.size.x == 108);
    CHECK(cloudAt(held, 48, 36) == doctest::Approx(9.0f * cloudAt(held, 0, 0)).epsilon(1e-5));
}

TEST_CASE("An idealised run's domains are placed by the numbers of their parents") {
    const TemporaryFolder folder;
    const std::vector<std::string> time{"0001-01-01_00:00:00"};
    kOuter.write(folder / "wrfout_d01", time, false);
    kInner.write(folder / "wrfout_d02", time, false);
    kInner.nest(3, 6, 5, 12, 12, 3).write(folder / "wrfout_d03", time, false);
    const auto dataset = openFiles({folder.path()});
    REQUIRE(dataset->nests().size() == 2);
    CHECK(dataset->nests()[0].at[0]->cornerCells == glm::ivec2(9, 6));
    CHECK(dataset->nests()[1].ratio == 9);
    CHECK(dataset->nests()[1].at[0]->cornerCells == glm::ivec2(42, 30));
}

TEST_CASE("A nest of an idealised run moves by the corners in its parent") {
    const TemporaryFolder folder;
    kOuter.write(folder / "wrfout_d01", kTwoTimes, false);
    kInner.write(folder / "wrfout_d02_0", {kTwoTimes[0]}, false);
    kOuter.nest(2, 5, 2, 15, 12).write(folder / "wrfout_d02_1", {kTwoTimes[1]}, false);
    const auto dataset = openFiles({folder.path()});
    REQUIRE(dataset->nests().size() == 1);
    const Nest& nest = dataset->nests()[0];
    CHECK(nest.at[0]->cornerCells == glm::ivec2(9, 6));
    REQUIRE(nest.at[1].has_value());
    CHECK(nest.at[1]->cornerCells == glm::ivec2(12, 3));
    CHECK(nest.dataset->info().times[1].gridOffsetM == glm::dvec2(3000.0, -3000.0));
}

TEST_CASE("Domains that do not fit together are refused by name and left out of a folder") {
    const TemporaryFolder folder;
    kOuter.write(folder / "wrfout_d01", kTwoTimes);
    const auto refused = [&](const NestedDomain& other, std::string_view reason,
                             const std::vector<std::string>& times = kTwoTimes) {
        CAPTURE(reason);
        other.write(folder / "wrfout_d02", times);
        const ErrorParts error = errorOf([&] {
            openFiles({folder / "wrfout_d01", folder / "wrfout_d02"});
        });
        CHECK(contains(error.what, "its grid is not that of"));
        CHECK(contains(error.found, reason));
        const auto dataset = openFiles({folder.path()});
        CHECK(dataset->nests().empty());
        CHECK(dataset->info().size.x == 12);
        CHECK(hasNote(dataset->info(), reason));
    };
    NestedDomain elsewhere = kInner;
    elsewhere.cornerM.x += 15000.0;
    refused(elsewhere, "it reaches 3 km beyond the other's edge");
    NestedDomain between = kInner;
    between.cornerM.x += 500.0;
    refused(between, "of its cells off the other's grid");
    NestedDomain otherMap = kInner;
    otherMap.standLongitude = -95.0;
    refused(otherMap, "other's");
    refused(kInner, "they have no time in common", {"2021-08-15_00:00:00"});
    NestedDomain again = kInner;
    again.number = 1;
    refused(again, "both are d01");
}

TEST_CASE("A nest that moves from file to file is one series whose grid moves") {
    const TemporaryFolder folder;
    const std::vector<std::string> times{"2021-08-14_18:00:00", "2021-08-14_18:10:00",
                                         "2021-08-14_18:20:00"};
    std::vector<std::filesystem::path> files;
    for (int k = 0; k < 3; ++k) {
        files.push_back(folder / ("wrfout_d02_" + std::to_string(k)));
        kOuter.nest(2, 4 + k, 3 + (k > 1 ? 1 : 0), 15, 12)
            .write(files.back(), {times[static_cast<std::size_t>(k)]});
    }
    const auto alone = openFiles(files);
    const DatasetInfo& info = alone->info();
    REQUIRE(info.times.size() == 3);
    CHECK(info.moves());
    CHECK(info.times[1].gridOffsetM.x == doctest::Approx(3.0 * info.spacingM.x).epsilon(1e-12));
    CHECK(info.times[1].gridOffsetM.y == 0.0);
    CHECK(info.times[2].gridOffsetM.x == doctest::Approx(6.0 * info.spacingM.x).epsilon(1e-12));
    CHECK(info.times[2].gridOffsetM.y == doctest::Approx(3.0 * info.spacingM.y).epsilon(1e-12));
    CHECK(hasNote(info, "moves from file to file"));
    kOuter.write(folder / "wrfout_d01", times);
    const auto composed = openFiles({folder.path()});
    REQUIRE(composed->nests().size() == 1);
    const Nest& nest = composed->nests()[0];
    CHECK(nest.moves());
    CHECK(nest.at[0]->cornerCells == glm::ivec2(9, 6));
    CHECK(nest.at[2]->cornerCells == glm::ivec2(15, 9));
    CHECK_FALSE(composed->info().moves());
    const HeldVolume held = read(*composed, 2);
    CHECK(cloudAt(held, 22, 15) == doctest::Approx(3.0f * cloudAt(held, 0, 0)).epsilon(1e-5));
    CHECK(cloudAt(held, 14, 15) == doctest::Approx(cloudAt(held, 0, 0)).epsilon(1e-5));
}

TEST_CASE("Domains whose maps have other central longitudes are placed by where they lie") {
    // On Mercator's map longitudes are counted from the middle of each domain.
    const TemporaryFolder folder;
    NestedDomain outer;
    outer.mercator = true;
    outer.cornerM = {-15000.0, 2.9e6};
    outer.write(folder / "wrfout_d01", kTwoTimes);
    outer.nest(2, 4, 3, 15, 12).write(folder / "wrfout_d02_0", {kTwoTimes[0]});
    outer.nest(2, 6, 2, 15, 12).write(folder / "wrfout_d02_1", {kTwoTimes[1]});
    const auto dataset = openFiles({folder.path()});
    REQUIRE(dataset->nests().size() == 1);
    const Nest& nest = dataset->nests()[0];
    const DatasetInfo& info = nest.dataset->info();
    CHECK(info.map.projection != dataset->info().map.projection);
    CHECK(nest.at[0]->cornerCells == glm::ivec2(9, 6));
    CHECK(nest.at[1]->cornerCells == glm::ivec2(15, 3));
    CHECK(info.times[1].gridOffsetM.x == doctest::Approx(6.0 * info.spacingM.x).epsilon(1e-12));
}

TEST_CASE("A nest in another place at the same time, or off its own cells, is another nest") {
    const TemporaryFolder folder;
    kInner.write(folder / "a", {kTwoTimes[0]});
    kOuter.nest(2, 5, 3, 15, 12).write(folder / "b", {kTwoTimes[0]});
    CHECK(contains(errorOf([&] {
                       openFiles({folder / "a", folder / "b"});
                   }).what,
                   "its grid is not that of"));
    NestedDomain off = kInner;
    off.cornerM.x += 500.0;
    off.write(folder / "b", {kTwoTimes[1]});
    CHECK(contains(errorOf([&] {
                       openFiles({folder / "a", folder / "b"});
                   }).what,
                   "its grid is not that of"));
}

TEST_CASE("A nest that gets output while its run is open is shown where there was none") {
    const TemporaryFolder folder;
    kOuter.write(folder / "wrfout_d01", kTwoTimes);
    kInner.write(folder / "wrfout_d02_a", {kTwoTimes[0]});
    Session session(
        [](std::span<const std::filesystem::path> paths, const Progress& progress) {
            return Dataset::open(paths, readerHost(), {}, progress);
        },
        {}, std::chrono::milliseconds(1));
    const auto shows = [&](double spacingM) {
        for (int i = 0; i < 10000; ++i) {
            session.poll();
            if (session.shown() != nullptr && session.shows(1) &&
                std::abs(session.shown()->grid.spacingM.x - spacingM) < 1.0) {
                return true;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return false;
    };
    session.open(std::array<std::string, 1>{folder.path().string()}, 1);
    REQUIRE(shows(3000.0));
    kInner.write(folder / "wrfout_d02_b", {kTwoTimes[1]});
    session.lookForGrowth();
    CHECK(shows(1000.0));
    CHECK(noted(session.held()->volume->notes, "d02") == false);
}
