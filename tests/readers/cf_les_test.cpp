// cf_les_test.cpp: one small file of each model, with values that were computed by hand or with
// numpy from the formulas of docs/readers.md.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <map>

#include "core/base/utc_time.h"
#include "tests/readers/les_maker.h"
#include "tests/readers/reader_host.h"
#include "tests/temporary_folder.h"

using namespace neph;

namespace {

std::shared_ptr<Dataset> opened(const TemporaryFolder& folder, const LesFile& file,
                                const std::string& name = "a.nc") {
    writeLes(folder / name, file);
    return openFiles({folder / name});
}

const VariableInfo& waterOf(const DatasetInfo& info, Species species) {
    const VariableInfo* found = info.find(VariableRole::mixingRatio, species);
    REQUIRE(found != nullptr);
    return *found;
}

/// Every cell of a field holds numbered() of its place, times `factor`.
void checkNumbered(Dataset& dataset, const std::string& name, double factor = 1.0, int time = 0) {
    const Array3f q = dataset.read(name, time);
    REQUIRE(q.size == glm::ivec3(4, 3, 5));
    for (int z = 0; z < 5; ++z) {
        for (int y = 0; y < 3; ++y) {
            for (int x = 0; x < 4; ++x) {
                const auto at = [](int i) { return static_cast<std::size_t>(i); };
                const double right = factor * numbered(at(time), at(z), at(y), at(x));
                CHECK(static_cast<double>(q.at(x, y, z)) == doctest::Approx(right).epsilon(1e-6));
            }
        }
    }
}

/// Where no faces are stored, they lie halfway between cells, half a step beyond the last.
const std::vector<double> kHalfwayM{0.0, 45.0, 105.0, 185.0, 285.0, 395.0};

void checkGrid(Dataset& dataset, const std::vector<double>& facesM = kSampleFacesM) {
    const DatasetInfo& info = dataset.info();
    CHECK(info.reader == "cf_les");
    CHECK(info.size == glm::ivec3(4, 3, 5));
    CHECK(info.spacingM.x == doctest::Approx(100.0));
    CHECK(info.spacingM.y == doctest::Approx(200.0));
    const Array3f heights = dataset.read("interface_height", 0);
    REQUIRE(heights.size.z == 6);
    for (int k = 0; k < 6; ++k) {
        const auto right = facesM[static_cast<std::size_t>(k)];
        CHECK(static_cast<double>(heights.at(0, 0, k)) == doctest::Approx(right).epsilon(1e-5));
    }
}

/// The value in the first cell of a variable with a role.
double first(Dataset& dataset, VariableRole role, std::optional<Species> species = {}) {
    const VariableInfo* found = dataset.info().find(role, species);
    REQUIRE(found != nullptr);
    return static_cast<double>(dataset.read(found->name, 0).values.front());
}

}  // namespace

TEST_CASE("CM1 in NetCDF: levels from zf, units as stated, scheme, place and the moving grid") {
    const TemporaryFolder folder;
    const auto dataset = opened(folder, cm1Sample());
    const DatasetInfo& info = dataset->info();
    checkGrid(*dataset);
    CHECK(info.model == "CM1 r21.1");
    CHECK(info.scheme == "Morrison (ptype 5)");
    CHECK(info.microphysics == Microphysics::morrison);
    REQUIRE(info.times.size() == 2);
    CHECK(info.times[0].label == "600 s");
    CHECK(info.times[1].seconds == 300.0);
    // 12.5 and -2 m/s since the start of the run.
    CHECK(info.times[0].gridOffsetM == glm::dvec2(7500.0, -1200.0));
    CHECK(info.times[1].gridOffsetM == glm::dvec2(11250.0, -1800.0));
    REQUIRE(info.times[0].utc);
    CHECK(utcText(*info.times[0].utc) == "2009-05-15T21:40:00Z");
    CHECK(contains(info.map.projection, "+lat_0=36 +lon_0=-98"));
    CHECK(info.map.originM == glm::dvec2(-200.0, -300.0));
    checkNumbered(*dataset, "qc");
    checkNumbered(*dataset, "qc", 1.0, 1);
    CHECK(waterOf(info, Species::graupel).name == "qg");
    CHECK(hasNote(info, "ihail"));
    CHECK(hasNote(info, "hydrometeors that are not in the file"));
    CHECK(first(*dataset, VariableRole::airTemperature) ==
          doctest::Approx(291.1129099).epsilon(1e-6));
    CHECK(first(*dataset, VariableRole::dryAirDensity) == doctest::Approx(1.0600140).epsilon(1e-5));
    CHECK(info.find("u")->size == glm::ivec3(5, 3, 5));
    CHECK(info.find("uinterp")->standardName == "x_wind");
    CHECK(contains(info.find("qc")->reason, "CM1"));
    CHECK(contains(info.find("air_temperature")->reason, "computed"));
}

