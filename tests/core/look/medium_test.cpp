// medium_test.cpp: which classes a look makes, and what turns held values into extinction.
#include "core/look/medium.h"

#include <doctest/doctest.h>

using namespace neph;
using doctest::Approx;

namespace {

std::array<Holding, kSpeciesCount> all(Holding holding) {
    std::array<Holding, kSpeciesCount> holdings{};
    holdings.fill(holding);
    return holdings;
}

}  // namespace

TEST_CASE("Mass becomes extinction by radius and density, extinction by the mixing scale alone") {
    Look look;
    look.of(Species::ice).mixingScale = 0.5f;
    const std::size_t ice = static_cast<std::size_t>(Species::ice);
    const MediumPlan mass = planMedium(look, all(Holding::content), 1000.0);
    CHECK(mass.extinctionPerHeld[ice] == Approx(0.5 * 1.636).epsilon(3e-4));
    const MediumPlan sized = planMedium(look, all(Holding::extinction), 1000.0);
    CHECK(sized.extinctionPerHeld[ice] == 0.5f);
    look.of(Species::ice).effectiveRadiusM = 1e-5f;
    CHECK(planMedium(look, all(Holding::extinction), 1000.0) == sized);
    CHECK(planMedium(look, all(Holding::content), 1000.0).extinctionPerHeld[ice] > 50.0f);
}

TEST_CASE("What is absent or invisible takes no part, however it is held") {
    Look look;
    CHECK(planMedium(look, all(Holding::absent), 1000.0).classes.empty());
    look.of(Species::snow).visible = false;
    const MediumPlan plan = planMedium(look, all(Holding::extinction), 1000.0);
    CHECK(plan.classOf[static_cast<std::size_t>(Species::snow)] == -1);
    CHECK(plan.classOf[static_cast<std::size_t>(Species::ice)] >= 0);
}

TEST_CASE("Detail has its length in cells of the data") {
    Look look;
    look.noise = true;
    look.of(Species::cloud).noiseScaleCells = 2.5f;
    const auto lengthM = [&](double cellM) {
        const MediumPlan plan = planMedium(look, all(Holding::content), cellM);
        const int c = plan.classOf[static_cast<std::size_t>(Species::cloud)];
        return plan.classes[static_cast<std::size_t>(c)].noiseScaleM;
    };
    CHECK(lengthM(1000.0) == 2500.0f);
    CHECK(lengthM(20.0) == 50.0f);
}

TEST_CASE("Mixing scales by cell are the same at 1 km, grow for finer cells, and end at 1") {
    Look look;
    look.of(Species::cloud).mixingScale = 0.02f;
    look.of(Species::rain).mixingScale = 0.0f;
    look.of(Species::snow).mixingScale = 3.0f;
    const auto scale = [&](Species s, double cellM) {
        return mixingScaleAt(look, look.of(s), cellM);
    };
    CHECK(scale(Species::cloud, 20.0) == 0.02f);  // as given, unless it is asked for
    look.mixing = MixingRule::byCell;
    CHECK(scale(Species::cloud, 1000.0) == 0.02f);
    CHECK(scale(Species::cloud, 3000.0) == 0.02f);
    CHECK(scale(Species::cloud, 100.0) == Approx(0.2));
    CHECK(scale(Species::cloud, 10.0) == 1.0f);
    CHECK(scale(Species::rain, 10.0) == 0.0f);
    CHECK(scale(Species::snow, 10.0) == 3.0f);
    const std::size_t cloud = static_cast<std::size_t>(Species::cloud);
    CHECK(planMedium(look, all(Holding::extinction), 100.0).extinctionPerHeld[cloud] ==
          Approx(0.2));
}
