// supercell_test.cpp: real model output: the bundled storm and, if NEPHOSCOPE_WHOLE_RUN names its
// folder, the complete run that it is a part of.
//
// Maxima were computed from the files with NCO (ncwa -y max); the positions of the storms are from
// the description of the run.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/volume/lowest_air.h"
#include "core/volume/resample.h"
#include "core/volume/statistics.h"
#include "tests/readers/reader_host.h"

using namespace neph;

namespace {

namespace fs = std::filesystem;

const fs::path kSamples = fs::path(NEPH_TEST_SOURCE_DIR) / "samples/supercell";
const char* const kWholeRun = std::getenv("NEPHOSCOPE_WHOLE_RUN");

std::vector<fs::path> filesIn(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
    return files;
}

/// Largest relative difference between the native and the resampled mass of a column.
double worstColumn(Dataset& dataset, const SpeciesVolume& volume, Species species, int time) {
    const Array3f z = dataset.read("interface_height", time);
    const Array3f rho = dataset.read("dry_air_density", time);
    const Array3f q =
        dataset.read(dataset.info().find(VariableRole::mixingRatio, species)->name, time);
    const std::size_t layer = q.index(0, 0, 1);
    double worst = 0.0;
    for (std::size_t column = 0; column < layer; ++column) {
        double native = 0.0;
        double target = 0.0;
        for (std::size_t i = column; i < q.values.size(); i += layer) {
            native += static_cast<double>(std::max(q.values[i], 0.0f)) *
                      static_cast<double>(rho.values[i]) *
                      (static_cast<double>(z.values[i + layer]) - static_cast<double>(z.values[i]));
        }
        const auto& content = volume.content(species).values;
        for (std::size_t i = column; i < content.size(); i += layer) {
            target += static_cast<double>(content[i]) * volume.grid.spacingM.z;
        }
        if (native > 0.0) worst = std::max(worst, std::abs(target - native) / native);
    }
    return worst;
}

/// Mass of a species in a part of the domain above a height, kg.
double massWithin(const SpeciesVolume& volume, Species species, glm::dvec2 lowerKm,
                  glm::dvec2 upperKm, double aboveM) {
    const RegularGrid& grid = volume.grid;
    double mass = 0.0;
    for (int k = 0; k < grid.size.z; ++k) {
        for (int j = 0; j < grid.size.y; ++j) {
            for (int i = 0; i < grid.size.x; ++i) {
                const glm::dvec3 km = grid.centreM({i, j, k}) * 1e-3;
                if (km.z * 1e3 < aboveM || km.x < lowerKm.x || km.x >= upperKm.x ||
                    km.y < lowerKm.y || km.y >= upperKm.y) {
                    continue;
                }
                mass += static_cast<double>(volume.content(species).at(i, j, k));
            }
        }
    }
    return mass * grid.spacingM.x * grid.spacingM.y * grid.spacingM.z;
}

}  // namespace

TEST_CASE("The humidity of the bundled storm's lowest air is that computed apart") {
    // The mean of e / e_s over level 0, from an ncdump of P, PB, T and QVAPOR.
    const auto dataset = openFiles({kSamples});
    const LowestAir early = readLowestAir(*dataset, 0), middle = readLowestAir(*dataset, 1);
    CHECK(early.humidity.value_or(0.0) == doctest::Approx(0.654963).epsilon(1e-5));
    CHECK(middle.humidity.value_or(0.0) == doctest::Approx(0.663426).epsilon(1e-5));
}

TEST_CASE("The bundled storm is one series of four times, each file below 4 MiB") {
    const std::vector<fs::path> files = filesIn(kSamples);
    for (const fs::path& file : files) CHECK(fs::file_size(file) <= 4'194'304);
    const DatasetInfo info = openFiles(files)->info();
    CHECK(info.model == "WRF V4.2.2");
    CHECK(info.scheme == "Thompson (MP_PHYSICS 8)");
    CHECK(info.size == glm::ivec3(110, 120, 60));
    CHECK(info.spacingM == glm::dvec2(1000.0));
    REQUIRE(info.times.size() == 4);
    CHECK(info.times[0].label == "0001-01-01_00:30:00");
    CHECK(info.times[3].seconds == 5400.0);
    CHECK(info.notes.empty());
    CHECK(info.find(VariableRole::mixingRatio, Species::hail) == nullptr);
    CHECK(info.find(VariableRole::effectiveRadius, Species::snow) != nullptr);
}

TEST_CASE("Maxima of the bundled storm are those of the files, and are within the storm") {
    const auto dataset = openFiles(filesIn(kSamples));
    const TimeSummary hour = summarise(*dataset, 1);
    REQUIRE(hour.peaks.size() == 5);
    CHECK(hour.peaks[0].ratioKgPerKg == doctest::Approx(0.005126953));
    CHECK(hour.peaks[1].ratioKgPerKg == doctest::Approx(0.002906799));
    CHECK(hour.peaks[2].ratioKgPerKg == doctest::Approx(0.01409912));
    CHECK(hour.peaks[3].ratioKgPerKg == doctest::Approx(0.005317688));
    CHECK(hour.peaks[4].ratioKgPerKg == doctest::Approx(0.01422119));
    CHECK(hour.peaks[4].variable == "QGRAUP");
    CHECK(hour.layers.highestM == doctest::Approx(20'000.0).epsilon(0.02));
    // Most rain is low, most snow is high.
    CHECK(hour.peaks[2].positionM.z < 5000.0);
    CHECK(hour.peaks[3].positionM.z > 9000.0);
}

TEST_CASE("Resampling conserves the column mass of every species of the bundled storm") {
    const auto dataset = openFiles(filesIn(kSamples));
    for (const int time : {0, 3}) {
        const SpeciesVolume volume = resample(*dataset, time);
        CHECK(volume.grid.size.z <= 256);
        CHECK(volume.grid.spacingM.z <= 340.0);
        for (int s = 0; s < 5; ++s) {
            CHECK(worstColumn(*dataset, volume, static_cast<Species>(s), time) < 1e-6);
        }
    }
}

TEST_CASE("After two hours the bundled storm has split, and has an anvil to the east") {
    const auto dataset = openFiles(filesIn(kSamples));
    const SpeciesVolume volume = resample(*dataset, 3);
    const auto band = [&](double fromKm, double toKm) {
        return massWithin(volume, Species::graupel, {0.0, fromKm}, {110.0, toKm}, 0.0);
    };
    const double between = band(50.0, 60.0);
    CHECK(band(30.0, 40.0) > 3.0 * between);
    CHECK(band(85.0, 95.0) > 3.0 * between);
    const double anvil = massWithin(volume, Species::snow, {75.0, 0.0}, {110.0, 120.0}, 8000.0);
    CHECK(anvil > 0.05 * massWithin(volume, Species::snow, {0.0, 0.0}, {110.0, 120.0}, 0.0));
}

TEST_CASE("The complete run has thirteen times, the first of them without a cloud" *
          doctest::skip(kWholeRun == nullptr)) {
    const auto dataset = openFiles(filesIn(kWholeRun));
    REQUIRE(dataset->info().times.size() == 13);
    CHECK(dataset->info().times[12].seconds == 7200.0);
    const SpeciesVolume empty = resample(*dataset, 0);
    REQUIRE(empty.notes.size() == 1);
    CHECK(contains(empty.notes[0], "no condensate"));
    const SpeciesVolume last = resample(*dataset, 12);
    for (int s = 0; s < 5; ++s) {
        CHECK(worstColumn(*dataset, last, static_cast<Species>(s), 12) < 1e-6);
    }
}
