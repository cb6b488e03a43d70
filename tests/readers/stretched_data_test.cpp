// stretched_data_test.cpp: a CM1 storm on a grid that is stretched in x and y, if
// NEPHOSCOPE_MODEL_DATA names the folder that has it.
//
// Masses of the domain are sums by numpy of q times the file's density times the volume of cells.
#include <doctest/doctest.h>

#include <cstdlib>
#include <map>
#include <string>

#include "core/volume/resample.h"
#include "tests/readers/reader_host.h"

using namespace neph;

namespace {

const char* const kStretchedData = std::getenv("NEPHOSCOPE_MODEL_DATA");

}  // namespace

TEST_CASE("Each mass of the stretched CM1 storm is that of its file" *
          doctest::skip(kStretchedData == nullptr)) {
    const auto dataset = openFiles({std::filesystem::path(kStretchedData) / "cm1-stretched"});
    REQUIRE(dataset->info().times.size() == 3);
    // umove and vmove are 12.5 and 3 m/s.
    CHECK(dataset->info().times[1].gridOffsetM == glm::dvec2(22500.0, 5400.0));
    CHECK(dataset->info().times[2].gridOffsetM == glm::dvec2(45000.0, 10800.0));
    const std::map<std::string, double> massesKg{{"qc", 1.38437e9},
                                                 {"qr", 1.72129e9},
                                                 {"qi", 9.99657e8},
                                                 {"qs", 1.26787e9},
                                                 {"qg", 9.11917e9}};
    for (const int coarsening : {1, 2, 5}) {
        CAPTURE(coarsening);
        const std::uint64_t columns = (72U + coarsening - 1U) / coarsening;
        const std::uint64_t full = planRead(*dataset, 2).machineBytes;
        const ReadPlan plan =
            planRead(*dataset, 2, {}, {.machine = full / (72U * 72U) * columns * columns});
        REQUIRE(plan.coarsening == coarsening);
        const SpeciesVolume volume = resample(*dataset, 2, {plan});
        CHECK(volume.grid.extentM().x >= 72'000.0);
        for (const auto& each : massesKg) {
            const auto& name = each.first;
            CAPTURE(name);
            double sum = 0.0;
            const Species species = *dataset->info().find(name)->species;
            for (const float value : volume.content(species).values) {
                sum += static_cast<double>(value);
            }
            const glm::dvec3 cell = volume.grid.spacingM;
            // The masses are given to six digits.
            CHECK(sum * cell.x * cell.y * cell.z == doctest::Approx(each.second).epsilon(5e-6));
        }
    }
}
