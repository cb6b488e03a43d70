// wrf_domains_test.cpp: tiles, nests, regions, widths of cells and directions of axes of WRF files.
#include <doctest/doctest.h>

#include <cmath>

#include "tests/readers/reader_host.h"
#include "tests/readers/wrf_maker.h"
#include "tests/temporary_folder.h"

using namespace neph;

namespace {

/// The tiles of a domain of 4 x 2 columns, two by one, in a folder.
void writeTiles(const std::filesystem::path& folder, const std::string& time) {
    for (int rank = 0; rank < 2; ++rank) {
        WrfSpec spec;
        spec.nx = 2;
        spec.ny = 2;
        spec.patch = WrfPatch{2 * rank, 0, 4, 2};
        spec.times = {time};
        const auto whole = [rank](int x, int y, int z, int t) {
            return marked(x + 2 * rank, y, z, t);
        };
        spec.fields = {{"QCLOUD", whole}, {"U", whole}};
        writeWrf(folder / ("wrfout_d01_" + time + "_000" + std::to_string(rank)), spec);
    }
}

}  // namespace

TEST_CASE("Tiles of MPI ranks are read as the domain that they make up") {
    const TemporaryFolder folder;
    writeTiles(folder.path(), "2021-08-14_18:00:00");
    writeTiles(folder.path(), "2021-08-14_18:10:00");
    for (const bool byFolder : {true, false}) {
        std::vector<std::filesystem::path> named{folder.path()};
        if (!byFolder) {
            named = {folder / "wrfout_d01_2021-08-14_18:10:00_0001",
                     folder / "wrfout_d01_2021-08-14_18:10:00_0000",
                     folder / "wrfout_d01_2021-08-14_18:00:00_0001",
                     folder / "wrfout_d01_2021-08-14_18:00:00_0000"};
        }
        const auto dataset = openFiles(named);
        CHECK(dataset->info().size == glm::ivec3(4, 2, 5));
        REQUIRE(dataset->info().times.size() == 2);
        CHECK(hasNote(dataset->info(), "2 tiles"));
        CHECK(!hasNote(dataset->info(), "twice"));
        const Array3f cloud = dataset->read("QCLOUD", 1);
        const Array3f wind = dataset->read("U", 1);
        REQUIRE(wind.size == glm::ivec3(5, 2, 5));
        for (int x = 0; x < 4; ++x) CHECK(cloud.at(x, 1, 3) == marked(x, 1, 3, 0));
        for (int x = 0; x < 5; ++x) CHECK(wind.at(x, 1, 3) == marked(x, 1, 3, 0));
        const Array3f part = dataset->read("QCLOUD", 0, CellBox{{1, 1, 2}, {4, 2, 4}});
        CHECK(part.at(2, 0, 1) == marked(3, 1, 3, 0));
    }
}

TEST_CASE("A tile alone is refused as one, never shown as the domain") {
    const TemporaryFolder folder;
    writeTiles(folder.path(), "2021-08-14_18:00:00");
    std::filesystem::remove(folder / "wrfout_d01_2021-08-14_18:00:00_0001");
    const ErrorParts error = openError(folder / "wrfout_d01_2021-08-14_18:00:00_0000");
    CHECK(contains(error.what, "tile"));
    CHECK(contains(error.what, "missing"));
    CHECK(contains(error.hint, "io_form_history = 2"));
}

TEST_CASE("A region cut out of a file is read, with a note that it is a part") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.attributes = {{"WEST-EAST_GRID_DIMENSION", 101},     {"SOUTH-NORTH_GRID_DIMENSION", 81},
                       {"WEST-EAST_PATCH_START_UNSTAG", 1},   {"WEST-EAST_PATCH_END_UNSTAG", 100},
                       {"SOUTH-NORTH_PATCH_START_UNSTAG", 1}, {"SOUTH-NORTH_PATCH_END_UNSTAG", 80}};
    writeWrf(folder / "a", spec);
    CHECK(hasNote(openFiles({folder / "a"})->info(), "4 x 3 of the 100 x 80 columns"));
}

TEST_CASE("Nests and sister domains of one size never form one series") {
    const TemporaryFolder folder;
    WrfSpec spec;
    const auto write = [&](const char* name, int id, double longitude, const char* time) {
        spec.attributes = {{"GRID_ID", id}, {"CEN_LAT", 35.0}, {"CEN_LON", longitude}};
        spec.times = {time};
        writeWrf(folder / name, spec);
    };
    write("a", 2, -97.5, "2021-08-14_18:00:00");
    write("b", 2, -97.5, "2021-08-14_18:10:00");
    write("c", 3, -97.5, "2021-08-14_18:20:00");
    write("d", 2, -90.5, "2021-08-14_18:30:00");
    const DatasetInfo info = openFiles({folder.path()})->info();
    CHECK(info.times.size() == 2);
    CHECK(hasNote(info, "2 files"));
    CHECK(hasNote(info, "domain 3"));
    const ErrorParts error = errorOf([&] { openFiles({folder / "a", folder / "c"}); });
    CHECK(contains(error.what, "grid is not that of"));
    CHECK(contains(error.found, "domain 3"));
}

