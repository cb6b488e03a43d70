// scene_file_test.cpp: valid scenes as users write them, and the errors for invalid ones.
#include "app/validate/scene_file.h"

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <numeric>

#include "app/validate/runner.h"
#include "core/base/error.h"
#include "core/base/resources.h"
#include "tests/temporary_folder.h"
#include "tests/text.h"

using namespace neph;
using namespace neph::validate;
using doctest::Approx;

namespace {

const std::string kLayer =
    R"("layers": [{"thickness_m": 500, "optical_depth": 4, "albedo": 0.9, "g": 0.85}])";
const std::string kExperiment =
    R"({"sun": {"zenith_deg": 60}, "detectors": {"fluxes": ["R"]}, "expect": []})";

/// The text of a case with this medium and this experiment.
std::string caseOf(const std::string& medium, const std::string& experiment = kExperiment) {
    return R"({"type": "nephoscope-validation-case", "version": 1, "name": "mine", )" + medium +
           R"(, "experiments": [)" + experiment + "]}";
}

SceneFile parse(const std::string& text, const std::filesystem::path& folder = {}) {
    return parseSceneFile(text, "mine.json", folder);
}

std::string errorMessageOf(const std::string& text, const std::filesystem::path& folder = {}) {
    try {
        trialsOf(parse(text, folder), "mine.json");
    } catch (const Error& error) {
        return error.message();
    }
    return "nothing";
}

/// Vertical optical depth of column x.
double opticalDepth(const SceneFile& file, int x) {
    const render::MeterScene& scene = file.experiments.front().scene;
    double sum = 0.0;
    for (const render::MeterField& field : file.fields) {
        for (int z = 0; z < scene.size.z; ++z) {
            sum += static_cast<double>(field.extinctionPerM.at(x, 0, z)) * scene.spacingM.z;
        }
    }
    return sum;
}

}  // namespace

TEST_CASE("A radiance may be of a part, and droplets of one wavelength") {
    const std::string phase =
        R"("layers": [{"thickness_m": 500, "optical_depth": 4,
            "phase": {"kind": "water_droplets", "wavelength_nm": 800}}])";
    const auto experiment = [](const std::string& area) {
        return R"({"sun": {"zenith_deg": 60}, "detectors": {"radiances": [{"name": "up",
            "zenith_deg": 0)" +
               area + R"(}]}, "expect": []})";
    };
    const std::string part = R"(, "x_m": [10, 20], "y_m": [0, 50])";
    const SceneFile file = parse(caseOf(phase, experiment(part)));
    CHECK(file.fields.front().phase.wavelengthM == Approx(800e-9));
    const Trial trial = trialsOf(file, "mine.json").front();
    CHECK(trial.detectors.front().box.lowerM == glm::dvec3(10.0, 0.0, 500.0));
    CHECK(trial.detectors.front().box.upperM == glm::dvec3(20.0, 50.0, 500.0));
    CHECK(contains(errorMessageOf(caseOf(phase, experiment(R"(, "x_m": [20, 10], "y_m": [0, 1])"))),
                   "has no area"));
    CHECK(contains(errorMessageOf(caseOf(phase, experiment(R"(, "x_m": [20, 30])"))), "y_m"));
    const std::string isotropic =
        R"("layers": [{"thickness_m": 500, "optical_depth": 4,
            "phase": {"kind": "isotropic", "wavelength_nm": 800}}])";
    CHECK(contains(errorMessageOf(caseOf(isotropic, experiment(""))), "wavelength_nm"));
}

TEST_CASE("Layers are stacked, on a grid of at least 16 levels that contains their edges") {
    const SceneFile file = parse(caseOf(
        R"("layers": [{"thickness_m": 300, "optical_depth": 3, "g": 0.85},
                      {"top_m": 800, "extinction_per_m": 0.002, "albedo": 0.5, "phase": "rayleigh"},
                      {"base_m": 0, "top_m": 800, "optical_depth": 0.8, "g": 0.85}])"));
    const render::MeterScene& scene = file.experiments.front().scene;
    CHECK(scene.size == glm::ivec3(1, 1, 16));
    CHECK(scene.spacingM.z == 50.0);
    REQUIRE(file.fields.size() == 2);  // the first and the last layer have the same medium
    CHECK(file.fields[0].extinctionPerM.at(0, 0, 5) == Approx(0.011));
    CHECK(file.fields[0].extinctionPerM.at(0, 0, 6) == Approx(0.001));
    CHECK(file.fields[1].extinctionPerM.at(0, 0, 5) == 0.0f);
    CHECK(file.fields[1].albedo == 0.5);
    CHECK(file.fields[1].phase.kind == PhaseKind::rayleigh);
    CHECK(opticalDepth(file, 0) == Approx(3.0 + 1.0 + 0.8));
}

