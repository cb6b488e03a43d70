// ensemble_test.cpp: members on one grid, their mean, and maps over members.
#include "core/dataset/ensemble.h"

#include <doctest/doctest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/volume/column_depth.h"
#include "core/volume/ensemble_maps.h"
#include "core/volume/optical_depth.h"
#include "core/volume/run_volume.h"
#include "tests/core/memory_dataset.h"

using namespace neph;

namespace {

constexpr glm::ivec3 kSize{4, 3, 5};

float evenHeights(int, int, int z) {
    return 200.0f * static_cast<float>(z);
}

/// One cloud of this mixing ratio in the second layer of the columns with x below `width`.
std::shared_ptr<MemoryDataset> runOf(
    float ratio, int width, const std::function<float(int, int, int)>& height = evenHeights) {
    auto run = std::make_shared<MemoryDataset>(kSize, height);
    run->addRatio(Species::cloud,
                  [=](int x, int, int z) { return z == 1 && x < width ? ratio : 0.0f; });
    return run;
}

using Runs = std::vector<std::shared_ptr<MemoryDataset>>;

std::shared_ptr<Ensemble> ensembleFrom(const Runs& runs) {
    MemberList list;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const std::string name = "mem0" + std::to_string(i + 1);
        list.members.push_back({name, {name}});
    }
    return Ensemble::open(list,
                          [&runs](std::span<const std::filesystem::path> paths,
                                  const Progress&) -> std::shared_ptr<Dataset> {
                              const std::string name = paths.front().string();
                              return runs.at(static_cast<std::size_t>(name.back() - '1'));
                          });
}

VolumeRequest requestOf(int member) {
    VolumeRequest request;
    request.member = member;
    return request;
}

}  // namespace

TEST_CASE("the mean of an ensemble holds the mean content of its members in every cell") {
    const auto ensemble = ensembleFrom({runOf(1e-3f, 2), runOf(3e-3f, 4), runOf(0.0f, 0)});
    const SpeciesVolume first = readMember(*ensemble, 0, 0, {}).volume;
    const SpeciesVolume second = readMember(*ensemble, 1, 0, {}).volume;
    const HeldVolume mean = readVolume(*ensemble, 0, requestOf(kMeanMember));
    const Array3f& field = mean.volume->content(Species::cloud);
    REQUIRE(mean.volume->grid == first.grid);
    double most = 0.0;
    for (std::size_t i = 0; i < field.values.size(); ++i) {
        const double expected = (double(first.content(Species::cloud).values[i]) +
                                 double(second.content(Species::cloud).values[i])) /
                                3.0;
        CHECK(double(field.values[i]) == doctest::Approx(expected).epsilon(1e-6));
        most = std::max(most, expected);
    }
    CHECK(most > 1e-4);
    REQUIRE(!mean.volume->notes.empty());
    CHECK(mean.volume->notes.front().find("mean of 3 members is smoother") != std::string::npos);
}

TEST_CASE("members whose levels differ are read on one grid that holds the mass of each") {
    const auto higher = [](int, int, int z) { return 30.0f + 205.0f * static_cast<float>(z); };
    const Runs runs{runOf(1e-3f, 4), runOf(1e-3f, 4, higher)};
    const auto ensemble = ensembleFrom(runs);
    for (int member = 0; member < 2; ++member) {
        const HeldVolume shared = readVolume(*ensemble, 0, requestOf(member));
        const HeldVolume alone = readVolume(*runs[static_cast<std::size_t>(member)], 0, {});
        CHECK(shared.volume->grid.originM.z <= 0.0);
        CHECK(shared.volume->grid.upperM().z >= 30.0 + 5 * 205.0);
        const auto mass = [](const SpeciesVolume& volume) {
            double sum = 0.0;
            for (const float value : volume.content(Species::cloud).values) sum += double(value);
            return sum * volume.grid.spacingM.z;
        };
        CHECK(mass(*shared.volume) == doctest::Approx(mass(*alone.volume)).epsilon(1e-4));
    }
    CHECK(readVolume(*ensemble, 0, requestOf(0)).volume->grid ==
          readVolume(*ensemble, 0, requestOf(1)).volume->grid);
}

TEST_CASE("runs of other grids are refused with the member, what was found and expected") {
    Runs runs{runOf(1e-3f, 4), runOf(1e-3f, 4)};
    runs[1]->stated().spacingM = {400.0, 250.0};
    CHECK_THROWS_WITH_AS(ensembleFrom(runs), doctest::Contains("grid of member mem02"), Error);
    CHECK_THROWS_WITH_AS(ensembleFrom(runs), doctest::Contains("400 m"), Error);
    runs[1]->stated().spacingM = runs[0]->stated().spacingM;
    runs[1]->stated().map.projection = "+proj=lcc +lat_1=30 +lat_2=60";
    CHECK_THROWS_WITH_AS(ensembleFrom(runs), doctest::Contains("+proj=lcc"), Error);
}

