// wrf_variants_test.cpp: files of WRF as they come out of other versions, settings and tools.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <netcdf.h>
#include <sys/file.h>
#include <unistd.h>

#include "tests/readers/reader_host.h"
#include "tests/readers/wrf_maker.h"
#include "tests/temporary_folder.h"

using namespace neph;

TEST_CASE("Times are read whatever separates date and hour, as characters or strings") {
    const TemporaryFolder folder;
    for (const char separator : {'_', ' ', 'T'}) {
        for (const bool strings : {false, true}) {
            WrfSpec spec;
            spec.times = {"2021-08-14_18:00:00", "2021-08-14_18:10:00"};
            for (std::string& time : spec.times) time[10] = separator;
            spec.timesAsStrings = strings;
            writeWrf(folder / "a", spec);
            const DatasetInfo info = openFiles({folder / "a"})->info();
            REQUIRE(info.times.size() == 2);
            CHECK(info.times[1].label == "2021-08-14_18:10:00");
            CHECK(info.times[1].seconds == 600.0);
        }
    }
}

TEST_CASE("Without Times a CF time is read, in its calendar") {
    const TemporaryFolder folder;
    struct Case {
        const char* units;
        const char* calendar;
        std::vector<double> numbers;
        const char* second;
    };
    for (const Case& c :
         {Case{"minutes since 2021-08-14 00:00:00", "", {1080, 1090}, "2021-08-14_18:10:00"},
          Case{"days since 2000-02-28", "noleap", {0, 1}, "2000-03-01_00:00:00"},
          Case{"days since 2000-02-28", "standard", {0, 1}, "2000-02-29_00:00:00"},
          Case{"hours since 2000-02-30T12:00:00Z", "360_day", {0, 12}, "2000-03-01_00:00:00"}}) {
        WrfSpec spec;
        spec.omit = {"Times"};
        spec.xtime = c.numbers;
        spec.xtimeUnits = c.units;
        spec.calendar = c.calendar;
        writeWrf(folder / "a", spec);
        const DatasetInfo info = openFiles({folder / "a"})->info();
        REQUIRE(info.times.size() == 2);
        CHECK(info.times[1].label == c.second);
    }
    WrfSpec bad;
    bad.omit = {"Times"};
    bad.xtime = {0};
    bad.xtimeUnits = "fortnights since the flood";
    writeWrf(folder / "bad", bad);
    CHECK(contains(openError(folder / "bad").what, "times of variable XTIME"));
}

TEST_CASE("Renamed axes are found by the fields on them") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.omit = {"Times"};
    spec.xtime = {1080};
    spec.renamed = {{"Time", "t"},         {"west_east", "lon"},        {"south_north", "lat"},
                    {"bottom_top", "lev"}, {"bottom_top_stag", "lev2"}, {"west_east_stag", "lon2"}};
    spec.fields["QCLOUD"] = marked;
    writeWrf(folder / "a", spec);
    const auto dataset = openFiles({folder / "a"});
    CHECK(dataset->info().size == glm::ivec3(4, 3, 5));
    CHECK(dataset->read("QCLOUD", 0).at(3, 2, 4) == marked(3, 2, 4, 0));
    CHECK(dataset->read("interface_height", 0).at(0, 0, 5) == doctest::Approx(500.0));
    REQUIRE(dataset->info().find("U") != nullptr);
    CHECK(dataset->info().find("U")->size == glm::ivec3(5, 3, 5));
}

TEST_CASE("Restart files are read at their present time level, with a note") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.renamed = {{"PH", "PH_2"}, {"T", "T_2"}};
    writeWrf(folder / "dry", spec);
    const auto dataset = openFiles({folder / "dry"});
    CHECK(hasNote(dataset->info(), "restart file"));
    CHECK(dataset->read("air_temperature", 0).at(0, 0, 0) == doctest::Approx(262.5073));
    spec.renamed["T"] = "THM_2";
    writeWrf(folder / "moist", spec);
    // theta of 320 K is moist: divided by 1 + 1.6084 x 0.002.
    CHECK(openFiles({folder / "moist"})->read("air_temperature", 0).at(0, 0, 0) ==
          doctest::Approx(262.5073 / 1.0032168).epsilon(1e-5));
}