TEST_CASE("Map scale factors make cells narrower on the earth") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.mapProjection = 3;
    writeWrf(folder / "without", spec);
    CHECK(hasNote(openFiles({folder / "without"})->info(), "MAPFAC_M is missing"));
    spec.flat["MAPFAC_M"] = [](int x, int, int, int) { return x == 3 ? 1.25f : 1.2f; };
    writeWrf(folder / "real", spec);
    const DatasetInfo info = openFiles({folder / "real"})->info();
    // The mean of areas: (3 / 1.2² + 1 / 1.25²) / 4.
    const double share = std::sqrt((3.0 / 1.44 + 1.0 / 1.5625) / 4.0);
    CHECK(info.spacingM.x == doctest::Approx(1000.0 * share));
    CHECK(info.spacingM.y == doctest::Approx(2000.0 * share));
    CHECK(hasNote(info, "1.2 to 1.25, the largest 1.25"));
    spec.mapProjection = 0;  // an idealised run: factors are 0 or mean nothing
    writeWrf(folder / "ideal", spec);
    CHECK(openFiles({folder / "ideal"})->info().spacingM == glm::dvec2(1000.0, 2000.0));
}

TEST_CASE("A spacing in degrees, or one that only coordinates tell, is turned into metres") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.mapProjection = 6;
    spec.dx = spec.dy = 0.1f;
    spec.flat["MAPFAC_MX"] = everywhere(2.0f);
    spec.flat["MAPFAC_MY"] = everywhere(1.0f);
    writeWrf(folder / "degrees", spec);
    const DatasetInfo degrees = openFiles({folder / "degrees"})->info();
    // A tenth of a degree on a sphere of 6370 km.
    CHECK(degrees.spacingM.y == doctest::Approx(11117.7).epsilon(1e-4));
    CHECK(degrees.spacingM.x == doctest::Approx(5558.9).epsilon(1e-4));
    CHECK(hasNote(degrees, "taken as degrees"));
    WrfSpec bare;
    bare.omit = {"DX", "DY", "MAP_PROJ"};
    bare.flat["XLAT"] = [](int, int y, int, int) { return 60.0f + 0.01f * static_cast<float>(y); };
    bare.flat["XLONG"] = [](int x, int, int, int) { return 0.02f * static_cast<float>(x); };
    writeWrf(folder / "bare", bare);
    const DatasetInfo info = openFiles({folder / "bare"})->info();
    CHECK(info.spacingM.x == doctest::Approx(1111.8).epsilon(2e-3));
    CHECK(info.spacingM.y == doctest::Approx(1111.8).epsilon(2e-3));
    CHECK(hasNote(info, "by XLAT and XLONG"));
}

TEST_CASE("Rows from north to south are turned, levels from the top down are refused") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.dx = spec.dy = 1113.0f;
    spec.flat["XLAT"] = [](int, int y, int, int) { return 35.0f - 0.01f * static_cast<float>(y); };
    spec.flat["XLONG"] = [](int x, int, int, int) {
        return -97.0f + 0.0122f * static_cast<float>(x);
    };
    spec.fields["QCLOUD"] = marked;
    writeWrf(folder / "south", spec);
    const auto dataset = openFiles({folder / "south"});
    CHECK(hasNote(dataset->info(), "north to south"));
    CHECK(dataset->read("QCLOUD", 0).at(1, 0, 2) == marked(1, 2, 2, 0));
    CHECK(dataset->read("QCLOUD", 0, CellBox{{1, 0, 2}, {3, 2, 4}}).at(1, 1, 1) ==
          marked(2, 1, 3, 0));
    WrfSpec down;
    down.fields["PHB"] = [](int, int, int z, int) { return 981.0f * static_cast<float>(5 - z); };
    writeWrf(folder / "down", down);
    CHECK(contains(openError(folder / "down").hint, "ncpdq -a -bottom_top,-bottom_top_stag"));
}

TEST_CASE("Columns further apart than DX says are taken as wide as they are apart") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.dx = spec.dy = 1112.0f;
    spec.flat["XLAT"] = [](int, int y, int, int) { return 0.1f + 0.02f * static_cast<float>(y); };
    spec.flat["XLONG"] = [](int x, int, int, int) { return 0.1f + 0.02f * static_cast<float>(x); };
    writeWrf(folder / "a", spec);
    const DatasetInfo info = openFiles({folder / "a"})->info();
    CHECK(info.spacingM.x == doctest::Approx(2224.0));
    CHECK(hasNote(info, "2 times DX apart"));
}

TEST_CASE("A nest that moves within a file is noted, an impossible spacing refused") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.times = {"2021-08-14_18:00:00", "2021-08-14_18:10:00"};
    spec.flat["XLAT"] = [](int, int y, int, int) { return 35.0f + 0.009f * static_cast<float>(y); };
    spec.flat["XLONG"] = [](int x, int, int, int t) {
        return -97.0f + 0.011f * static_cast<float>(x) + 0.5f * static_cast<float>(t);
    };
    writeWrf(folder / "a", spec);
    CHECK(hasNote(openFiles({folder / "a"})->info(), "The domain moves"));
    WrfSpec huge;
    huge.dx = 1e12f;
    writeWrf(folder / "huge", huge);
    CHECK(contains(openError(folder / "huge").what, "DX"));
}
