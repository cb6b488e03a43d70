// statistics_test.cpp: bases of cloud that a wisp of fog does not move, and species that a time
// lacks.
#include "core/volume/statistics.h"

#include <doctest/doctest.h>

#include "core/volume/held_volume.h"
#include "core/volume/resample.h"
#include "tests/core/memory_dataset.h"
#include "tests/text.h"

using namespace neph;

namespace {

constexpr glm::ivec3 kSkySize{10, 10, 20};

/// Layers of 100 m. Cloud from 1 km in the western half, an anvil from 1.5 km in the eastern half,
/// one cell of fog, and a tower of rain with its own base of 0.8 km where `tower` is.
MemoryDataset sky(glm::ivec2 tower) {
    MemoryDataset dataset(kSkySize, [](int, int, int z) { return 100.0f * static_cast<float>(z); });
    const auto inTower = [=](int x, int y) { return x == tower.x && y == tower.y; };
    dataset.addRatio(Species::cloud, [=](int x, int y, int z) {
        if (x == 0 && y == 0 && z == 0) return 2e-5f;
        const int base = inTower(x, y) ? 8 : x < 5 ? 10 : 15;
        return z >= base && z < 18 ? 1e-3f : 0.0f;
    });
    dataset.addRatio(Species::rain,
                     [=](int x, int y, int) { return inTower(x, y) ? 3e-3f : 0.0f; });
    return dataset;
}

}  // namespace

TEST_CASE("One cell of fog makes the lowest base the ground, and moves no other") {
    MemoryDataset dataset = sky({7, 7});
    const TimeSummary summary = summarise(dataset, 0);
    REQUIRE(summary.cloud);
    REQUIRE(summary.bases);
    CHECK(summary.cloud->baseM == 0.0);
    // 100 columns: fog, tower, 49 of 1 km, 49 of 1.5 km.
    CHECK(summary.bases->lowM == 1000.0);
    CHECK(summary.bases->middleM == 1000.0);
    CHECK(summary.bases->updraftM == 800.0);  // most condensate
    CHECK(summary.bases->updraftVariable.empty());
}

TEST_CASE("Where the model has the upward wind, the main updraft is where it is strong") {
    for (const int levels : {20, 21}) {
        MemoryDataset dataset = sky({7, 7});
        dataset.add("W", VariableRole::other, {}, {10, 10, levels}, [](int x, int y, int z) {
            if (x == 9 && y == 9 && z == 3) return std::numeric_limits<float>::quiet_NaN();
            return y == 4 && z == 9 ? 4.0f * static_cast<float>(x) : -50.0f;
        });
        const TimeSummary summary = summarise(dataset, 0);
        REQUIRE(summary.bases);
        CHECK(summary.bases->updraftVariable == "W");
        CHECK(summary.bases->updraftM == 1500.0);  // 36 m/s at x 9: from 18 m/s, x 5 and beyond
    }
}

TEST_CASE("A clear sky has no bases") {
    MemoryDataset dataset(kSkySize, [](int, int, int z) { return 100.0f * static_cast<float>(z); });
    dataset.addRatio(Species::cloud, [](int, int, int) { return 0.0f; });
    CHECK(!summarise(dataset, 0).bases);
}

TEST_CASE("A species that one time of a series lacks is drawn at the others, with a note at that") {
    MemoryDataset dataset = sky({7, 7});
    dataset.addTime("2024-05-06_21:10:00", "runs/second.nc", {"Q_rain"});
    const SpeciesVolume first = resample(dataset, 0), second = resample(dataset, 1);
    CHECK(first.has(Species::rain));
    CHECK(first.notes.empty());
    CHECK(!second.has(Species::rain));
    CHECK(second.has(Species::cloud));
    CHECK(second.notes == std::vector<std::string>{"2024-05-06_21:10:00: Q_rain is not in "
                                                   "second.nc: there is no rain at this time."});
    CHECK(first.grid.size == second.grid.size);
    CHECK(planRead(dataset, 0) == planRead(dataset, 1));
    const VolumeSummary shown = readVolume(dataset, 1, {}).summary;
    CHECK(!shown.present[static_cast<std::size_t>(Species::rain)]);
    CHECK(!shown.empty());

    const TimeSummary summary = summarise(dataset, 1);
    REQUIRE(summary.peaks.size() == 2);
    CHECK(summary.peaks[1].species == Species::rain);
    CHECK(summary.peaks[1].variable.empty());
    CHECK(contains(summary.notes.at(0), "Q_rain is not in second.nc"));
}

TEST_CASE("Numbers that one time lacks are replaced by what the scheme says, with a note") {
    MemoryDataset dataset = sky({7, 7});
    dataset.stated().microphysics = Microphysics::thompson;
    dataset.add("N_rain", VariableRole::numberConcentration, Species::rain, kSkySize,
                [](int, int, int) { return 1e4f; });
    dataset.addTime("2024-05-06_21:10:00", "second.nc", {"N_rain"});
    Look look;
    look.of(Species::rain).radiusSource = RadiusSource::number;
    const RadiusPlan radii = planRadii(look, dataset.Dataset::info());
    CHECK(radii.of(Species::rain).source == RadiusSource::number);
    CHECK(resample(dataset, 0, {{}, radii}).notes.empty());
    const SpeciesVolume volume = resample(dataset, 1, {{}, radii});
    CHECK(volume.holding(Species::rain) == Holding::extinction);
    REQUIRE(!volume.notes.empty());
    CHECK(contains(volume.notes[0], "2024-05-06_21:10:00: Rain: the file has no number of"));
}