TEST_CASE("Processed output with height, pressure and temperature is read") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.omit = {"PH", "PHB", "PB", "T", "P"};
    spec.fields["Z"] = [](int, int, int z, int) { return 250.0f * static_cast<float>(z); };
    spec.onInterfaces.insert("Z");
    spec.fields["PRES"] = everywhere(9e4f);
    spec.fields["TK"] = everywhere(291.0f);
    spec.units = {{"Z", "m"}, {"PRES", "Pa"}, {"TK", "K"}};
    writeWrf(folder / "a", spec);
    const auto dataset = openFiles({folder / "a"});
    CHECK(dataset->read("interface_height", 0).at(1, 1, 2) == 500.0f);
    CHECK(dataset->read("air_temperature", 0).at(1, 1, 2) == 291.0f);
    CHECK(dataset->read("dry_air_density", 0).at(1, 1, 2) ==
          doctest::Approx(9e4 / (287.0 * 291.0 * (1 + 1.6084 * 0.002))).epsilon(1e-5));
}

TEST_CASE("Heights of cell centres give interfaces halfway, the lowest at the terrain") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.omit = {"PH", "PHB"};
    spec.fields["Z"] = [](int, int, int z, int) {
        return 300.0f + 100.0f * static_cast<float>(z);  // 300, 400, … 700 m
    };
    spec.flat["HGT"] = everywhere(240.0f);
    spec.units = {{"Z", "m"}, {"HGT", "m"}};
    writeWrf(folder / "a", spec);
    const auto dataset = openFiles({folder / "a"});
    const Array3f heights = dataset->read("interface_height", 0);
    const std::array expected{240.0f, 350.0f, 450.0f, 550.0f, 650.0f, 750.0f};
    for (int k = 0; k < 6; ++k) {
        CHECK(heights.at(2, 1, k) == expected[static_cast<std::size_t>(k)]);
        // Each level alone gives the same.
        CHECK(dataset->read("interface_height", 0, CellBox{{2, 1, k}, {3, 2, k + 1}}).values[0] ==
              expected[static_cast<std::size_t>(k)]);
    }
    CHECK(hasNote(dataset->info(), "centres"));
}

TEST_CASE("P alone is the pressure only where its values are") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.omit = {"PB", "description"};
    spec.fields["P"] = everywhere(8e4f);
    writeWrf(folder / "whole", spec);
    CHECK(openFiles({folder / "whole"})->read("air_pressure", 0).at(0, 0, 0) == 8e4f);
    spec.fields["P"] = everywhere(300.0f);
    writeWrf(folder / "part", spec);
    CHECK(contains(openError(folder / "part").what, "variable PB"));
}

TEST_CASE("A file that a program locks is read, and never locked against it") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.format = NetcdfFormat::netcdf4;
    writeWrf(folder / "a", spec);
    const int writer = open((folder / "a").c_str(), O_RDWR | O_CLOEXEC);
    REQUIRE(writer >= 0);
    REQUIRE(flock(writer, LOCK_EX | LOCK_NB) == 0);
    const auto dataset = openFiles({folder / "a"});
    CHECK(dataset->read("T", 0).at(0, 0, 0) == 20.0f);
    REQUIRE(flock(writer, LOCK_UN) == 0);
    CHECK(flock(writer, LOCK_EX | LOCK_NB) == 0);
    close(writer);
}

TEST_CASE("A file that ends early is said to be written while it is") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.format = NetcdfFormat::netcdf4;
    writeWrf(folder / "a", spec);
    std::filesystem::resize_file(folder / "a", 4000);
    CHECK(contains(openError(folder / "a").hint, "being written"));
    age(folder / "a");
    CHECK(contains(openError(folder / "a").hint, "cut short"));
    const int writer = open((folder / "a").c_str(), O_RDWR | O_CLOEXEC);
    REQUIRE(flock(writer, LOCK_EX) == 0);
    CHECK(contains(openError(folder / "a").hint, "locked it for writing"));
    close(writer);
}

