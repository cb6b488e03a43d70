// raw_les_names_test.cpp: names of hydrometeors in descriptors: of CM1's schemes, of WRF and
// others, and what is said about those that are not drawn.
#include <doctest/doctest.h>

#include "tests/readers/raw_maker.h"
#include "tests/readers/reader_host.h"
#include "tests/temporary_folder.h"

using namespace neph;

namespace {

GradsSpec withNames(const std::vector<std::string>& names) {
    GradsSpec spec;
    spec.times = 1;
    spec.variables.clear();
    for (const std::string& name : names) {
        spec.variables.push_back(contains(name, " ") ? name : name + " {} 99 x (kg/kg)");
    }
    spec.value = [](auto v, auto, auto, auto, auto) {
        return 1e-3f * static_cast<float>(std::size_t{1} << v);
    };
    return spec;
}

DatasetInfo infoOf(const GradsSpec& spec, const std::string& namelist = {}) {
    const TemporaryFolder folder;
    const auto ctl = writeGrads(folder.path(), spec);
    if (!namelist.empty()) writeText(folder / "namelist.input", namelist);
    return openFiles({ctl})->info();
}

}  // namespace

TEST_CASE("Names of WRF, NCEP and SAM are hydrometeors, in any case") {
    const std::vector<std::vector<std::string>> families{
        {"QCLOUD", "QICE", "QRAIN", "QSNOW", "QGRAUP", "QHAIL"},
        {"qcloud", "qice", "Qrain", "qsnow", "qgraup", "qhail"},
        {"clwmr", "icmr", "rwmr", "snmr", "grle", "hail"},
        {"QCL", "QCI", "QPL", "QPI", "QG", "QH"}};
    for (const auto& names : families) {
        const DatasetInfo info = infoOf(withNames(names));
        for (int i = 0; i < 6; ++i) {
            const auto* found = info.find(VariableRole::mixingRatio, static_cast<Species>(i));
            REQUIRE(found != nullptr);
            CHECK(found->name == names[static_cast<std::size_t>(i)]);
        }
    }
}

TEST_CASE("Categories of ice are added up, and so are hail and large hail") {
    const TemporaryFolder folder;
    const auto spec = withNames({"qc", "qi1", "qi2", "qi3", "qh", "qhl"});
    const auto dataset = openFiles({writeGrads(folder.path(), spec)});
    const auto* ice = dataset->info().find(VariableRole::mixingRatio, Species::ice);
    REQUIRE(ice != nullptr);
    CHECK(ice->name == "qi1+qi2+qi3");
    CHECK(dataset->read(ice->name, 0).values[7] == doctest::Approx(2e-3 + 4e-3 + 8e-3));
    CHECK(dataset->info().find("qi2")->role == VariableRole::other);
    const auto* hail = dataset->info().find(VariableRole::mixingRatio, Species::hail);
    CHECK(dataset->read(hail->name, 0).values[0] == doctest::Approx(16e-3 + 32e-3));
}

TEST_CASE("Two names of the same water are not added up, and the second is named") {
    const DatasetInfo info = infoOf(withNames({"qc", "ql", "qr"}));
    CHECK(info.find(VariableRole::mixingRatio, Species::cloud)->name == "qc");
    CHECK(info.find("ql")->role == VariableRole::other);
    CHECK(hasNote(info, "ql (like qc): is listed and not used"));
}

TEST_CASE("A hydrometeor that is not drawn is named") {
    const DatasetInfo info = infoOf(withNames({"qc", "qr 0 99 rain at the ground (kg/kg)", "qx",
                                               "qz", "qv", "qir", "qib {} 99 rime volume (m^3/kg)",
                                               "th {} 99 theta (K)", "prs {} 99 pressure (Pa)"}));
    CHECK(hasNote(info, "qr: is not drawn"));
    CHECK(hasNote(info, "qx, qz: are listed and not drawn"));
    CHECK_FALSE(hasNote(info, "qv"));
    CHECK_FALSE(hasNote(info, "qir"));
    CHECK_FALSE(hasNote(info, "qib"));
}

