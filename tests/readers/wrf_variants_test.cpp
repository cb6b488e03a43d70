// wrf_variants_test.cpp: files of WRF as they come out of other versions, settings and tools.
#include <doctest/doctest.h>
#include <netcdf.h>
#include <sys/file.h>
#include <unistd.h>

#include <fcntl.h>
#include <algorithm>
#include <cmath>

#include "core/volume/statistics.h"
#include "tests/readers/reader_host.h"
#include "tests/readers/wrf_maker.h"
#include "tests/temporary_folder.h"

using namespace neph;

namespace {

/// A number that identifies the cell and time that it belongs to.
float marked(int x, int y, int z, int t) {
    return 1e-6f * static_cast<float>(1 + x + 10 * y + 100 * z + 1000 * t);
}

FieldFunction everywhere(float value) {
    return [value](int, int, int, int) { return value; };
}

ErrorParts openError(const std::filesystem::path& path) {
    return errorOf([&] { openFiles({path}); });
}

void putShorts(int file, int id, const char* name, std::vector<short> values) {
    nc_put_att_short(file, id, name, NC_SHORT, values.size(), values.data());
}

void putReals(int file, int id, const char* name, std::vector<double> values) {
    nc_put_att_double(file, id, name, NC_DOUBLE, values.size(), values.data());
}

void putWords(int file, int id, const char* name, const std::string& text) {
    nc_put_att_text(file, id, name, text.size(), text.data());
}

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

TEST_CASE("Packed integers of every type give the values that were packed") {
    struct Type {
        int type;
        bool marked;  // unsigned numbers in a signed type
        double largest;
    };
    for (const Type& t :
         {Type{NC_BYTE, false, 100.0}, Type{NC_BYTE, true, 200.0}, Type{NC_UBYTE, false, 200.0},
          Type{NC_SHORT, false, 30000.0}, Type{NC_SHORT, true, 60000.0},
          Type{NC_USHORT, false, 60000.0}, Type{NC_INT, false, 2e9}, Type{NC_INT, true, 4e9},
          Type{NC_UINT, false, 4e9}, Type{NC_INT64, false, 4e12}, Type{NC_UINT64, false, 4e12}}) {
        CAPTURE(t.type);
        CAPTURE(t.marked);
        const TemporaryFolder folder;
        WrfSpec spec;
        const double bits = t.type == NC_BYTE ? 256.0 : t.type == NC_SHORT ? 65536.0 : 4294967296.0;
        spec.stored["QCLOUD"] = {t.type,
                                 [&](int x, int, int, int) {
                                     const double number = std::floor(t.largest * x / 3.0);
                                     return t.marked && number >= bits / 2 ? number - bits : number;
                                 },
                                 [&](int file, int id) {
                                     putReals(file, id, "scale_factor", {1e-3 / t.largest});
                                     putReals(file, id, "add_offset", {1e-3});
                                     if (t.marked) putWords(file, id, "_Unsigned", "true");
                                 }};
        writeWrf(folder / "a", spec);
        const auto dataset = openFiles({folder / "a"});
        REQUIRE(dataset->info().find(VariableRole::mixingRatio, Species::cloud) != nullptr);
        const Array3f cloud = dataset->read("QCLOUD", 0);
        for (int x = 0; x < 4; ++x) {
            const double packed = std::floor(t.largest * x / 3.0);
            CHECK(cloud.at(x, 1, 2) == doctest::Approx(1e-3 + packed * 1e-3 / t.largest));
        }
    }
}

TEST_CASE("Missing values, valid ranges and cells never written are missing, in any type") {
    const TemporaryFolder folder;
    WrfSpec spec;
    const auto numbers = [](int x, int, int, int) { return std::array{7.0, 8.0, 300.0, 9.0}[x]; };
    spec.stored["QCLOUD"] = {NC_SHORT, numbers, [](int file, int id) {
                                 putReals(file, id, "scale_factor", {1e-4});
                                 putShorts(file, id, "missing_value", {8});
                                 putShorts(file, id, "valid_range", {0, 100});
                             }};
    // What stands for cells never written is a number like others where numbers are packed.
    spec.stored["QRAIN"] = {NC_SHORT,
                            [](int x, int, int, int) { return x == 1 ? NC_FILL_SHORT : 5.0; },
                            [](int file, int id) {
                                putReals(file, id, "scale_factor", {1e-4});
                                putReals(file, id, "add_offset", {3.2768});
                            }};
    spec.stored["QICE"] = {NC_FLOAT, numbers, [](int file, int id) {
                               const float limit = 100.0f;
                               nc_put_att_float(file, id, "valid_max", NC_FLOAT, 1, &limit);
                               const float none = 9.0f;
                               nc_put_att_float(file, id, "missing_value", NC_FLOAT, 1, &none);
                           }};
    writeWrf(folder / "a", spec);
    const auto dataset = openFiles({folder / "a"});
    const Array3f cloud = dataset->read("QCLOUD", 0);
    CHECK(cloud.at(0, 0, 0) == doctest::Approx(7e-4));
    CHECK(std::isnan(cloud.at(1, 0, 0)));
    CHECK(std::isnan(cloud.at(2, 0, 0)));
    CHECK(cloud.at(3, 0, 0) == doctest::Approx(9e-4));
    CHECK(dataset->read("QRAIN", 0).at(1, 0, 0) == doctest::Approx(1e-4));
    const Array3f ice = dataset->read("QICE", 0);
    CHECK(ice.at(0, 0, 0) == 7.0f);
    CHECK(std::isnan(ice.at(2, 0, 0)));
    CHECK(std::isnan(ice.at(3, 0, 0)));
}

TEST_CASE("Units are converted as the file states them, and a note says which") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.fields["QCLOUD"] = everywhere(2.0f);
    spec.fields["PB"] = everywhere(500.0f);
    spec.units = {{"QCLOUD", "g kg-1"}, {"PB", "hPa"}, {"P", "none"}};
    writeWrf(folder / "a", spec);
    const auto dataset = openFiles({folder / "a"});
    CHECK(dataset->read("QCLOUD", 0).at(1, 1, 1) == doctest::Approx(2e-3));
    CHECK(dataset->info().find("QCLOUD")->units == "kg kg-1");
    CHECK(dataset->read("air_pressure", 0).at(1, 1, 1) == doctest::Approx(5e4));
    CHECK(hasNote(dataset->info(), "QCLOUD from g kg-1 to kg kg-1"));
    CHECK(hasNote(dataset->info(), "those of WRF are assumed: P"));
}

