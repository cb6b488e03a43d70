// raw_les_data_test.cpp: real output of CM1 and MicroHH: the bundled cumulus and, if
// NEPHOSCOPE_MODEL_DATA names their folder, complete runs.
//
// Maxima and column sums were computed from the files with NumPy, in double precision.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "core/plugin/reader_file.h"
#include "tests/readers/reader_host.h"

using namespace neph;

namespace {

namespace fs = std::filesystem;

const fs::path kCumulus = fs::path(NEPH_TEST_SOURCE_DIR) / "samples/cumulus";
const char* const kModelData = std::getenv("NEPHOSCOPE_MODEL_DATA");

double most(const Array3f& values) {
    return static_cast<double>(*std::ranges::max_element(values.values));
}

struct Columns {
    double most = 0.0;     ///< kg/m²
    double totalKg = 0.0;  ///< of the domain
};

/// Integrals of a content over every column.
Columns columnsOf(Dataset& dataset, const char* name, int time) {
    const Array3f q = dataset.read(name, time);
    const Array3f z = dataset.read("interface_height", time);
    const Array3f rho = dataset.read(dataset.info().find(VariableRole::dryAirDensity)->name, time);
    const std::size_t layer = q.index(0, 0, 1);
    Columns columns;
    for (std::size_t column = 0; column < layer; ++column) {
        double sum = 0.0;
        for (std::size_t k = 0; k + 1 < z.values.size(); ++k) {
            const float density = rho.values[rho.size.x == 1 ? k : k * layer + column];
            sum += static_cast<double>(q.values[k * layer + column]) *
                   static_cast<double>(density) *
                   (static_cast<double>(z.values[k + 1]) - static_cast<double>(z.values[k]));
        }
        columns.most = std::max(columns.most, sum);
        columns.totalKg += sum * dataset.info().spacingM.x * dataset.info().spacingM.y;
    }
    return columns;
}

std::shared_ptr<Dataset> openRun(const char* path) {
    return openFiles({fs::path(kModelData) / path});
}

}  // namespace

TEST_CASE("The bundled cumulus is three times of a growing cloud in less than 4 MB") {
    std::uintmax_t bytes = 0;
    for (const auto& entry : fs::directory_iterator(kCumulus)) bytes += entry.file_size();
    CHECK(bytes <= 4'000'000);
    const auto dataset = openFiles({kCumulus / "cumulus.json"});
    const DatasetInfo& info = dataset->info();
    CHECK(info.reader == "raw_les");
    CHECK(info.microphysics == Microphysics::morrison);
    REQUIRE(info.times.size() == 3);
    CHECK(info.times[2].seconds == 360.0);
    CHECK(info.notes.empty());
    // Maxima of the original run; the sample stores cloud water in steps of 1e-7.
    CHECK(most(dataset->read("qc", 0)) == doctest::Approx(0.005153656).epsilon(2e-5));
    CHECK(most(dataset->read("qc", 2)) == doctest::Approx(0.004405737).epsilon(2e-5));
    CHECK(most(dataset->read("qg", 2)) == doctest::Approx(0.0032805).epsilon(4e-3));
    const Columns middle = columnsOf(*dataset, "qc", 1);
    // The sample has a profile of air, within 1.2 % of the run's air; the differences cancel over
    // the domain.
    CHECK(middle.most == doctest::Approx(10.0799).epsilon(0.012));
    CHECK(middle.totalKg == doctest::Approx(19512846.0).epsilon(5e-3));
}

TEST_CASE("CM1, one file per time: maxima and column sums are those of NumPy" *
          doctest::skip(kModelData == nullptr)) {
    const auto dataset = openRun("cm1-cumulus/cm1out_s.ctl");
    const DatasetInfo& info = dataset->info();
    CHECK(info.size == glm::ivec3(96, 90, 98));
    CHECK(info.scheme == "Morrison (ptype 5)");
    CHECK(info.cloudDropletsPerM3 == 2.5e8);
    CHECK(info.times[0].label == "540 s");
    CHECK(info.times[2].seconds == 360.0);
    const std::array<double, 3> mostCloud{0.005153656005859375, 0.005216360092163086,
                                          0.0044057369232177734};
    const std::array<Columns, 3> columns{{{7.619611369219556, 13820885.355401753},
                                          {10.07986188005083, 19512846.09992804},
                                          {6.883806788612651, 9615328.884696044}}};
    for (int t = 0; t < 3; ++t) {
        const auto i = static_cast<std::size_t>(t);
        CHECK(most(dataset->read("qc", t)) == doctest::Approx(mostCloud[i]).epsilon(1e-9));
        const Columns found = columnsOf(*dataset, "qc", t);
        CHECK(found.most == doctest::Approx(columns[i].most).epsilon(1e-6));
        CHECK(found.totalKg == doctest::Approx(columns[i].totalKg).epsilon(1e-6));
    }
    CHECK(dataset->read("dry_air_density", 0).values[0] ==
          doctest::Approx(1.1934025072272976).epsilon(1e-6));
}