TEST_CASE("Hydrometeors that CM1's scheme has and the file lacks are named") {
    const DatasetInfo info = infoOf(withNames({"qc", "qr", "qi"}), " ptype = 52,\n");
    CHECK(info.scheme == "P3 with two ice categories (ptype 52)");
    CHECK(hasNote(info, "not drawn: qi2 (cloud ice)."));
    CHECK_FALSE(hasNote(infoOf(withNames({"qc", "qr"}), " ptype = 1,\n"), "are not in the file"));
    CHECK(hasNote(infoOf(withNames({"qc"}), " ptype = 1,\n"), "qr (rain)"));
    CHECK_FALSE(hasNote(infoOf(withNames({"ql"}), " ptype = 6,\n"), "are not in the file"));
}

TEST_CASE("A descriptor made of WRF output in degrees is answered with the wrfout") {
    GradsSpec spec = withNames({"QCLOUD"});
    spec.title = "OUTPUT FROM WRF V4.2 MODEL";
    spec.metadata = false;
    const TemporaryFolder folder;
    const auto hint = [&] {
        return errorOf([&] { openFiles({writeGrads(folder.path(), spec)}); }).hint;
    };
    CHECK(contains(hint(), "open the wrfout file itself"));
    spec.xdef = "pdef 5 4 lcc 40 -100 1 1 30 60 -100 1000 1000\nxdef 5 linear -100 0.01\n";
    CHECK(contains(hint(), "open the wrfout file itself"));
    spec.title = "a model";
    CHECK(contains(hint(), "nephoscope-brick"));
    spec.xdef = "dtype netcdf\nxdef 5 linear 0 1\n";
    CHECK(contains(hint(), "open a NetCDF file itself"));
    spec.xdef = "edef 3\nxdef 5 linear 0 1\n";
    CHECK(contains(hint(), "nephoscope-brick"));
}

TEST_CASE("Of a folder with model levels and the same interpolated, the model levels are opened") {
    const TemporaryFolder folder;
    const auto ctl = writeGrads(folder.path(), GradsSpec{});
    std::filesystem::copy_file(ctl, folder / "cm1out_i.ctl");
    const auto attributes = openFiles({folder.path()})->info().attributes;
    CHECK(attributes.at("descriptor") == "cm1out_s.ctl");
}

TEST_CASE("Vapour has its role where pressure and temperature of the air are known") {
    const DatasetInfo info = infoOf({});
    REQUIRE(info.find(VariableRole::waterVapour) != nullptr);
    CHECK(info.find(VariableRole::waterVapour)->name == "qv");
    CHECK(info.find(VariableRole::waterVapour)->standardName == "humidity_mixing_ratio");
    GradsSpec without;
    without.variables = {"th {} 99 potential temperature (K)", "qv {} 99 vapour (kg/kg)",
                         "qc {} 99 qc (kg/kg)"};
    const DatasetInfo standard = infoOf(without);
    CHECK(standard.find(VariableRole::waterVapour) == nullptr);
    CHECK(hasNote(standard, "qv gives no humidity"));
}

TEST_CASE("The grid of a CM1 run moves by its namelist where no metadata say how far it is") {
    // 540 and 720 s at 12.5 and 3 m/s.
    const DatasetInfo info = infoOf({}, " imove = 1,\n umove = 12.5,\n vmove = 3.0,\n");
    CHECK(info.moves());
    CHECK(info.times[0].gridOffsetM == glm::dvec2(6750.0, 1620.0));
    CHECK(info.times[1].gridOffsetM == glm::dvec2(9000.0, 2160.0));
    CHECK_FALSE(infoOf({}, " imove = 0,\n umove = 12.5,\n vmove = 3.0,\n").moves());
    CHECK_FALSE(infoOf({}).moves());
}

TEST_CASE("The grid of a CM1 run lies where its metadata have it, whatever the namelist says") {
    GradsSpec spec;
    spec.locations = {1000.0f, -250.0f, 1800.0f, -300.0f};
    const DatasetInfo info = infoOf(spec, " imove = 1,\n umove = 12.5,\n vmove = 3.0,\n");
    CHECK(info.times[0].seconds == 0.0);
    CHECK(info.times[0].gridOffsetM == glm::dvec2(1000.0, -250.0));
    CHECK(info.times[1].gridOffsetM == glm::dvec2(1800.0, -300.0));
}