TEST_CASE("CM1's namelist says whether rimed ice is hail, and how many droplets there are") {
    const TemporaryFolder folder;
    std::ofstream(folder / "namelist.input")
        << "\n &param0\n ptype = 5,\n ihail = 1,\n ndcnst = 100.0,\n/";
    const auto dataset = opened(folder, cm1Sample());
    CHECK(waterOf(dataset->info(), Species::hail).name == "qg");
    CHECK(dataset->info().cloudDropletsPerM3 == 1e8);
    std::ofstream(folder / "namelist.input") << " ptype = 3,\n";
    const auto other = openFiles({folder / "a.nc"});
    CHECK(hasNote(other->info(), "namelist.input is not that of this run"));
    CHECK(waterOf(other->info(), Species::graupel).name == "qg");
}

TEST_CASE("CM1's terrain lifts its levels, by the heights of cells or by the ground alone") {
    const TemporaryFolder folder;
    LesFile file = cm1Sample();
    file.variables.push_back(field("zs", {"time", "yh", "xh"}, "m", constant(50.0)));
    const auto dataset = opened(folder, file);
    const Array3f heights = dataset->read("interface_height", 0);
    REQUIRE(heights.size == glm::ivec3(4, 3, 6));
    // z = zs + zeta (top - zs) / top.
    CHECK(heights.at(1, 1, 0) == doctest::Approx(50.0));
    CHECK(heights.at(1, 1, 2) == doctest::Approx(50.0 + 100.0 * 350.0 / 400.0));
    CHECK(heights.at(1, 1, 5) == doctest::Approx(400.0));
    file.variables.push_back(
        field("zhval", {"time", "zh", "yh", "xh"}, "m",
              [](std::span<const std::size_t> at) { return kSampleCentresM[at[1]] + 7.0; }));
    const auto exact = opened(folder, file, "b.nc");
    const Array3f cells = exact->read("interface_height", 0);
    // Interfaces divide the distance of cells as the nominal ones do: 27 + (100 - 70) / 70 * 70.
    CHECK(cells.at(0, 0, 2) == doctest::Approx(107.0));
}

TEST_CASE("CM1's stretched columns have the faces that the file states") {
    const TemporaryFolder folder;
    LesFile file = cm1Sample();
    file.variable("xh").value = along("xh", {0.05, 0.15, 0.3, 0.6}, "km").value;
    file.variables.push_back(along("xf", {0.0, 0.1, 0.2, 0.4, 0.8}, "km"));
    const auto dataset = opened(folder, file);
    REQUIRE(dataset->info().edgesM[0].size() == 5);
    CHECK(dataset->info().edgesM[0][3] == doctest::Approx(400.0));
    CHECK(dataset->info().edgesM[0][4] == doctest::Approx(800.0));
    CHECK(dataset->info().spacingM.x == doctest::Approx(100.0));
    CHECK(dataset->info().edgesM[1].empty());
}

TEST_CASE("An axisymmetric run of CM1 is revolved around its axis") {
    const TemporaryFolder folder;
    LesFile file = cm1Sample();
    file.resize("yh", 1);
    file.numbers["axisymm"] = 1;
    file.numbers["ny"] = 1;
    const auto dataset = opened(folder, file);
    CHECK(dataset->info().size == glm::ivec3(8, 8, 5));
}