TEST_CASE("A hydrometeor or air in units of another kind is refused, a number is left out") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.units = {{"QCLOUD", "g m-3"}};
    writeWrf(folder / "a", spec);
    const ErrorParts error = openError(folder / "a");
    CHECK(contains(error.what, "QCLOUD"));
    CHECK(contains(error.found, "g m-3"));
    CHECK(contains(error.hint, "ncatted -a units,QCLOUD"));
    spec.units = {{"T", "m"}};
    writeWrf(folder / "a", spec);
    CHECK(contains(openError(folder / "a").what, "variable T "));
    spec.units = {{"QNRAIN", "m-3"}};
    spec.fields["QNRAIN"] = everywhere(1e3f);
    writeWrf(folder / "a", spec);
    const DatasetInfo info = openFiles({folder / "a"})->info();
    CHECK(info.find(VariableRole::numberConcentration, Species::rain) == nullptr);
    CHECK(hasNote(info, "QNRAIN is not used: its units \"m-3\""));
}

TEST_CASE("Ice that a scheme keeps in several variables is their sum, rime a part of it") {
    struct Case {
        int scheme;
        std::vector<std::string> names;
    };
    for (const Case& c : {Case{52, {"QICE", "QICE2"}}, Case{55, {"QICE", "QICE2", "QICE3"}},
                          Case{32, {"QICEC", "QICED", "QICEP"}}}) {
        CAPTURE(c.scheme);
        const TemporaryFolder folder;
        WrfSpec spec;
        spec.mpPhysics = c.scheme;
        float sum = 0.0f;
        for (std::size_t i = 0; i < c.names.size(); ++i) {
            const float value = 1e-4f * static_cast<float>(i + 1);
            spec.fields[c.names[i]] = everywhere(value);
            sum += value;
        }
        spec.fields["QIR"] = everywhere(5e-5f);
        spec.fields["QNICE"] = everywhere(10.0f);
        spec.fields["QNICE2"] = everywhere(20.0f);
        writeWrf(folder / "a", spec);
        const auto dataset = openFiles({folder / "a"});
        const DatasetInfo& info = dataset->info();
        const VariableInfo* ice = info.find(VariableRole::mixingRatio, Species::ice);
        REQUIRE(ice != nullptr);
        CHECK(dataset->read(ice->name, 0).at(1, 1, 1) == doctest::Approx(sum));
        const VariableInfo* number = info.find(VariableRole::numberConcentration, Species::ice);
        REQUIRE(number != nullptr);
        CHECK(dataset->read(number->name, 0).at(1, 1, 1) == doctest::Approx(30.0));
        CHECK(hasNote(info, "sum of"));
        CHECK(info.find(c.names.back()) != nullptr);
        CHECK(info.find(c.names.back())->role == VariableRole::other);
    }
}