TEST_CASE("times are matched by label, and a member that lacks one says so") {
    Runs runs{runOf(1e-3f, 4), runOf(2e-3f, 4)};
    runs[1]->addTime("2024-05-06_21:10:00", "second");
    const auto ensemble = ensembleFrom(runs);
    REQUIRE(ensemble->info().times.size() == 2);
    CHECK(ensemble->membersAt(0) == std::vector{0, 1});
    CHECK(ensemble->membersAt(1) == std::vector{1});
    CHECK_FALSE(ensemble->timeIn(0, 1).has_value());
    const auto& notes = ensemble->info().notes;
    CHECK(std::ranges::find(notes, "mem01 lacks 1 of 2 times: 2024-05-06_21:10:00.") !=
          notes.end());
    CHECK_THROWS_WITH_AS(readVolume(*ensemble, 1, requestOf(0)),
                         doctest::Contains("has no time 2024-05-06_21:10:00"), Error);
    // The mean is of those that have it, and says of whom it is not.
    const HeldVolume mean = readVolume(*ensemble, 1, requestOf(kMeanMember));
    CHECK(mean.volume->notes.back().find("without mem01") != std::string::npos);
    const HeldVolume alone = readVolume(*ensemble, 1, requestOf(1));
    CHECK(mean.volume->content(Species::cloud) == alone.volume->content(Species::cloud));
}

TEST_CASE("without a label in common times are matched by the time since the start of each run") {
    Runs runs{runOf(1e-3f, 4), runOf(2e-3f, 4)};
    runs[0]->addTime("2024-05-06_21:10:00", "a");
    runs[1]->stated().times = {{"2020-01-01_00:00:00", 0.0, "b", 0},
                               {"2020-01-01_00:10:00", 600.0, "b", 1}};
    const auto ensemble = ensembleFrom(runs);
    CHECK(ensemble->info().times.size() == 2);
    CHECK(ensemble->timeIn(1, 1) == 1);
    CHECK(ensemble->info().times[1].label == "start + 10 min");
    CHECK(ensemble->info().notes.front().find("since the start of each run") != std::string::npos);
    // Some that share labels and one that does not: which of its times is meant is not known.
    runs.push_back(runOf(0.0f, 0));
    CHECK_THROWS_WITH_AS(ensembleFrom(runs), doctest::Contains("member mem02"), Error);
}

TEST_CASE("members are named, numbered by the ends of their names, or the mean") {
    const auto ensemble = ensembleFrom({runOf(0.0f, 0), runOf(0.0f, 0)});
    CHECK(ensemble->memberNamed("mem02") == 1);
    CHECK(ensemble->memberNamed("2") == 1);
    CHECK(ensemble->memberNamed("mean") == kMeanMember);
    CHECK_THROWS_WITH_AS(ensemble->memberNamed("3"), doctest::Contains("mem01, mem02"), Error);
}

TEST_CASE("a species held as extinction in one member and as mass in another has no mean") {
    SpeciesVolume mass, extinction, without;
    mass.grid.size = extinction.grid.size = without.grid.size = {1, 1, 1};
    mass.contentKgPerM3[2] = Array3f({1, 1, 1}, 1.0f);
    extinction.extinctionPerM[2] = Array3f({1, 1, 1}, 1.0f);
    MeanVolume mean;
    mean.add(mass, "mem01");
    CHECK_THROWS_WITH_AS(mean.add(extinction, "mem02"), doctest::Contains("rain.radius_source"),
                         Error);
    // A species that a member lacks is zero there.
    mean.add(without, "mem03");
    CHECK(mean.take().contentKgPerM3[2].values.front() == 0.5f);
}

TEST_CASE("the depth of a column is that along a vertical ray through its middle") {
    const auto run = runOf(2e-3f, 2);
    const HeldVolume held = readVolume(*run, 0, {});
    const MediumPlan plan = planMedium(Look{}, held.volume->holdings(), held.volume->cellM());
    const std::vector<float> depths = columnDepths(*held.volume, plan);
    REQUIRE(depths.size() == 12);
    const glm::dvec3 eye = held.volume->grid.centreM({1, 1, 0}) - glm::dvec3(0, 0, 1e4);
    const double along = opticalDepthAlong(*held.volume, plan, eye, {0, 0, 1}).total();
    CHECK(along > 1.0);
    CHECK(double(depths[5]) == doctest::Approx(along).epsilon(0.02));
    CHECK(depths[6] == 0.0f);
}