TEST_CASE("SAM divides cloud and precipitation by temperature, as its single-moment scheme does") {
    const TemporaryFolder folder;
    const auto dataset = opened(folder, samSample());
    const DatasetInfo& info = dataset->info();
    checkGrid(*dataset, kHalfwayM);
    CHECK(info.times[0].label == "43200 s");
    CHECK(first(*dataset, VariableRole::airPressure) == doctest::Approx(90100.0));
    CHECK(first(*dataset, VariableRole::dryAirDensity) == doctest::Approx(1.0688080).epsilon(1e-5));
    const std::map<Species, std::array<double, 5>> shares{
        {Species::cloud, {1.0, 1.0, 0.5, 0.0, 0.0}},
        {Species::ice, {0.0, 0.0, 0.5, 1.0, 1.0}},
        {Species::rain, {1.0, 0.5, 0.0, 0.0, 0.0}},
        {Species::snow, {0.0, 0.0625, 1.0 / 3.0, 0.5, 1.0}},
        {Species::graupel, {0.0, 0.4375, 2.0 / 3.0, 0.5, 0.0}}};
    for (const auto& each : shares) {
        const Species species = each.first;
        CAPTURE(static_cast<int>(species));
        const Array3f q = dataset->read(waterOf(info, species).name, 0);
        const bool cloud = species == Species::cloud || species == Species::ice;
        for (int k = 0; k < 5; ++k) {
            const auto level = static_cast<std::size_t>(k);
            const double whole = cloud ? numbered(0, level, 2, 3) : 1e-3;
            const double right = each.second[level] * whole;
            CHECK(std::abs(static_cast<double>(q.at(3, 2, k)) - right) < 1e-5 * whole);
        }
    }
    CHECK(hasNote(info, "divided by temperature"));
}

TEST_CASE("SAM with a double-moment scheme has its hydrometeors as stored") {
    const TemporaryFolder folder;
    LesFile file = samSample();
    file.variables.push_back(field("QC", {"time", "z", "y", "x"}, "g/kg", constant(0.5)));
    file.variables.push_back(field("QR", {"time", "z", "y", "x"}, "g/kg", constant(0.25)));
    const auto dataset = opened(folder, file);
    CHECK(waterOf(dataset->info(), Species::cloud).name == "QC");
    CHECK(dataset->info().find(VariableRole::mixingRatio, Species::snow) == nullptr);
    CHECK(first(*dataset, VariableRole::mixingRatio, Species::rain) == doctest::Approx(2.5e-4));
}

TEST_CASE(
    "DALES: the unit that it states for water is wrong, and amounts are per kg of moist air") {
    const TemporaryFolder folder;
    LesFile file = dalesSample();
    const auto axes = file.variable("ql").axes;
    file.variables.push_back(field("pressure", axes, "Pa", constant(9e4)));
    const auto dataset = opened(folder, file);
    const DatasetInfo& info = dataset->info();
    checkGrid(*dataset);
    // r = q / (1 - q_t - q_r), q_t = 0.01, q_r = 1e-5.
    checkNumbered(*dataset, waterOf(info, Species::cloud).name, 1.0 / 0.98999);
    CHECK(hasNote(info, "1e-5kg/kg stated, kg kg-1 taken"));
    CHECK(first(*dataset, VariableRole::airTemperature) ==
          doctest::Approx(281.3973379).epsilon(1e-6));
    CHECK(info.find("ql")->role == VariableRole::other);
}

TEST_CASE("PALM: the level on the ground is left out, and cells within buildings are missing") {
    const TemporaryFolder folder;
    const auto dataset = opened(folder, palmSample());
    const DatasetInfo& info = dataset->info();
    checkGrid(*dataset);
    const Array3f q = dataset->read("ql", 0);
    CHECK(std::isnan(q.at(0, 0, 0)));
    CHECK(static_cast<double>(q.at(1, 2, 4)) == doctest::Approx(numbered(0, 4, 2, 1)));
    CHECK(hasNote(info, "1 of 6 levels are left out"));
    CHECK(contains(info.map.projection, "+lat_0=52 +lon_0=9"));
    CHECK(info.map.originM == glm::dvec2(0.0));
    // 1e8 per m3 of the standard atmosphere's air at 20 m: 1.22265 kg/m3.
    CHECK(first(*dataset, VariableRole::numberConcentration, Species::cloud) ==
          doctest::Approx(1e8 / 1.22265).epsilon(1e-5));
    CHECK(hasNote(info, "Standard Atmosphere"));
}

