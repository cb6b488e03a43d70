// bad_input_test.cpp: every kind of bad input gives an error that names the file, the fault and the
// next step.
#include <doctest/doctest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "core/volume/resample.h"
#include "tests/readers/reader_host.h"
#include "tests/readers/wrf_maker.h"
#include "tests/temporary_folder.h"

using namespace neph;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

void writeText(const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

}  // namespace

TEST_CASE("A missing field is named with what was found, what was expected and the next step") {
    for (const std::string name : {"PH", "PHB", "P", "PB", "T"}) {
        CAPTURE(name);
        const TemporaryFolder folder;
        WrfSpec spec;
        spec.omit = {name};
        writeWrf(folder / "wrfout_d02", spec);
        const ErrorParts error = openError(folder / "wrfout_d02");
        CHECK(contains(error.where, "wrfout_d02"));
        CHECK(contains(error.what, "variable " + name + " ("));
        CHECK(contains(error.what, "is missing"));
        CHECK(contains(error.found, "QVAPOR"));
        CHECK(contains(error.expected, name + " on (Time, bottom_top"));
        CHECK(contains(error.hint, "history stream"));
    }
}

TEST_CASE("NetCDF that is not WRF is refused with what was found and what is read") {
    const TemporaryFolder folder;
    writeOtherNetcdf(folder / "era5.nc");
    const ErrorParts error = openError(folder / "era5.nc");
    CHECK(contains(error.what, "neither WRF output"));
    CHECK(contains(error.found, "lat = 3"));
    CHECK(contains(error.found, "level = 2"));
    CHECK(contains(error.expected, "west_east"));
    CHECK(!error.hint.empty());
}

TEST_CASE("A file of another format is refused with its first bytes and what is read") {
    const TemporaryFolder folder;
    writeText(folder / "notes.txt", "Dear diary, today the storm split.");
    const ErrorParts error = openError(folder / "notes.txt");
    CHECK(contains(error.what, "no reader knows this format"));
    CHECK(contains(error.found, "Dear diary"));
    CHECK(contains(error.expected, "WRF output"));
    writeText(folder / "empty", "");
    CHECK(contains(openError(folder / "empty").found, "empty"));
    CHECK(contains(openError(folder.path()).found, "2 files"));
}

TEST_CASE("A path that cannot be read is an error with the reason") {
    const TemporaryFolder folder;
    CHECK(contains(openError(folder / "nowhere").what, "no such file"));
    writeText(folder / "file", "x");
    CHECK(contains(openError(folder / "file" / "below").what, "cannot be opened"));
    writeWrf(folder / "locked", {});
    std::filesystem::permissions(folder / "locked", std::filesystem::perms::none);
    if (geteuid() != 0) CHECK(contains(openError(folder / "locked").what, "cannot be read"));
    CHECK(contains(errorOf([] { openFiles({}); }).what, "no files"));
    REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
    CHECK(contains(openError(folder / "pipe").what, "neither a file nor a folder"));
    writeWrf(folder / "wrfout", {});
    CHECK(contains(errorOf([&] {
                       openFiles({folder / "wrfout", folder / "pipe"});
                   }).what,
                   "neither a file nor a folder"));
}

TEST_CASE("A NetCDF-4 file truncated anywhere is an error that states its size") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.format = NetcdfFormat::netcdf4;
    writeWrf(folder / "whole", spec);
    const auto whole = std::filesystem::file_size(folder / "whole");
    for (const double share : {0.1, 0.5, 0.9}) {
        std::filesystem::copy_file(folder / "whole", folder / "cut",
                                   std::filesystem::copy_options::overwrite_existing);
        const auto bytes = static_cast<std::uintmax_t>(share * static_cast<double>(whole));
        truncateTo(folder / "cut", bytes);
        const ErrorParts error = openError(folder / "cut");
        CHECK(contains(error.what, "cannot be opened"));
        CHECK(contains(error.found, std::to_string(bytes) + " bytes"));
        CHECK(contains(error.hint, "cut short"));
    }
}