TEST_CASE("The bundled step cloud is that of I3RC: 32 columns of 15.625 m, depths 2 and 18") {
    const SceneFile file =
        loadSceneFile(resourcePath("tests/validation/i3rc-case1-step-cloud.json"));
    const render::MeterScene& scene = file.experiments.front().scene;
    CHECK(scene.size == glm::ivec3(32, 1, 16));
    CHECK(scene.spacingM.x == 15.625);
    CHECK(scene.spacingM.z == 15.625);
    CHECK(scene.periodic);
    CHECK(!scene.surfaceAlbedo.has_value());
    CHECK(opticalDepth(file, 15) == Approx(2.0));
    CHECK(opticalDepth(file, 16) == Approx(18.0));
    CHECK(file.experiments[1].expected.front().expected.value == 0.58044);
}

TEST_CASE("The azimuth of the sun is the direction in which its light travels") {
    const SceneFile file = parse(caseOf(
        kLayer, R"({"sun": {"zenith_deg": 60, "azimuth_deg": 90}, "detectors": {"fluxes": []}})"));
    const glm::dvec3 towardsSun = file.experiments.front().scene.towardsSun;
    CHECK(towardsSun.x == Approx(0.0));
    CHECK(towardsSun.y == Approx(-std::sqrt(0.75)));
    CHECK(towardsSun.z == Approx(0.5));
}

TEST_CASE("Grids are read inline, from CSV and from raw files, with a scale") {
    const TemporaryFolder folder;
    std::ofstream(folder / "a.csv") << "# per km\n1, 2, 3\n4 5,6 # the top\n";
    const std::vector<float> raw{6.0f, 5.0f, 4.0f, 3.0f, 2.0f, 1.0f};
    std::ofstream(folder / "b.raw", std::ios::binary)
        .write(reinterpret_cast<const char*>(raw.data()), 24);
    const SceneFile file =
        parse(caseOf(R"("grid": {"size": [3, 1, 2], "spacing_m": [10, 20, 30], "trilinear": true,
                  "fields": [{"csv": "a.csv", "scale": 0.001, "g": 0},
                             {"raw": "b.raw", "phase": {"kind": "water_droplets", "radius_um": 8}},
                             {"values": [0, 0, 0, 0, 0, 7], "phase": "isotropic"}]},
                  "sides": "open")"),
              folder.path());
    REQUIRE(file.fields.size() == 3);
    CHECK(file.fields[0].extinctionPerM.at(2, 0, 1) == Approx(0.006));
    CHECK(file.fields[1].extinctionPerM.at(1, 0, 0) == 5.0f);
    CHECK(file.fields[1].phase.radiusM == Approx(8e-6));
    CHECK(file.fields[2].extinctionPerM.at(2, 0, 1) == 7.0f);
    CHECK(file.experiments.front().scene.trilinear);
    CHECK(!file.experiments.front().scene.periodic);
}

TEST_CASE("With per_column each column has detectors of its own") {
    const std::vector<Trial> trials = trialsOf(
        parse(caseOf(
            R"("columns": [{"width_m": 50, "repeat": 3, "top_m": 100, "optical_depth": 1, "g": 0}])",
            R"({"sun": {"zenith_deg": 60, "irradiance": 2}, "detectors": {"fluxes": ["R"],
               "per_column": true, "radiances": [{"name": "I", "zenith_deg": 60}]},
               "expect": [{"quantity": "R[2]", "value": 0.3, "relative": 0.01}]})")),
        "mine.json");
    REQUIRE(trials.size() == 1);
    REQUIRE(trials[0].quantities.size() == 8);
    const Quantity& last = trials[0].quantities[6];
    CHECK(last.name == "R[2]");
    REQUIRE(last.expected.has_value());
    CHECK(last.expected->tolerance == Approx(0.003));
    CHECK(last.terms.front().factor == Approx(1.0));  // of mu0 F0 = 0.5 times 2
    const render::Detector& plane = trials[0].detectors[last.terms.front().detector];
    CHECK(plane.box.lowerM == glm::dvec3(100.0, 0.0, 100.0));
    CHECK(plane.box.upperM.x == 150.0);
    const render::Detector& view = trials[0].detectors[1];
    CHECK(view.direction.x == Approx(-std::sqrt(0.75)));  // looks back along the light
    CHECK(view.direction.z == Approx(-0.5));
}

