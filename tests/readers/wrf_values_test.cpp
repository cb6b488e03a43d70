// wrf_values_test.cpp: packed numbers, units, species and possible values of WRF files.
#include <doctest/doctest.h>
#include <netcdf.h>

#include <cmath>

#include "core/volume/statistics.h"
#include "tests/readers/reader_host.h"
#include "tests/readers/wrf_maker.h"
#include "tests/temporary_folder.h"

using namespace neph;

namespace {

void putShorts(int file, int id, const char* name, std::vector<short> values) {
    nc_put_att_short(file, id, name, NC_SHORT, values.size(), values.data());
}

void putWords(int file, int id, const char* name, const std::string& text) {
    nc_put_att_text(file, id, name, text.size(), text.data());
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

TEST_CASE("The wind in a cell is the mean of its faces") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.fields["W"] = [](int x, int y, int z, int) {
        return static_cast<float>(x + 10 * y + 100 * z * z);
    };
    spec.units["W"] = "cm s-1";
    writeWrf(folder / "a", spec);
    const auto dataset = openFiles({folder / "a"});
    const VariableInfo* wind = dataset->info().find(VariableRole::upwardWind);
    REQUIRE(wind != nullptr);
    CHECK(wind->size == dataset->info().size);
    CHECK(wind->units == "m s-1");
    const Array3f values = dataset->read(wind->name, 0, CellBox{{1, 2, 1}, {4, 3, 4}});
    for (int z = 0; z < 3; ++z) {
        for (int x = 0; x < 3; ++x) {
            const int lower = (z + 1) * (z + 1), upper = (z + 2) * (z + 2);
            CHECK(values.at(x, 0, z) ==
                  doctest::Approx(0.01 * (x + 1 + 20 + 50 * (lower + upper))));
        }
    }
}
