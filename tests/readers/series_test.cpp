// series_test.cpp: many files as one series.
#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>

#include "core/volume/resample.h"
#include "tests/readers/reader_host.h"
#include "tests/readers/wrf_maker.h"
#include "tests/temporary_folder.h"

using namespace neph;

namespace {

WrfSpec at(std::vector<std::string> times, float value) {
    WrfSpec spec;
    spec.times = std::move(times);
    spec.fields["QCLOUD"] = [value](int, int, int, int t) {
        return value + 0.1f * static_cast<float>(t);
    };
    return spec;
}

}  // namespace

TEST_CASE("Files given in any order become one series, sorted by time") {
    const TemporaryFolder folder;
    writeWrf(folder / "z", at({"2024-02-28_23:00:00"}, 1.0f));
    writeWrf(folder / "m", at({"2024-03-01_01:00:00"}, 3.0f));
    writeWrf(folder / "a", at({"2024-02-29_00:00:00", "2024-02-29_12:00:00"}, 2.0f));
    const auto dataset = openFiles({folder / "m", folder / "a", folder / "z"});
    const auto& times = dataset->info().times;
    REQUIRE(times.size() == 4);
    CHECK(times[0].seconds == 0.0);
    CHECK(times[1].seconds == 3600.0);
    CHECK(times[3].seconds == 26.0 * 3600.0);  // 2024 is a leap year
    CHECK(times[2].indexInFile == 1);
    CHECK(times[2].file == folder / "a");
    CHECK(dataset->read("QCLOUD", 0).at(0, 0, 0) == 1.0f);
    CHECK(dataset->read("QCLOUD", 2).at(0, 0, 0) == doctest::Approx(2.1f));
    CHECK(dataset->read("QCLOUD", 3).at(0, 0, 0) == 3.0f);
    CHECK(dataset->read("QCLOUD", 1).at(0, 0, 0) == 2.0f);
}

TEST_CASE("A time that two files contain is kept once, and a note names both files") {
    const TemporaryFolder folder;
    writeWrf(folder / "first", at({"2024-05-06_21:00:00", "2024-05-06_22:00:00"}, 1.0f));
    writeWrf(folder / "restart", at({"2024-05-06_22:00:00", "2024-05-06_23:00:00"}, 5.0f));
    const auto dataset = openFiles({folder / "first", folder / "restart"});
    CHECK(dataset->info().times.size() == 3);
    REQUIRE(dataset->info().notes.size() == 1);
    const std::string& note = dataset->info().notes[0];
    CHECK(contains(note, "2024-05-06_22:00:00"));
    CHECK(contains(note, "first"));
    CHECK(contains(note, "restart"));
    CHECK(dataset->read("QCLOUD", 1).at(0, 0, 0) == doctest::Approx(1.1f));
}

TEST_CASE("Files on different grids are not one series; the error names both and their sizes") {
    const TemporaryFolder folder;
    writeWrf(folder / "d01", {});
    WrfSpec nested;
    nested.nx = 7;
    writeWrf(folder / "d02", nested);
    const ErrorParts error = errorOf([&] { openFiles({folder / "d01", folder / "d02"}); });
    CHECK(contains(error.where, "d02"));
    CHECK(contains(error.what, "d01"));
    CHECK(contains(error.found, "7 x 3 x 5"));
    CHECK(contains(error.expected, "4 x 3 x 5"));
    WrfSpec finer;
    finer.dx = 333.0f;
    writeWrf(folder / "fine", finer);
    CHECK(contains(errorOf([&] { openFiles({folder / "d01", folder / "fine"}); }).found, "333"));
}

TEST_CASE("A variable that only some files contain is an error at the times without it") {
    const TemporaryFolder folder;
    WrfSpec with = at({"2024-05-06_21:00:00"}, 1.0f);
    with.fields["QSNOW"] = [](int, int, int, int) { return 0.5f; };
    writeWrf(folder / "with", with);
    writeWrf(folder / "without", at({"2024-05-06_22:00:00"}, 1.0f));
    const auto dataset = openFiles({folder / "with", folder / "without"});
    CHECK(dataset->read("QSNOW", 0).at(0, 0, 0) == 0.5f);
    const ErrorParts error = errorOf([&] { dataset->read("QSNOW", 1); });
    CHECK(contains(error.where, "without"));
    CHECK(contains(error.what, "QSNOW"));
    CHECK(contains(error.expected, "other files"));
    CHECK(!error.hint.empty());
}