TEST_CASE("A compression filter that is missing is named, with what to do") {
    const auto dataset =
        openFiles({std::filesystem::path(NEPH_TEST_SOURCE_DIR) / "tests/readers/data/wrf-lzf.nc"});
    const ErrorParts error = errorOf([&] { dataset->read("QCLOUD", 0); });
    CHECK(contains(error.what, "QCLOUD"));
    CHECK(contains(error.found, "LZF (id 32000)"));
    CHECK(contains(error.hint, "HDF5_PLUGIN_PATH"));
    CHECK(contains(error.hint, "h5repack"));
}

TEST_CASE("Axes in another order are refused with the command that mends them") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.renamed = {{"west_east", "bottom_top"}, {"bottom_top", "west_east"}};
    spec.omit = {"U"};
    writeWrf(folder / "a", spec);
    CHECK(contains(openError(folder / "a").hint, "ncpdq"));
}

TEST_CASE("A record that was begun and not finished loses itself alone") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.times = {"2021-08-14_18:00:00", "2021-08-14_18:10:00"};
    const FieldFunction begun = [](int, int, int, int t) { return t == 1 ? NC_FILL_FLOAT : 1e-3f; };
    spec.fields = {{"QCLOUD", begun}, {"QRAIN", begun}, {"U", begun}};
    for (const NetcdfFormat format : {NetcdfFormat::classic, NetcdfFormat::netcdf4}) {
        spec.format = format;
        writeWrf(folder / "filled", spec);
        const DatasetInfo filled = openFiles({folder / "filled"})->info();
        REQUIRE(filled.times.size() == 1);
        CHECK(filled.times[0].label == "2021-08-14_18:00:00");
        CHECK(hasNote(filled, "2021-08-14_18:10:00 is left out"));
    }
    spec.format = NetcdfFormat::classic;
    spec.fields.clear();
    writeWrf(folder / "short", spec);
    truncateTo(folder / "short", std::filesystem::file_size(folder / "short") - 500);
    const auto dataset = openFiles({folder / "short"});
    REQUIRE(dataset->info().times.size() == 1);
    CHECK(dataset->read("QRAIN", 0).values.size() == 60);
    CHECK(hasNote(dataset->info(), "cut short"));
}

TEST_CASE("A field that is missing at every time is no sign of a broken record") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.times = {"2021-08-14_18:00:00", "2021-08-14_18:10:00"};
    spec.fields["QRAIN"] = everywhere(NC_FILL_FLOAT);
    writeWrf(folder / "a", spec);
    CHECK(openFiles({folder / "a"})->info().times.size() == 2);
}

TEST_CASE("Times with underscores for colons, packed CF times, and CF times beside broken Times") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.times = {"2021-08-14_18_00_00", "2021-08-14_18_10_00"};
    writeWrf(folder / "underscores", spec);
    CHECK(openFiles({folder / "underscores"})->info().times[1].seconds == 600.0);
    spec.times = {"?", "??"};
    spec.xtime = {1080, 1090};
    writeWrf(folder / "broken", spec);
    CHECK(openFiles({folder / "broken"})->info().times[1].label == "2021-08-14_18:10:00");
    spec.omit = {"Times"};
    spec.xtime = {0, 1};
    writeWrf(folder / "packed", spec);
    int file = -1;
    int id = -1;
    REQUIRE(nc_open((folder / "packed").c_str(), NC_WRITE, &file) == NC_NOERR);
    nc_redef(file);
    nc_inq_varid(file, "XTIME", &id);
    putReals(file, id, "scale_factor", {10.0});
    putReals(file, id, "add_offset", {1080.0});
    REQUIRE(nc_close(file) == NC_NOERR);
    const DatasetInfo packed = openFiles({folder / "packed"})->info();
    CHECK(packed.times[0].label == "2021-08-14_18:00:00");
    CHECK(packed.times[1].label == "2021-08-14_18:10:00");
}