TEST_CASE("A classic file truncated anywhere never gives zeros for missing values") {
    const TemporaryFolder folder;
    for (const NetcdfFormat format : {NetcdfFormat::classic, NetcdfFormat::offset64}) {
        WrfSpec spec;
        spec.format = format;
        spec.times = {"0001-01-01_00:00:00", "0001-01-01_00:10:00"};
        spec.fields["U"] = [](int, int, int, int) { return 7.0f; };
        spec.fields["QRAIN"] = [](int, int, int, int) { return 7.0f; };
        writeWrf(folder / "whole", spec);
        const auto whole = std::filesystem::file_size(folder / "whole");
        int errors = 0;
        int reads = 0;
        for (std::uintmax_t bytes = 0; bytes < whole; bytes += 97) {
            std::filesystem::copy_file(folder / "whole", folder / "cut",
                                       std::filesystem::copy_options::overwrite_existing);
            truncateTo(folder / "cut", bytes);
            for (const auto& [name, time] : {std::pair{"U", 1}, {"QRAIN", 0}, {"QRAIN", 1}}) {
                try {
                    const Array3f values = openFiles({folder / "cut"})->read(name, time);
                    ++reads;
                    CHECK(values.values == std::vector<float>(values.values.size(), 7.0f));
                } catch (const Error& error) {
                    ++errors;
                    CHECK(!error.parts().what.empty());
                }
            }
        }
        CHECK(errors > 0);
        CHECK(reads > 0);
    }
}

TEST_CASE("A classic file that is truncated but opens has a note about it") {
    const TemporaryFolder folder;
    writeWrf(folder / "a", {});
    truncateTo(folder / "a", std::filesystem::file_size(folder / "a") - 8);
    const auto dataset = openFiles({folder / "a"});
    REQUIRE(dataset->info().notes.size() == 1);
    CHECK(contains(dataset->info().notes[0], "cut short"));
}

TEST_CASE("A dimension without length is an error that names it") {
    const TemporaryFolder folder;
    WrfSpec noTimes;
    noTimes.times = {};
    writeWrf(folder / "no-times", noTimes);
    CHECK(contains(openError(folder / "no-times").what, "no time"));
    WrfSpec noLevels;
    noLevels.format = NetcdfFormat::netcdf4;
    noLevels.nz = 0;  // NetCDF takes 0 as an unlimited dimension, which stays empty here
    writeWrf(folder / "no-levels", noLevels);
    const ErrorParts error = openError(folder / "no-levels");
    CHECK(contains(error.what, "dimension bottom_top has no length"));
    CHECK(contains(error.found, "bottom_top = 0"));
}

TEST_CASE("A time that cannot be parsed is left out with a note that quotes it") {
    const TemporaryFolder folder;
    for (const std::string wrong :
         {"yesterday at noon  ", "2024-13-06_21:00:00", "                   ",
          "2024-02-30_00:00:00", "2024-05-06_21:61:00"}) {
        WrfSpec spec;
        spec.times = {wrong, "2024-05-06_21:00:00"};
        spec.fields["QCLOUD"] = [](int, int, int, int t) { return t == 1 ? 1e-3f : 9e-3f; };
        writeWrf(folder / "a", spec);
        const auto dataset = openFiles({folder / "a"});
        REQUIRE(dataset->info().times.size() == 1);
        CHECK(dataset->info().times[0].label == "2024-05-06_21:00:00");
        CHECK(dataset->read("QCLOUD", 0).at(0, 0, 0) == 1e-3f);
        REQUIRE(dataset->info().notes.size() == 1);
        CHECK(contains(dataset->info().notes[0], "Times"));
        CHECK(contains(dataset->info().notes[0], wrong));
    }
}

TEST_CASE("Without any time that can be parsed the error quotes the first") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.times = {"yesterday at noon  "};
    writeWrf(folder / "a", spec);
    age(folder / "a");
    const ErrorParts error = openError(folder / "a");
    CHECK(contains(error.what, "Times"));
    CHECK(contains(error.found, "yesterday at noon"));
    CHECK(contains(error.expected, "YYYY-MM-DD_hh:mm:ss"));
    CHECK(contains(error.hint, "interrupted"));
}

TEST_CASE("One record without a time opens with a note, several are an error") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.omit = {"Times"};
    writeWrf(folder / "one", spec);
    const auto dataset = openFiles({folder / "one"});
    REQUIRE(dataset->info().notes.size() == 1);
    CHECK(contains(dataset->info().notes[0], "does not state its time"));
    spec.times.push_back("0001-01-01_00:10:00");
    writeWrf(folder / "two", spec);
    const ErrorParts error = openError(folder / "two");
    CHECK(contains(error.what, "does not state its times"));
    CHECK(contains(error.hint, "keep Times"));
}