TEST_CASE("A hydrometeor that only some files contain is drawn where it is, and named where not") {
    const TemporaryFolder folder;
    WrfSpec with = at({"2024-05-06_21:00:00"}, 1e-3f);
    with.fields["QSNOW"] = [](int, int, int, int) { return 2e-3f; };
    writeWrf(folder / "with", with);
    WrfSpec without;
    without.times = {"2024-05-06_22:00:00"};
    without.fields["QCLOUD"] = [](int, int, int, int) { return 1e-3f; };
    writeWrf(folder / "without", without);
    for (const char* first : {"with", "without"}) {
        CAPTURE(first);
        const auto dataset = openFiles(
            {folder / first, folder / (first == std::string("with") ? "without" : "with")});
        CHECK(dataset->has("QSNOW", 0));
        CHECK(!dataset->has("QSNOW", 1));
        CHECK(!dataset->has("QNOTHING", 0));
        CHECK(dataset->infoAt(1).find("QSNOW") == nullptr);
        CHECK(dataset->infoAt(0).find("QSNOW") != nullptr);
        CHECK(resample(*dataset, 0).has(Species::snow));
        const SpeciesVolume later = resample(*dataset, 1);
        CHECK(!later.has(Species::snow));
        CHECK(later.has(Species::cloud));
        CHECK(std::ranges::any_of(later.notes, [](const std::string& note) {
            return contains(note, "QSNOW is not in without: there is no snow at this time");
        }));
    }
}

TEST_CASE("Opening a series can be cancelled") {
    const TemporaryFolder folder;
    writeWrf(folder / "a", {});
    const std::vector<std::filesystem::path> files{folder / "a"};
    CHECK_THROWS_AS(Dataset::open(files, readerHost(), [](double) { return false; }), Cancelled);
}

TEST_CASE("A file that was replaced since it was opened is an error, not another field") {
    const TemporaryFolder folder;
    writeWrf(folder / "a", at({"2024-05-06_21:00:00"}, 1.0f));
    writeWrf(folder / "b", at({"2024-05-06_22:00:00"}, 2.0f));
    const auto dataset = openFiles({folder / "a", folder / "b"});
    std::filesystem::remove(folder / "a");
    writeWrf(folder / "a", at({"2024-05-06_23:00:00"}, 3.0f));
    CHECK(contains(errorOf([&] { dataset->read("QCLOUD", 0); }).what, "has changed"));
    CHECK(dataset->read("QCLOUD", 1).at(0, 0, 0) == 2.0f);
}

namespace {

bool noted(const Dataset& dataset, std::string_view text) {
    return std::ranges::any_of(dataset.info().notes,
                               [&](const std::string& note) { return contains(note, text); });
}

}  // namespace

TEST_CASE("A folder is opened as the series in it; other files are left out with one note") {
    const TemporaryFolder folder;
    writeWrf(folder / "wrfout_d01_a", at({"2024-05-06_21:00:00"}, 1.0f));
    writeWrf(folder / "wrfout_d01_b", at({"2024-05-06_22:00:00"}, 2.0f));
    WrfSpec nested = at({"2024-05-06_21:00:00"}, 3.0f);
    nested.nx = 7;
    writeWrf(folder / "wrfout_d02_a", nested);
    writeOtherNetcdf(folder / "met_em.d01.nc");
    for (const char* name : {"namelist.input", "rsl.error.0000", "rsl.out.0000", "README"}) {
        std::ofstream(folder / name) << "text";
    }
    const auto dataset = openFiles({folder.path()});
    CHECK(dataset->info().times.size() == 2);
    CHECK(dataset->read("QCLOUD", 1).at(0, 0, 0) == 2.0f);
    CHECK(dataset->info().notes.size() == 2);
    CHECK(noted(*dataset, "5 files"));
    CHECK(noted(*dataset, "README, met_em.d01.nc, namelist.input, ..."));
    CHECK(noted(*dataset, "another grid (7 x 3 x 5 cells of 1000 x 2000 m): wrfout_d02_a"));
}

TEST_CASE("A folder without a readable file is an error that names what was tried") {
    const TemporaryFolder folder;
    CHECK(contains(errorOf([&] { openFiles({folder.path()}); }).what, "holds no files"));
    std::ofstream(folder / "namelist.input") << "&time_control";
    const ErrorParts error = errorOf([&] { openFiles({folder.path()}); });
    CHECK(contains(error.what, "holds no file that can be read"));
    CHECK(contains(error.found, "namelist.input"));
}

