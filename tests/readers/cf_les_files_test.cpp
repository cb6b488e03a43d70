// cf_les_files_test.cpp: data sets of several files, maps for unknown files, and what is refused.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <map>

#include "tests/readers/les_maker.h"
#include "tests/readers/reader_host.h"
#include "tests/temporary_folder.h"

using namespace neph;

namespace {

namespace fs = std::filesystem;

/// Writes a sample of DALES as 2 x 1 tiles of 2 x 3 columns.
void writeTiles(const fs::path& folder) {
    for (const std::size_t tile : {0U, 1U}) {
        LesFile file = dalesSample();
        file.resize("xt", 2);
        file.variable("xt").value = [tile](std::span<const std::size_t> at) {
            return kSampleXM[2 * tile + at[0]];
        };
        file.variable("ql").value = [tile](std::span<const std::size_t> at) {
            return numbered(at[0], at[1], at[2], 2 * tile + at[3]);
        };
        file.drop("qr");
        file.drop("qt");
        writeLes(folder / ("fielddump.00" + std::to_string(tile) + ".000.001.nc"), file);
    }
}

/// A file with names that no model has.
LesFile unknownFile() {
    LesFile file;
    file.dimensions = {{"n", 1}, {"lev", 5}, {"row", 3}, {"col", 4}};
    file.variables = {along("col", {0.05, 0.15, 0.25, 0.35}, ""), along("row", {0.1, 0.3, 0.5}, ""),
                      along("lev", {0.02, 0.07, 0.14, 0.23, 0.34}, ""),
                      field("WATER", {"n", "lev", "row", "col"}, "",
                            [](std::span<const std::size_t> at) {
                                return 1e3 * numbered(0, at[1], at[2], at[3]);
                            }),
                      field("DENS", {"lev"}, "kg/m3", constant(1.1))};
    return file;
}

const std::string kMap = R"({"type": "nephoscope-map", "version": 1, "model": "my LES",
  "axes": {"x": "col", "y": "row", "z": {"dimension": "lev"}}, "length_unit": "km",
  "variables": [{"name": "WATER", "role": "mixing_ratio", "species": "cloud", "unit": "g/kg"},
                {"name": "DENS", "role": "dry_air_density"}]})";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("Tiles of DALES make one domain, whichever of them is opened") {
    const TemporaryFolder folder;
    writeTiles(folder.path());
    for (const char* name : {"fielddump.000.000.001.nc", "fielddump.001.000.001.nc"}) {
        const auto dataset = openFiles({folder / name});
        CHECK(dataset->info().size == glm::ivec3(4, 3, 5));
        const VariableInfo* cloud = dataset->info().find(VariableRole::mixingRatio, Species::cloud);
        REQUIRE(cloud != nullptr);
        const Array3f q = dataset->read(cloud->name, 0);
        for (int x = 0; x < 4; ++x) {
            const double right = numbered(0, 3, 2, static_cast<std::size_t>(x));
            CHECK(static_cast<double>(q.at(x, 2, 3)) ==
                  doctest::Approx(right / (1.0 - right)).epsilon(1e-6));
        }
    }
    const auto whole = openFiles({folder.path()});
    CHECK(whole->info().times.size() == 1);
    CHECK(whole->info().size == glm::ivec3(4, 3, 5));
}

TEST_CASE("Tiles with a gap are refused, as is one tile of CM1 without the others") {
    const TemporaryFolder folder;
    writeTiles(folder.path());
    LesFile third = dalesSample();
    third.resize("xt", 2);
    third.variable("yt").value = [](std::span<const std::size_t> at) {
        return 700.0 + 200.0 * static_cast<double>(at[0]);
    };
    writeLes(folder / "fielddump.000.001.001.nc", third);
    CHECK(contains(openError(folder / "fielddump.000.000.001.nc").what, "do not make a domain"));
    LesFile cm1 = cm1Sample();
    cm1.numbers["nx"] = 8;
    writeLes(folder / "cm1out_000000_000001.nc", cm1);
    const ErrorParts error = openError(folder / "cm1out_000000_000001.nc");
    CHECK(contains(error.what, "part of its domain"));
    CHECK(contains(error.found, "4 x 3"));
    CHECK(contains(error.hint, "output_filetype"));
}

