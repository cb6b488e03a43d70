// old_metres_test.cpp: noise scales of files that have them in metres keep the image they made.
#include "core/look/old_metres.h"

#include <doctest/doctest.h>

#include "core/base/error.h"
#include "core/look/medium.h"
#include "core/preset/preset.h"
#include "core/session/session_file.h"
#include "tests/text.h"

using namespace neph;

namespace {

constexpr FieldSet kCloud = 1U << static_cast<unsigned>(Species::cloud);
constexpr FieldSet kSnow = 1U << static_cast<unsigned>(Species::snow);

}  // namespace

TEST_CASE("A preset with metres has the same detail in data of any cell size, and says so") {
    for (const double cellM : {1000.0, 67.0, 2500.0}) {
        CAPTURE(cellM);
        LoadedPreset loaded = parsePreset(R"({"type": "nephoscope-look", "version": 1,
            "look": {"cloud.noise_scale": 2500, "snow.noise_scale": 6000}})",
                                          "old.json");
        CHECK(loaded.warnings.empty());
        REQUIRE(loaded.notes.size() == 1);
        CHECK(contains(loaded.notes[0], "old.json: noise_scale of cloud, snow is in metres"));
        CHECK(loaded.inMetres == (kCloud | kSnow));
        Look& look = loaded.preset.look;
        const std::string told = bringToCells(look, loaded.inMetres, cellM);
        CHECK(told.empty() == (cellM == 1000.0));
        CHECK(noiseScaleM(look.of(Species::cloud), cellM) == doctest::Approx(2500.0));
        CHECK(noiseScaleM(look.of(Species::snow), cellM) == doctest::Approx(6000.0));
        CHECK(look.of(Species::rain) == Look{}.of(Species::rain));
    }
    Look look;
    look.of(Species::cloud).noiseScaleCells = 2.5f;
    CHECK(contains(bringToCells(look, kCloud, 50.0), "cloud 2500 m = 50 cells"));
}

TEST_CASE("A preset with cells is left as it is, also where it has metres besides") {
    const LoadedPreset loaded = parsePreset(R"({"type": "nephoscope-look", "version": 1,
        "look": {"cloud.noise_scale": 2500, "cloud.noise_cells": 3, "ice.noise_cells": 5}})",
                                            "new.json");
    CHECK(loaded.inMetres == 0);
    CHECK(loaded.notes.empty());
    CHECK(loaded.preset.look.of(Species::cloud).noiseScaleCells == 3.0f);
    CHECK(loaded.preset.look.of(Species::ice).noiseScaleCells == 5.0f);
}

TEST_CASE("A session with metres remembers of which fields until its data are open") {
    std::vector<std::string> warnings;
    const SessionState state = parseSession(
        R"({"type": "nephoscope-session", "version": 1,
            "slots": [{"data": ["cumulus"], "look": {"cloud.noise_scale": 300}}]})",
        "old", "/", warnings);
    CHECK(warnings.empty());
    CHECK(state.slots[0].inMetres == kCloud);
    CHECK(state.slots[0].document.look.of(Species::cloud).noiseScaleCells == doctest::Approx(0.3));
}

TEST_CASE("Metres beyond the range are refused in a file, and bounded where cells are small") {
    CHECK_THROWS_AS(parsePreset(R"({"type": "nephoscope-look", "version": 1,
                                    "look": {"cloud.noise_scale": 1e7}})",
                                "far.json"),
                    Error);
    Look look;
    look.of(Species::cloud).noiseScaleCells = 100.0f;  // 100 km
    CHECK(contains(bringToCells(look, kCloud, 10.0), "1000 cells"));
    CHECK(look.of(Species::cloud).noiseScaleCells == 1000.0f);
}

TEST_CASE("The name of before is answered with that of now") {
    try {
        parameter("rain.noise_scale");
        FAIL("there is no such parameter");
    } catch (const Error& error) {
        CHECK(contains(error.parts().hint, "rain.noise_cells"));
    }
    CHECK(replacedInCells("fog.noise_scale") == nullptr);
    CHECK(replacedInCells("rain.noise_cells") == nullptr);
}