TEST_CASE("probability, mean and spread of the optical depth follow from its values") {
    EnsembleDepths depths;
    depths.grid.size = {2, 1, 1};
    depths.members = {"a", "b", "c", "d"};
    depths.of = {{0.0f, 1.0f}, {0.5f, 1.0f}, {2.0f, 1.0f}, {5.5f, 1.5f}};
    // Above, not at, the threshold.
    CHECK(mapOf(depths, EnsembleMap::probability, 1.0) == std::vector{0.5f, 0.25f});
    CHECK(mapOf(depths, EnsembleMap::probability, 0.0) == std::vector{0.75f, 1.0f});
    CHECK(mapOf(depths, EnsembleMap::mean, 1.0) == std::vector{2.0f, 1.125f});
    // (4 + 2.25 + 0 + 12.25) / 3, by hand
    CHECK(double(mapOf(depths, EnsembleMap::spread, 1.0)[0]) ==
          doctest::Approx(std::sqrt(18.5 / 3.0)));
    depths.of.resize(1);
    CHECK(std::isnan(mapOf(depths, EnsembleMap::spread, 1.0)[0]));
}

TEST_CASE("the mean of the members' optical depths is the optical depth of the mean volume") {
    const auto ensemble = ensembleFrom({runOf(1e-3f, 2), runOf(3e-3f, 4)});
    const Look look;
    const EnsembleDepths depths = readEnsembleDepths(*ensemble, 0, {}, look);
    const HeldVolume mean = readVolume(*ensemble, 0, requestOf(kMeanMember));
    const MediumPlan plan = planMedium(look, mean.volume->holdings(), mean.volume->cellM());
    const std::vector<float> ofMean = columnDepths(*mean.volume, plan);
    const std::vector<float> meanOf = mapOf(depths, EnsembleMap::mean, 1.0);
    for (std::size_t i = 0; i < ofMean.size(); ++i) {
        CHECK(double(ofMean[i]) == doctest::Approx(double(meanOf[i])).epsilon(1e-5));
    }
    CHECK(meanOf[3] > 0.0f);
    CHECK(mapOf(depths, EnsembleMap::probability, 0.0)[3] == 0.5f);
}

TEST_CASE("many members are read with a few files open at a time") {
    Runs runs;
    for (int i = 0; i < 7; ++i) runs.push_back(runOf(1e-3f * static_cast<float>(i), 4));
    const auto ensemble = ensembleFrom(runs);
    const auto& first = dynamic_cast<const MemoryDataset&>(ensemble->run(0));
    for (int member = 1; member < 7; ++member) ensemble->run(member);
    // Another handle, with nothing open, has taken the place of the first one.
    CHECK(&ensemble->run(0) != &first);
    CHECK(runs[0].use_count() == 1);
    const EnsembleDepths depths = readEnsembleDepths(*ensemble, 0, {}, Look{});
    CHECK(depths.of.size() == 7);
}

TEST_CASE("members whose grids move apart are shown one by one, and have no mean or map") {
    Runs runs{runOf(1e-3f, 4), runOf(2e-3f, 4)};
    runs[1]->stated().times.front().gridOffsetM = {3000.0, 0.0};
    const auto ensemble = ensembleFrom(runs);
    CHECK(readVolume(*ensemble, 0, requestOf(1)).volume->grid.movedM.x == 3000.0);
    CHECK_THROWS_WITH_AS(readVolume(*ensemble, 0, requestOf(kMeanMember)),
                         doctest::Contains("member mem02: lies elsewhere"), Error);
    CHECK_THROWS_WITH_AS(readEnsembleDepths(*ensemble, 0, {}, Look{}),
                         doctest::Contains("moved by 3000 m, 0 m"), Error);
}

TEST_CASE("volumes of members that are in memory are not read again for a map") {
    const Runs runs{runOf(1e-3f, 4), runOf(2e-3f, 4)};
    const auto ensemble = ensembleFrom(runs);
    const auto first = readVolume(*ensemble, 0, requestOf(0)).volume;
    const int before = runs[0]->reads("z");
    const EnsembleDepths depths = readEnsembleDepths(*ensemble, 0, {}, Look{}, {first, nullptr});
    CHECK(runs[0]->reads("z") == before);
    CHECK(runs[1]->reads("z") > 0);
    CHECK(depths.of[1][0] > depths.of[0][0]);
}