TEST_CASE("MicroHH's files of one variable each belong together") {
    const TemporaryFolder folder;
    writeLes(folder / "ql.nc", microhhSample("ql"));
    writeLes(folder / "qr.nc", microhhSample("qr"));
    LesFile later = microhhSample("qi");
    later.variable("time").value = constant(1200.0);
    writeLes(folder / "qi.nc", later);
    const auto dataset = openFiles({folder / "qr.nc"});
    const DatasetInfo& info = dataset->info();
    CHECK(info.model == "MicroHH");
    CHECK(info.find(VariableRole::mixingRatio, Species::cloud) != nullptr);
    CHECK(info.find(VariableRole::mixingRatio, Species::rain) != nullptr);
    CHECK(info.find(VariableRole::mixingRatio, Species::ice) == nullptr);
    CHECK(hasNote(info, "qi.nc is not used: it has other times"));
    CHECK(info.times[0].label == "600 s");
    CHECK(info.parts.size() == 1);
    CHECK(hasNote(info, "Standard Atmosphere"));
    // The model's reference density, where its file lies beside: 5 levels and 6 interfaces.
    const std::array<float, 11> density{1.1f, 1.09f, 1.08f, 1.07f, 1.06f, 1.f,
                                        1.f,  1.f,   1.f,   1.f,   1.f};
    std::ofstream(folder / "rhoref.0000000", std::ios::binary)
        .write(reinterpret_cast<const char*>(density.data()), sizeof density);
    const auto dense = openFiles({folder / "qr.nc"});
    CHECK(dense->info().find(VariableRole::dryAirDensity)->name == "rhoref");
    CHECK(dense->read("rhoref", 0).values.at(3) == 1.07f);
    CHECK(dense->info().find(VariableRole::mixingRatio, Species::rain)->name == "qr");
}

TEST_CASE("A map beside a file says what its variables are") {
    const TemporaryFolder folder;
    writeLes(folder / "out.nc", unknownFile());
    CHECK(contains(openError(folder / "out.nc").hint, "nephoscope-map"));
    for (const char* name : {"out.nc.map.json", "out.map.json", "nephoscope-map.json"}) {
        std::ofstream(folder / name) << kMap;
        const auto dataset = openFiles({folder / "out.nc"});
        const DatasetInfo& info = dataset->info();
        CHECK(info.model == "my LES");
        CHECK(info.spacingM == glm::dvec2(100.0, 200.0));
        const Array3f q = dataset->read("WATER", 0);
        CHECK(static_cast<double>(q.at(3, 2, 4)) == doctest::Approx(numbered(0, 4, 2, 3)));
        CHECK(info.find("DENS")->role == VariableRole::dryAirDensity);
        CHECK(hasNote(info, name));
        fs::remove(folder / name);
    }
}

TEST_CASE("A map that the user names goes before what a file is by itself, wherever it lies") {
    const TemporaryFolder folder;
    LesFile file = cm1Sample();
    file.variables.push_back(field("fog", file.variable("qc").axes, "kg/kg", constant(3e-4)));
    writeLes(folder / "a.nc", file);
    fs::create_directories(folder / "maps");
    std::ofstream(folder / "maps/m.json") << R"({"type": "nephoscope-map", "version": 1,
        "axes": {"x": "xh", "y": "yh", "z": "zh"}, "length_unit": "km",
        "variables": [{"name": "fog", "role": "mixing_ratio", "species": "cloud"}]})";
    const std::vector<fs::path> readers{NEPH_TEST_READER_DIR};
    const PluginHost host(readers, {}, folder / "maps/m.json");
    const std::vector<fs::path> files{folder / "a.nc"};
    const auto dataset = Dataset::open(files, host);
    CHECK(dataset->info().find(VariableRole::mixingRatio, Species::cloud)->name == "fog");
    CHECK(dataset->read("fog", 0).values.front() == doctest::Approx(3e-4f));
    CHECK(dataset->info().find("qc")->role == VariableRole::other);
    CHECK(contains(errorOf([] { PluginHost::standard({}, "nowhere.json"); }).what, "no such map"));
    // Without it the file is what it is by itself: the description was not remembered.
    const auto plain = openFiles({folder / "a.nc"});
    CHECK(plain->info().find(VariableRole::mixingRatio, Species::cloud)->name == "qc");
}

TEST_CASE("An edited map is read again by a program that remembers the file") {
    const TemporaryFolder folder;
    const TemporaryFolder cache;
    writeLes(folder / "out.nc", unknownFile());
    const std::vector<fs::path> files{folder / "out.nc"};
    std::ofstream(folder / "out.map.json") << kMap;
    CHECK(Dataset::open(files, readerHost(), cache.path(), {})->info().model == "my LES");
    std::ofstream(folder / "out.map.json") << replaced(kMap, "my LES", "another");
    CHECK(Dataset::open(files, readerHost(), cache.path(), {})->info().model == "another");
}

TEST_CASE("A map with a fault is refused with the key") {
    const TemporaryFolder folder;
    writeLes(folder / "out.nc", unknownFile());
    const std::map<std::pair<std::string, std::string>, std::string> faults{
        {{"\"version\": 1", "\"version\": 2"}, "another version"},
        {{"\"length_unit\"", "\"length\""}, "length is no key"},
        {{"mixing_ratio", "mixing"}, "variables[0].role is no role"},
        {{", \"species\": \"cloud\"", ""}, "variables[0].species is missing"},
        {{"\"cloud\"", "\"fog\""}, "variables[0].species is not known"},
        {{"g/kg", "parsec"}, "variables[0].unit is no unit"},
        {{"\"name\": \"DENS\"", "\"name\": \"WATER\""}, "there twice"},
        {{"{\"dimension\": \"lev\"}", "{\"faces\": \"lev\"}"}, "axes.z.dimension is missing"},
        {{"\"variables\": [", "\"variables\": [3, "}, "variables[0] is not an object"},
        {{"{\"type\"", "{{\"type\""}, "is not JSON"}};
    for (const auto& fault : faults) {
        CAPTURE(fault.second);
        std::ofstream(folder / "out.map.json")
            << replaced(kMap, fault.first.first, fault.first.second);
        const ErrorParts error = openError(folder / "out.nc");
        CHECK(contains(error.what, fault.second));
        CHECK(contains(error.where, "out.map.json"));
    }
}