TEST_CASE("CM1, all times in one file: heights, stored density and contents are those of NumPy" *
          doctest::skip(kModelData == nullptr)) {
    const auto dataset = openRun("cm1-cumulus-onefile/cm1out_s.ctl");
    REQUIRE(dataset->info().times.size() == 7);
    CHECK(dataset->info().times[4].seconds == 1200.0);
    CHECK(dataset->info().find(VariableRole::dryAirDensity)->name == "rho");
    const Array3f z = dataset->read("interface_height", 0);
    CHECK(z.values[10] == doctest::Approx(756.579).epsilon(1e-5));  // stretched above 675 m
    CHECK(z.values[44] == doctest::Approx(6550.0).epsilon(1e-6));   // ztop of the namelist
    CHECK(most(dataset->read("qc", 0)) == 0.0);
    CHECK(most(dataset->read("qc", 2)) == doctest::Approx(0.0052198669873178005).epsilon(1e-9));
    CHECK(most(dataset->read("winterp", 2)) == doctest::Approx(20.057758331298828).epsilon(1e-9));
    const Columns found = columnsOf(*dataset, "qc", 4);
    CHECK(found.most == doctest::Approx(2.4835903678835853).epsilon(1e-6));
    CHECK(found.totalKg == doctest::Approx(2745196.820748173).epsilon(1e-6));
}

TEST_CASE("MicroHH: maxima and column sums are those of NumPy" *
          doctest::skip(kModelData == nullptr)) {
    const auto dataset = openRun("microhh-rico/rico.ini");
    CHECK(dataset->info().size == glm::ivec3(96, 80, 100));
    CHECK(dataset->info().times[2].label == "21600 s");
    CHECK(most(dataset->read("ql", 1)) == doctest::Approx(0.0021038511767983437).epsilon(1e-9));
    const Columns found = columnsOf(*dataset, "ql", 1);
    CHECK(found.most == doctest::Approx(0.7234896018319414).epsilon(1e-6));
    CHECK(found.totalKg == doctest::Approx(279017.4157117398).epsilon(1e-6));
    CHECK(dataset->read("pref", 0).values[0] == doctest::Approx(101310.53).epsilon(1e-7));
}

TEST_CASE("CM1, stretched in x and y: widths and masses are those of NumPy" *
          doctest::skip(kModelData == nullptr)) {
    const fs::path ctl = fs::path(kModelData) / "cm1-stretched/cm1out_s.ctl";
    ReaderFile file(readerHost().pick(ctl), ctl);
    const DatasetInfo& info = file.description();
    REQUIRE(info.size == glm::ivec3(40, 40, 34));
    CHECK(info.spacingM.x == doctest::Approx(1000.0).epsilon(1e-5));
    for (const auto& edges : info.edgesM) {
        REQUIRE(edges.size() == 41);
        CHECK(edges[0] == 0.0);
        CHECK(edges[1] == doctest::Approx(5000.0).epsilon(1e-4));
        CHECK(edges[2] - edges[1] == doctest::Approx(4428.57).epsilon(1e-4));
        CHECK(edges[21] - edges[20] == doctest::Approx(1000.0).epsilon(1e-4));
        CHECK(edges[40] == doctest::Approx(72000.0).epsilon(1e-6));
    }
    const CellBox whole{{0, 0, 0}, info.size};
    const auto read = [&](const char* name) {
        const auto index = static_cast<std::size_t>(info.find(name) - info.variables.data());
        return file.read(index, 2, whole, {});
    };
    const std::vector<float> rho = read("rho");
    for (const auto& [name, massKg] :
         {std::pair{"qc", 1.38437e9}, std::pair{"qr", 1.72129e9}, std::pair{"qg", 9.11917e9}}) {
        const std::vector<float> q = read(name);
        double sum = 0.0;
        for (std::size_t i = 0; i < q.size(); ++i) {
            const std::size_t x = i % 40;
            const std::size_t y = i / 40 % 40;
            sum += static_cast<double>(q[i]) * static_cast<double>(rho[i]) * 500.0 *
                   (info.edgesM[0][x + 1] - info.edgesM[0][x]) *
                   (info.edgesM[1][y + 1] - info.edgesM[1][y]);
        }
        CHECK(sum == doctest::Approx(massKg).epsilon(1e-5));
    }
}
