// engines_test.cpp: the table of engines is whole, and what is read from it is what it says.
#include "core/look/engines.h"

#include <doctest/doctest.h>

#include <set>

#include "core/look/parameter.h"

using namespace neph;

TEST_CASE("Every engine has a row of its own, in the order of the enumerators") {
    std::set<std::string_view> ids, labels;
    for (std::size_t i = 0; i < kEngineCount; ++i) {
        const EngineTraits& engine = kEngines[i];
        CAPTURE(std::string(engine.id));
        CHECK(static_cast<std::size_t>(engine.engine) == i);
        CHECK(&traitsOf(engine.engine) == &engine);
        CHECK_FALSE(engine.id.empty());
        CHECK_FALSE(engine.label.empty());
        CHECK_FALSE(engine.help.empty());
        CHECK_FALSE(engine.unit.empty());
        CHECK(engine.samples >= 1);
        CHECK((engine.refinement == Refinement::averages || engine.samples == 1));
        CHECK(engine.leastDetail >= 0.0);
        CHECK(engine.leastDetail <= 1.0);
        ids.insert(engine.id);
        labels.insert(engine.label);
    }
    CHECK(ids.size() == kEngineCount);
    CHECK(labels.size() == kEngineCount);
}

TEST_CASE("What has no parameter to be drawn more coarsely by is drawn in full detail in motion") {
    for (const EngineTraits& engine : kEngines) {
        if (engine.fineness == Fineness::none) CHECK(engine.leastDetail == 1.0);
    }
}

TEST_CASE("One engine is the ground truth: it converges, and it does not draw unless asked to") {
    int truths = 0;
    for (const EngineTraits& engine : kEngines) truths += engine.groundTruth ? 1 : 0;
    CHECK(truths == 1);
    CHECK(groundTruth() == Engine::reference);
    CHECK(traitsOf(groundTruth()).refinement == Refinement::converges);
    CHECK(traitsOf(groundTruth()).layers);
    CHECK(Look{}.engine != groundTruth());
}

TEST_CASE("Sets of engines are read from their traits") {
    CHECK(enginesWith(&EngineTraits::groundTruth, true) == bitOf(Engine::reference));
    CHECK(enginesWith(&EngineTraits::fineness, Fineness::planes) == bitOf(Engine::slicing));
    CHECK(enginesWith(&EngineTraits::singleScattering, true) ==
          (bitOf(Engine::march) | bitOf(Engine::slicing)));
    unsigned all = 0;
    for (const EngineTraits& engine : kEngines) all |= bitOf(engine.engine);
    CHECK(all == kAllEngines);
}

TEST_CASE("The parameter view.engine offers the engines of the table, with their help") {
    const Parameter& row = parameter("view.engine");
    REQUIRE(row.choices.size() == kEngineCount);
    for (std::size_t i = 0; i < kEngineCount; ++i) {
        CHECK(row.choices[i].id == kEngines[i].id);
        CHECK(row.choices[i].label == kEngines[i].label);
        CHECK(row.choices[i].help == kEngines[i].help);
        CHECK(row.help.find(kEngines[i].help) != std::string::npos);
    }
}

TEST_CASE("Work is counted in singular and plural") {
    CHECK(countText(1, "step") == "1 step");
    CHECK(countText(0, "plane") == "0 planes");
    CHECK(countText(512, traitsOf(Engine::march).unit) == "512 steps");
}