TEST_CASE("What cannot be read of a model is refused with the reason") {
    const TemporaryFolder folder;
    const auto refused = [&](const LesFile& file) {
        writeLes(folder / "a.nc", file);
        return openError(folder / "a.nc");
    };
    LesFile noWater = cm1Sample();
    noWater.drop("qc");
    noWater.drop("qg");
    CHECK(contains(refused(noWater).what, "without hydrometeors"));
    LesFile otherUnit = cm1Sample();
    otherUnit.variable("qc").units = "m";
    CHECK(contains(refused(otherUnit).what, "the unit of variable qc"));
    LesFile degrees = cfSample();
    degrees.variable("east").units = "degrees_east";
    CHECK(contains(refused(degrees).what, "coordinate east is no length"));
    LesFile noHeights = moncSample();
    noHeights.drop("z");
    noHeights.drop("zn");
    CHECK(contains(refused(noHeights).what, "how high its levels are"));
    LesFile noWidths = moncSample();
    noWidths.drop("options_database");
    CHECK(contains(refused(noWidths).what, "where its cells lie in x"));
    LesFile noTimes = cm1Sample();
    noTimes.drop("time");
    CHECK(contains(refused(noTimes).what, "does not state its times"));
}

TEST_CASE("The CM1 supercell has the maxima and columns that numpy finds in its files" *
          doctest::skip(std::getenv("NEPHOSCOPE_MODEL_DATA") == nullptr)) {
    const fs::path folder = fs::path(std::getenv("NEPHOSCOPE_MODEL_DATA")) / "cm1-supercell";
    const auto dataset = openFiles({folder});
    REQUIRE(dataset->info().times.size() == 3);
    const auto greatest = [&](const std::string& name, int time) {
        float most = -std::numeric_limits<float>::infinity();
        for (const float value : dataset->read(name, time).values) most = std::max(most, value);
        return static_cast<double>(most);
    };
    // Maxima in g/kg; heaviest columns, the sum of q rho dz over zf, in kg/m2.
    struct Numbers {
        std::array<double, 3> gPerKg, kgPerM2;
    };
    const std::map<std::string, Numbers> species{
        {"qc", {{5.95856, 7.51495, 7.62939}, {20.8751, 23.1104, 24.7168}}},
        {"qr", {{7.78961, 8.37708, 8.56018}, {24.9586, 24.5536, 20.9779}}},
        {"qi", {{1.61934, 1.91498, 2.04086}, {2.44331, 3.28512, 3.85653}}},
        {"qs", {{1.40953, 1.17302, 1.98746}, {2.99303, 3.31159, 3.74116}}},
        {"qg", {{12.8326, 12.8021, 13.2904}, {51.3985, 49.1009, 50.2106}}}};
    const std::map<std::string, std::array<double, 3>> others{
        {"winterp", {52.8125, 58.0, 54.0625}},
        {"uinterp", {42.6875, 46.5, 55.25}},
        {"dbz", {68.625, 68.25, 68.375}},
        {"cape", {1925.862, 2055.088, 2205.944}}};
    for (std::size_t time = 0; time < 3; ++time) {
        const int at = static_cast<int>(time);
        const Array3f rho = dataset->read("rho", at);
        for (const auto& each : species) {
            CAPTURE(each.first);
            CHECK(1e3 * greatest(each.first, at) ==
                  doctest::Approx(each.second.gPerKg[time]).epsilon(1e-5));
            const Array3f q = dataset->read(each.first, at);
            std::vector<double> columns(84 * 84);
            for (std::size_t i = 0; i < q.values.size(); ++i) {
                columns[i % columns.size()] +=
                    500.0 * static_cast<double>(q.values[i]) * static_cast<double>(rho.values[i]);
            }
            CHECK(*std::ranges::max_element(columns) ==
                  doctest::Approx(each.second.kgPerM2[time]).epsilon(1e-5));
        }
        for (const auto& each : others) {
            CAPTURE(each.first);
            CHECK(greatest(each.first, at) == doctest::Approx(each.second[time]).epsilon(1e-6));
        }
    }
    CHECK(dataset->info().times[2].gridOffsetM == glm::dvec2(90'000.0, 21'600.0));
    CHECK(dataset->info().find(VariableRole::mixingRatio, Species::hail)->name == "qg");
}