TEST_CASE("Of two names of one water the row's first is drawn, in whatever order a file has them") {
    const TemporaryFolder folder;
    LesFile file = palmSample();
    file.variables.push_back(field("qc", file.variable("ql").axes, "kg/kg", constant(2e-4)));
    const auto dataset = opened(folder, file);
    CHECK(waterOf(dataset->info(), Species::cloud).name == "qc_per_dry_air");
    CHECK(hasNote(dataset->info(), "ql (like qc)"));
    // r = q / (1 - q_v - q_c): ql is not counted again.
    CHECK(first(*dataset, VariableRole::mixingRatio, Species::cloud) ==
          doctest::Approx(2e-4 / (1.0 - 0.01 - 2e-4)).epsilon(1e-6));
}

TEST_CASE("MONC: z is the fastest axis, widths are options, and the base state completes the air") {
    const TemporaryFolder folder;
    const auto dataset = opened(folder, moncSample());
    checkGrid(*dataset);
    checkNumbered(*dataset, "q_cloud_liquid_mass");
    CHECK(first(*dataset, VariableRole::airPressure) == doctest::Approx(9e4));
    CHECK(first(*dataset, VariableRole::airTemperature) ==
          doctest::Approx(291.1065074).epsilon(1e-6));
    const Array3f density =
        dataset->read(dataset->info().find(VariableRole::dryAirDensity)->name, 0);
    CHECK(static_cast<double>(density.at(0, 0, 0)) == doctest::Approx(1.19));
}

TEST_CASE("UCLALES: the level below the ground is left out, and contents follow its density") {
    const TemporaryFolder folder;
    const auto dataset = opened(folder, uclalesSample());
    checkGrid(*dataset);
    checkNumbered(*dataset, "l");
    CHECK(first(*dataset, VariableRole::dryAirDensity) == doctest::Approx(1.1));
    CHECK(dataset->info().times[0].label == "600 s");
}

TEST_CASE("Meso-NH: columns and levels outside the domain are left out, and terrain lifts levels") {
    const TemporaryFolder folder;
    const auto dataset = opened(folder, mesoNhSample());
    const DatasetInfo& info = dataset->info();
    CHECK(info.size == glm::ivec3(4, 3, 5));
    CHECK(info.spacingM == glm::dvec2(100.0, 200.0));
    checkNumbered(*dataset, "RCT");
    const Array3f heights = dataset->read("interface_height", 0);
    REQUIRE(heights.size == glm::ivec3(4, 3, 6));
    // The first column of the domain is the second of the file, 10 m high.
    CHECK(heights.at(0, 0, 0) == doctest::Approx(10.0));
    CHECK(heights.at(0, 0, 2) == doctest::Approx(10.0 + 100.0 * 390.0 / 400.0));
    CHECK(heights.at(3, 2, 5) == doctest::Approx(400.0));
    CHECK(utcText(*info.times[0].utc) == "2001-01-01T12:10:00Z");
    CHECK(first(*dataset, VariableRole::dryAirDensity) == doctest::Approx(1.0599753).epsilon(1e-5));
}

TEST_CASE("Plain CF: roles by standard names, axes by attributes, rows and levels turned") {
    const TemporaryFolder folder;
    const auto dataset = opened(folder, cfSample());
    const DatasetInfo& info = dataset->info();
    checkGrid(*dataset, kHalfwayM);
    // r = q / (1 - 0.02 - q).
    const Array3f q = dataset->read(waterOf(info, Species::cloud).name, 0);
    const double right = numbered(0, 4, 2, 3);
    CHECK(static_cast<double>(q.at(3, 2, 4)) ==
          doctest::Approx(right / (0.98 - right)).epsilon(1e-6));
    CHECK(static_cast<double>(q.at(0, 0, 0)) == doctest::Approx(1e-6 / 0.979999).epsilon(1e-6));
    CHECK(first(*dataset, VariableRole::dryAirDensity) == doctest::Approx(1.0468412).epsilon(1e-5));
    CHECK(utcText(*info.times[0].utc) == "2020-06-01T00:30:00Z");
    CHECK(contains(info.map.projection, "+proj=lcc +lat_0=50 +lon_0=10 +R=6370000 +lat_1=30"));
    CHECK(info.map.originM == glm::dvec2(0.0));
    CHECK(contains(waterOf(info, Species::cloud).reason, "its standard name"));
}