TEST_CASE("A grid spacing that is missing or not a length is an error") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.omit = {"DX"};
    writeWrf(folder / "a", spec);
    CHECK(contains(openError(folder / "a").what, "DX"));
    for (const float wrong : {0.0f, -1000.0f, kNan, std::numeric_limits<float>::infinity()}) {
        WrfSpec bad;
        bad.dy = wrong;
        writeWrf(folder / "a", bad);
        CHECK(contains(openError(folder / "a").what, "DY"));
    }
}

TEST_CASE(
    "NaN in heights, or in variables that determine air density, is an error naming the cell") {
    for (const std::string name : {"PH", "P", "T", "QVAPOR"}) {
        CAPTURE(name);
        const TemporaryFolder folder;
        WrfSpec spec;
        spec.fields[name] = [](int x, int y, int z, int) {
            return x == 1 && y == 2 && z == 3 ? kNan : 0.001f;
        };
        spec.fields["QCLOUD"] = [](int, int, int, int) { return 1e-3f; };
        writeWrf(folder / "a", spec);
        const auto dataset = openFiles({folder / "a"});
        const ErrorParts error = errorOf([&] { resample(*dataset, 0); });
        CHECK(contains(error.what, name == "PH" ? "interface_height" : "dry_air_density"));
        CHECK(contains(error.found, "x 1, y 2, level 3"));
        CHECK(!error.hint.empty());
    }
}

TEST_CASE("NaN and negative values of a hydrometeor are counted, noted and set to zero") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.fields["QCLOUD"] = [](int x, int, int z, int) {
        if (z == 0 && x == 0) return kNan;
        if (z == 1 && x < 2) return x == 0 ? -1e-9f : -1e-12f;
        if (z == 2 && x == 3) return 1e20f;
        return z == 3 ? 1e-3f : 0.0f;
    };
    writeWrf(folder / "a", spec);
    const SpeciesVolume volume = resample(*openFiles({folder / "a"}), 0);
    const auto has = [&](std::string_view text) {
        for (const std::string& note : volume.notes) {
            if (contains(note, text)) return true;
        }
        return false;
    };
    CHECK(has("QCLOUD: 3 missing values"));
    CHECK(has("QCLOUD: 6 negative values clipped (smallest -1e-09 kg/kg)"));
    CHECK(has("QCLOUD: 3 impossible values"));
    CHECK(has("QRAIN: zero everywhere"));
    for (const float value : volume.content(Species::cloud).values) {
        CHECK(value >= 0.0f);
        CHECK(value < 1e-3f);
    }
}

TEST_CASE("Heights that do not increase are an error naming the column") {
    const TemporaryFolder folder;
    WrfSpec spec;
    spec.fields["PH"] = [](int x, int, int z, int) { return x == 2 && z == 3 ? -1500.0f : 0.0f; };
    writeWrf(folder / "a", spec);
    const auto dataset = openFiles({folder / "a"});
    const ErrorParts error = errorOf([&] { resample(*dataset, 0); });
    CHECK(contains(error.what, "interface_height"));
    CHECK(contains(error.found, "x 2, y 0, level 3"));
    CHECK(contains(error.expected, "level below"));
}

TEST_CASE("A time at which every mixing ratio is zero gives a note and not an error") {
    const TemporaryFolder folder;
    writeWrf(folder / "a", {});
    const SpeciesVolume volume = resample(*openFiles({folder / "a"}), 0);
    REQUIRE(volume.notes.size() == 1);
    CHECK(contains(volume.notes[0], "no condensate at 0001-01-01_00:00:00"));
    REQUIRE(volume.has(Species::cloud));
    CHECK(volume.has(Species::rain));
    CHECK(!volume.has(Species::ice));
    for (const float value : volume.content(Species::cloud).values) CHECK(value == 0.0f);
}

TEST_CASE("The error for an unknown variable or time lists those that exist") {
    const TemporaryFolder folder;
    writeWrf(folder / "a", {});
    const auto dataset = openFiles({folder / "a"});
    const ErrorParts variable = errorOf([&] { dataset->read("QCLOUDS", 0); });
    CHECK(contains(variable.what, "QCLOUDS"));
    CHECK(contains(variable.found, "QRAIN"));
    CHECK(contains(variable.hint, "did you mean QCLOUD"));
    CHECK(contains(errorOf([&] { dataset->read("T", 1); }).what, "no time 1"));
    CHECK(contains(errorOf([&] { dataset->read("T", -1); }).what, "no time -1"));
}