TEST_CASE("Compressed files in a folder are never left out unsaid, and the note has the command") {
    const TemporaryFolder folder;
    std::ofstream(folder / "README") << "text";
    for (const char* name : {"wrfout_d01_b.gz", "wrfout_d01_c.gz"}) {
        std::ofstream(folder / name) << "\x1f\x8b\x08\x01 and more";
    }
    const ErrorParts error = errorOf([&] { openFiles({folder.path()}); });
    CHECK(contains(error.what, "holds no file that can be read"));
    CHECK(contains(error.found, "3 files; wrfout_d01_b.gz: a file compressed with gzip"));
    CHECK(contains(error.hint, "gunzip -k " + (folder / "wrfout_d01_b.gz").string()));
    writeWrf(folder / "wrfout_d01_a", {});
    const auto dataset = openFiles({folder.path()});
    CHECK(noted(*dataset, "2 files"));
    CHECK(noted(*dataset, "wrfout_d01_b.gz, wrfout_d01_c.gz (a file compressed with gzip)"));
    CHECK(noted(*dataset, "1 file"));  // README
}

TEST_CASE(
    "A folder that is a Zarr store, and a file of another format in a series, say what to do") {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "run.zarr" / "QCLOUD");
    std::ofstream(folder / "run.zarr" / ".zgroup") << R"({"zarr_format": 2})";
    const ErrorParts store = errorOf([&] { openFiles({folder / "run.zarr"}); });
    CHECK(contains(store.found, "a Zarr store"));
    CHECK(contains(store.hint, "open_zarr"));
    writeWrf(folder / "a", {});
    std::ofstream(folder / "b.bufr") << std::string("BUFR\0\1\0\4 and more", 17);
    const ErrorParts bufr = errorOf([&] { openFiles({folder / "a", folder / "b.bufr"}); });
    CHECK(contains(bufr.where, "b.bufr"));
    CHECK(contains(bufr.found, "BUFR"));
    CHECK(contains(bufr.hint, "open output of a model"));
}

TEST_CASE("Every file that is named must be readable") {
    const TemporaryFolder folder;
    writeWrf(folder / "a", {});
    std::ofstream(folder / "b") << "text";
    CHECK(contains(errorOf([&] { openFiles({folder / "a", folder / "b"}); }).where, "b"));
}

TEST_CASE("Headers of a long series are cached: the second time its files are not read") {
    const TemporaryFolder folder, cache;
    std::vector<std::filesystem::path> files;
    for (int hour = 10; hour < 20; ++hour) {
        files.push_back(folder / std::to_string(hour));
        writeWrf(files.back(),
                 at({"2024-05-06_" + std::to_string(hour) + ":00:00"}, static_cast<float>(hour)));
    }
    const auto first = Dataset::open(files, readerHost(), cache.path(), {});
    CHECK(!std::filesystem::is_empty(cache.path()));
    // Same size and modification time, but other content: only a cache that reads nothing is
    // misled.
    const auto changed = std::filesystem::last_write_time(files[7]);
    const auto bytes = std::filesystem::file_size(files[7]);
    std::ofstream(files[7]) << std::string(bytes, 'x');
    std::filesystem::last_write_time(files[7], changed);
    const auto second = Dataset::open(files, readerHost(), cache.path(), {});
    REQUIRE(second->info().times.size() == 10);
    for (std::size_t i = 0; i < 10; ++i) {
        CHECK(second->info().times[i].label == first->info().times[i].label);
        CHECK(second->info().times[i].seconds == first->info().times[i].seconds);
    }
    CHECK(second->info().variables == first->info().variables);
    CHECK(second->read("QCLOUD", 5).at(0, 0, 0) == 15.0f);
    CHECK(!errorOf([&] { second->read("QCLOUD", 7); }).what.empty());
    // A changed file is read again.
    writeWrf(files[7], at({"2024-05-06_23:00:00"}, 23.0f));
    const auto third = Dataset::open(files, readerHost(), cache.path(), {});
    CHECK(third->info().times.back().label == "2024-05-06_23:00:00");
}

TEST_CASE("Files of different schemes in one series are noted") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.times = {"2021-08-14_18:00:00"};
    writeWrf(folder / "a", spec);
    spec.times = {"2021-08-14_18:10:00"};
    spec.mpPhysics = 3;
    writeWrf(folder / "b", spec);
    const DatasetInfo info = openFiles({folder / "a", folder / "b"})->info();
    CHECK(hasNote(info, "b was made with WSM3 (MP_PHYSICS 3), not with Kessler"));
}