TEST_CASE("A hydrometeor that cannot be used, is unknown or is lacking is named in a note") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.mpPhysics = 8;
    spec.fields["QSNOW"] = everywhere(1e-3f);
    spec.onInterfaces.insert("QSNOW");
    spec.fields["QFOAM"] = everywhere(1e-3f);
    spec.fields["QIR"] = everywhere(1e-3f);
    writeWrf(folder / "a", spec);
    const DatasetInfo info = openFiles({folder / "a"})->info();
    CHECK(hasNote(info, "QSNOW is not used"));
    CHECK(hasNote(info, "without a known meaning are not drawn: QFOAM"));
    CHECK(!hasNote(info, "QIR ("));
    CHECK(hasNote(info, "lacks: ice (QICE), snow (QSNOW), graupel (QGRAUP) of Thompson"));
}

TEST_CASE("In a scheme of one class for both phases condensate below 0 °C is ice and snow") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.mpPhysics = 3;
    // At 5e4 Pa theta of 320 K is 262.5 K, of 340 K 278.9 K.
    spec.fields["T"] = [](int x, int, int, int) { return x < 2 ? 20.0f : 40.0f; };
    spec.fields["QCLOUD"] = everywhere(1e-3f);
    spec.fields["QRAIN"] = everywhere(2e-3f);
    writeWrf(folder / "a", spec);
    const auto dataset = openFiles({folder / "a"});
    const auto valueOf = [&](Species species, int x) {
        const VariableInfo* variable = dataset->info().find(VariableRole::mixingRatio, species);
        REQUIRE(variable != nullptr);
        return dataset->read(variable->name, 0).at(x, 0, 0);
    };
    CHECK(valueOf(Species::cloud, 0) == 0.0f);
    CHECK(valueOf(Species::cloud, 3) == 1e-3f);
    CHECK(valueOf(Species::ice, 0) == 1e-3f);
    CHECK(valueOf(Species::ice, 3) == 0.0f);
    CHECK(valueOf(Species::rain, 3) == 2e-3f);
    CHECK(valueOf(Species::snow, 0) == 2e-3f);
    CHECK(valueOf(Species::snow, 2) == 0.0f);
    CHECK(hasNote(dataset->info(), "WSM3"));
}

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

TEST_CASE("Files of a series may differ in the parts of a sum") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.mpPhysics = 52;
    spec.fields["QICE"] = everywhere(1e-3f);
    spec.times = {"2021-08-14_18:00:00"};
    writeWrf(folder / "a", spec);
    spec.fields["QICE2"] = everywhere(2e-3f);
    spec.times = {"2021-08-14_18:10:00"};
    writeWrf(folder / "b", spec);
    for (const auto& files :
         {std::vector{folder / "a", folder / "b"}, std::vector{folder / "b", folder / "a"}}) {
        const auto dataset = openFiles(files);
        const VariableInfo* ice = dataset->info().find(VariableRole::mixingRatio, Species::ice);
        REQUIRE(ice != nullptr);
        CHECK(dataset->read(ice->name, 0).at(0, 0, 0) == doctest::Approx(1e-3));
        CHECK(dataset->read(ice->name, 1).at(0, 0, 0) == doctest::Approx(3e-3));
    }
}

TEST_CASE("Impossible water vapour is refused and named, with the unit that it probably is in") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.fields["QVAPOR"] = everywhere(2.0f);
    spec.fields["QCLOUD"] = everywhere(1e-3f);
    writeWrf(folder / "a", spec);
    const auto dataset = openFiles({folder / "a"});
    const ErrorParts error = errorOf([&] { summarise(*dataset, 0); });
    CHECK(contains(error.found, "QVAPOR is 2 kg/kg"));
    CHECK(contains(error.hint, "g/kg"));
}

TEST_CASE("Pressure or heights in another unit than stated are refused") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.omit = {"PB", "P", "T", "PH", "PHB"};
    spec.fields["QCLOUD"] = everywhere(1e-3f);
    spec.fields["PRES"] = everywhere(900.0f);  // hPa, said to be Pa
    spec.fields["TK"] = everywhere(290.0f);
    spec.fields["Z"] = [](int, int, int z, int) { return 250.0f * static_cast<float>(z); };
    spec.onInterfaces.insert("Z");
    spec.units = {{"PRES", "Pa"}, {"TK", "K"}, {"Z", "m"}};
    writeWrf(folder / "a", spec);
    const auto dataset = openFiles({folder / "a"});
    const ErrorParts error = errorOf([&] { summarise(*dataset, 0); });
    CHECK(contains(error.what, "does not fit its height"));
    CHECK(contains(error.hint, "hPa"));
    spec.units["PRES"] = "hPa";
    spec.units["Z"] = "km";
    writeWrf(folder / "b", spec);
    CHECK(contains(errorOf([&] { summarise(*openFiles({folder / "b"}), 0); }).what, "height"));
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
