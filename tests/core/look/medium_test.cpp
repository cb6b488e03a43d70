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
    const MediumPlan mass = planMedium(look, all(Holding::content));
    CHECK(mass.extinctionPerHeld[ice] == Approx(0.5 * 1.636).epsilon(3e-4));
    const MediumPlan sized = planMedium(look, all(Holding::extinction));
    CHECK(sized.extinctionPerHeld[ice] == 0.5f);
    look.of(Species::ice).effectiveRadiusM = 1e-5f;
    CHECK(planMedium(look, all(Holding::extinction)) == sized);
    CHECK(planMedium(look, all(Holding::content)).extinctionPerHeld[ice] > 50.0f);
}

TEST_CASE("What is absent or invisible takes no part, however it is held") {
    Look look;
    CHECK(planMedium(look, all(Holding::absent)).classes.empty());
    look.of(Species::snow).visible = false;
    const MediumPlan plan = planMedium(look, all(Holding::extinction));
    CHECK(plan.classOf[static_cast<std::size_t>(Species::snow)] == -1);
    CHECK(plan.classOf[static_cast<std::size_t>(Species::ice)] >= 0);
}