TEST_CASE("Errors in a scene name file, key, found, expected and the nearest known name") {
    const auto with = [](const std::string& experiment) { return caseOf(kLayer, experiment); };
    const std::pair<std::string, std::string> cases[]{
        {caseOf(R"("layers": [{"thicknes_m": 5}])"), "did you mean \"thickness_m\"?"},
        {caseOf(R"("layers": [{"thickness_m": 5, "optical_depth": 1, "albedo": 1.5, "g": 0}])"),
         "mine.json: layers[0]: \"albedo\" cannot take this value"},
        {caseOf(R"("layers": [{"thickness_m": 5, "optical_depth": 1, "phase": "rayleih"}])"),
         "did you mean \"rayleigh\"?"},
        {caseOf(R"("layers": [{"thickness_m": 5, "optical_depth": 1}])"), "\"phase\" is missing"},
        {caseOf(R"("layers": [{"thickness_m": 1e-6, "optical_depth": 1, "g": 0},
                              {"thickness_m": 9e5, "optical_depth": 1, "g": 0}])"),
         "heights have no common step"},
        {caseOf(R"("layers": [])"), "no extent"},
        {caseOf(R"("sides": "open")"), "needs one of \"layers\", \"columns\" and \"grid\""},
        {with(R"({"detectors": {"fluxes": ["R"]}})"), "has no light"},
        {with(R"({"sun": {"zenith_deg": 95}, "detectors": {}})"), "a number from 0 to 89.9"},
        {with(R"({"sun": {"zenith_deg": 9}, "detectors": {"fluxes": ["R", "X"]}})"),
         "one of R, T, T_direct, T_diffuse, A, balance"},
        {with(R"({"sun": {"zenith_deg": 9}, "detectors": {"fluxes": ["T_direct"]},
                 "expect": [{"quantity": "T_diret", "value": 1, "relative": 0.1}]})"),
         "did you mean \"T_direct\"?"},
        {with(R"({"sun": {"zenith_deg": 9}, "detectors": {"fluxes": ["R"]},
                 "expect": [{"quantity": "R", "value": 1}]})"),
         "needs one of \"relative\" and \"absolute\""},
        {caseOf(R"("grid": {"size": [2, 1, 1], "spacing_m": [1, 1, 1],
                   "fields": [{"values": [1], "g": 0}]})"),
         "contains the wrong number of values"},
        {caseOf(R"("grid": {"size": [2, 1, 1], "spacing_m": [1, 1, 1],
                   "fields": [{"values": [1, -2], "g": 0}]})"),
         "value 1 is not an extinction"},
        {caseOf(R"("grid": {"size": [2, 1, 1], "spacing_m": [1, 1, 1],
                   "fields": [{"raw": "no.raw", "g": 0}]})"),
         "no.raw"},
    };
    for (const auto& [text, wanted] : cases) {
        const std::string message = errorMessageOf(text), part = wanted;
        CAPTURE(message);
        CAPTURE(part);
        CHECK(contains(message, part.c_str()));
        CHECK(contains(message, part.find("no.raw") == part.npos ? "mine.json" : "no.raw"));
    }
}

TEST_CASE("Every bundled case can be read and has expected values for each experiment") {
    int files = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(resourcePath("tests/validation"))) {
        CAPTURE(entry.path());
        const SceneFile file = loadSceneFile(entry.path());
        CHECK(!file.source.empty());
        for (const Experiment& experiment : file.experiments) CHECK(!experiment.expected.empty());
        CHECK(!trialsOf(file, entry.path().string()).empty());
        ++files;
    }
    CHECK(files == 13);
}

TEST_CASE("A bias that no single measurement shows is detected in all of them together") {
    std::vector<Row> rows(40);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].expected = 0.5;
        rows[i].tolerance = 0.0015;
        rows[i].sigma = 0.0015;
        rows[i].measured = 0.5 * 1.005 + (i % 2 == 0 ? 0.001 : -0.001);
        CHECK(verdict(rows[i]) == Verdict::pass);
    }
    const auto all = allTogether(rows, kFullEffort);
    REQUIRE(all.has_value());
    CHECK(all->measured == Approx(0.005));
    CHECK(all->sigma == Approx(0.003 / std::sqrt(40.0)));
    CHECK(verdict(*all) == Verdict::fail);
    rows.resize(9);
    CHECK(!allTogether(rows, kFullEffort).has_value());
}

TEST_CASE("A measurement passes within tolerance plus three sigma, and only if it is precise") {
    Row row;
    row.measured = 1.0;
    row.sigma = 0.01;
    row.tolerance = 0.02;
    CHECK(verdict(row) == Verdict::none);
    row.expected = 1.049;
    CHECK(verdict(row) == Verdict::pass);
    row.expected = 1.051;
    CHECK(verdict(row) == Verdict::fail);
    row.expected = 1.0;
    row.sigma = 0.021;
    CHECK(verdict(row) == Verdict::noisy);
    row.measured = std::nan("");
    CHECK(verdict(row) == Verdict::fail);
}
