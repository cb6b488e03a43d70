// preset_test.cpp: presets bit for bit, and every way in which a file can be wrong.
#include "core/preset/preset.h"

#include <doctest/doctest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/look/parameter.h"
#include "tests/environment.h"
#include "tests/temporary_folder.h"
#include "tests/text.h"

using namespace neph;

namespace {

std::string withLook(const std::string& look) {
    return R"({"type": "nephoscope-look", "version": 1, "look": {)" + look + "}}";
}

std::string withCamera(const std::string& camera) {
    return R"({"type": "nephoscope-look", "version": 1, "camera": )" + camera + "}";
}

/// The message of the Error that the text is refused with; empty when it is taken.
std::string refusal(const std::string& text) {
    try {
        parsePreset(text, "my.json");
    } catch (const Error& error) {
        return error.message();
    }
    return {};
}

/// Any value that the row takes.
ParameterValue randomValue(const Parameter& row, std::mt19937& random) {
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    const auto number = [&] {
        const float value = static_cast<float>(row.range.lo) +
                            unit(random) * static_cast<float>(row.range.hi - row.range.lo);
        return std::min(value, static_cast<float>(row.range.hi));
    };
    switch (row.kind) {
        case ParameterKind::toggle:
            return unit(random) < 0.5f;
        case ParameterKind::integer:
            return static_cast<int>(number());
        case ParameterKind::choice:
            return static_cast<int>(random() % row.choices.size());
        case ParameterKind::colour:
            return glm::vec3(unit(random), unit(random), unit(random));
        case ParameterKind::number:
            break;
    }
    return number();
}

}  // namespace

TEST_CASE("Any look reads back from its preset bit for bit") {
    std::mt19937 random(7);
    for (int round = 0; round < 50; ++round) {
        Preset preset;
        preset.title = "Round \"" + std::to_string(round) + "\" é\n";
        for (const Parameter& row : lookTable()) {
            setValue(preset.look, row, randomValue(row, random));
        }
        preset.camera = CameraPose{{0.1f, 1.0f / 3.0f, 0.7f}, 0.123456789f, 359.99f, -89.9f, 5.0f};
        const LoadedPreset loaded = parsePreset(formatPreset(preset), "text");
        CHECK(loaded.preset == preset);
        CHECK(loaded.warnings.empty());
    }
}

TEST_CASE("A preset holds every parameter once, in the order of the table") {
    const auto document = nlohmann::ordered_json::parse(formatPreset({}));
    CHECK(document["type"] == "nephoscope-look");
    CHECK(document["version"] == 1);
    std::size_t i = 0;
    for (const auto& [key, value] : document["look"].items()) {
        REQUIRE(i < lookTable().size());
        CHECK(key == lookTable()[i++].id);
    }
    CHECK(i == lookTable().size());
}

TEST_CASE("A preset holds no sampling, and sampling in a file is left alone with a note") {
    const std::string text = formatPreset({});
    for (const Parameter& row : samplingTable()) {
        CHECK_FALSE(contains(text, "\"" + row.id + "\""));
    }
    const LoadedPreset loaded = parsePreset(
        withLook(R"("view.seed": 7, "view.quality": 2, "view.exposure": 1, "view.planes": 64)"),
        "old.json");
    Look expected;
    expected.exposureEv = 1.0f;
    expected.planes = 64;
    CHECK(loaded.preset.look == expected);
    CHECK(loaded.warnings.empty());
    REQUIRE(loaded.notes.size() == 1);
    CHECK(contains(loaded.notes[0], "old.json: view.seed, view.quality not taken over"));
    CHECK(contains(refusal(withLook(R"("view.seed": -1)")), "from 0 to 1000000"));
}

TEST_CASE("A preset reads as people write numbers") {
    Preset preset;
    preset.look.of(Species::cloud).mixingScale = 0.1f;
    CHECK(contains(formatPreset(preset), "\"cloud.mixing_scale\": 0.1,"));
}

TEST_CASE("Keys that are missing take their defaults") {
    const LoadedPreset loaded = parsePreset(withLook(R"("cloud.mixing_scale": 0.5)"), "my.json");
    Look expected;
    expected.of(Species::cloud).mixingScale = 0.5f;
    CHECK(loaded.preset.look == expected);
    CHECK_FALSE(loaded.preset.camera.has_value());
    CHECK(loaded.warnings.empty());
}

TEST_CASE("A whole number is taken where a number is wanted") {
    CHECK(parsePreset(withLook(R"("cloud.mixing_scale": 2)"), "")
              .preset.look.species[0]
              .mixingScale == 2.0f);
}

TEST_CASE("An unknown key is left out with a warning that names the nearest one") {
    const LoadedPreset loaded = parsePreset(withLook(R"("cloud.mixing_scal": 0.5)"), "my.json");
    CHECK(loaded.preset.look == Look{});
    REQUIRE(loaded.warnings.size() == 1);
    CHECK(contains(loaded.warnings[0], "my.json"));
    CHECK(contains(loaded.warnings[0], "\"cloud.mixing_scal\""));
    CHECK(contains(loaded.warnings[0], "\"cloud.mixing_scale\"?"));
    const auto top = parsePreset(
        R"({"type": "nephoscope-look", "version": 1, "titel": "x", "camera": {"fov_dg": 3}})", "");
    REQUIRE(top.warnings.size() == 2);
    CHECK(contains(top.warnings[0], "\"title\"?"));
    CHECK(contains(top.warnings[1], "\"fov_deg\"?"));
}

TEST_CASE("A value out of range is refused with file, key, value and range") {
    const std::string text = refusal(withLook(R"("cloud.mixing_scale": 100.5)"));
    CHECK(contains(text, "my.json"));
    CHECK(contains(text, "cloud.mixing_scale"));
    CHECK(contains(text, "100.5"));
    CHECK(contains(text, "from 0 to 100"));
}

TEST_CASE("A value of the wrong type is refused with key, value and what is expected") {
    struct Case {
        const char* look;
        const char* key;
        const char* expected;
    };
    for (const Case& c :
         {Case{R"("cloud.mixing_scale": "1")", "cloud.mixing_scale", "a number"},
          Case{R"("cloud.mixing_scale": null)", "cloud.mixing_scale", "a number"},
          Case{R"("cloud.mixing_scale": true)", "cloud.mixing_scale", "a number"},
          Case{R"("cloud.visible": 1)", "cloud.visible", "true or false"},
          Case{R"("view.planes": 64.5)", "view.planes", "whole number"},
          Case{R"("view.planes": 1e30)", "view.planes", "whole number"},
          Case{R"("light.transport": "translucen")", "light.transport", "translucent"},
          Case{R"("light.transport": 1)", "light.transport", "translucent"},
          Case{R"("sky.zenith": [0, 0])", "sky.zenith", "three numbers"},
          Case{R"("sky.zenith": [0, 0, 2])", "sky.zenith", "three numbers"},
          Case{R"("sky.zenith": [0, 0, "1"])", "sky.zenith", "three numbers"}}) {
        CAPTURE(c.look);
        const std::string text = refusal(withLook(c.look));
        CHECK(contains(text, c.key));
        CHECK(contains(text, c.expected));
    }
}

TEST_CASE("A file of another type, of another version or of none is refused by name") {
    CHECK(contains(refusal(R"({"type": "polyscope", "version": 1})"), "polyscope"));
    CHECK(contains(refusal(R"({"type": "nephoscope-look", "version": 2})"), "2"));
    CHECK(contains(refusal(R"({"version": 1})"), "nephoscope-look"));
    CHECK(contains(refusal(R"({"type": "nephoscope-look"})"), "version"));
    CHECK(contains(refusal("[1, 2]"), "[1,2]"));
    CHECK(contains(refusal(R"({"type": "nephoscope-look", "version": 1, "look": 3})"), "look"));
    CHECK(contains(refusal(R"({"type": "nephoscope-look", "version": 1, "title": 3})"), "title"));
}

TEST_CASE("What is not JSON is refused with the line where it goes wrong") {
    CHECK(contains(refusal(""), "JSON"));
    CHECK(contains(refusal("{\n\n  \"type\": nonsense\n}"), "line 3"));
    CHECK_FALSE(refusal(withLook(R"("cloud.mixing_scale": NaN)")).empty());
    CHECK_FALSE(refusal(withLook(R"("cloud.mixing_scale": 1e400)")).empty());
    CHECK_FALSE(refusal("{\"type\": \"\xff\xfe\"}").empty());
}

TEST_CASE("A preset cut short anywhere is refused") {
    const std::string whole = formatPreset({});
    const std::size_t end = whole.find_last_of('}');
    for (std::size_t size = 0; size <= end; ++size) {
        if (refusal(whole.substr(0, size)).empty()) FAIL("taken at " << size);
    }
    CHECK(refusal(whole.substr(0, end + 1)).empty());
}

TEST_CASE("A key that stands twice is refused by name") {
    CHECK(contains(refusal(withLook(R"("cloud.mixing_scale": 1, "cloud.mixing_scale": 2)")),
                   "\"cloud.mixing_scale\""));
    CHECK(
        contains(refusal(R"({"type": "nephoscope-look", "type": "x", "version": 1})"), "\"type\""));
}

TEST_CASE("Deep nesting is refused and does not overflow the stack") {
    constexpr std::size_t kDeep = 1000000;
    CHECK(contains(refusal(std::string(kDeep, '[')), "deep"));
    std::string objects;
    for (int i = 0; i < 100000; ++i) objects += "{\"a\":";
    CHECK(contains(refusal(objects), "deep"));
    CHECK(
        contains(refusal(withLook(R"("cloud.mixing_scale": )" + std::string(1000, '['))), "deep"));
}

TEST_CASE("A camera is checked as a look is") {
    const LoadedPreset loaded = parsePreset(
        withCamera(R"({"target": [0.1, 0.2, 0.3], "distance": 2, "azimuth_deg": 10})"), "");
    REQUIRE(loaded.preset.camera.has_value());
    CHECK(loaded.preset.camera->target == glm::vec3(0.1f, 0.2f, 0.3f));
    CHECK(loaded.preset.camera->distance == 2.0f);
    CHECK(loaded.preset.camera->fovDeg == CameraPose{}.fovDeg);
    CHECK_FALSE(loaded.preset.camera->fixedToGround);
    Preset fixed;
    fixed.camera = CameraPose{};
    CHECK_FALSE(contains(formatPreset(fixed), "fixed_to_ground"));
    fixed.camera->fixedToGround = true;
    CHECK(parsePreset(formatPreset(fixed), "").preset == fixed);
    for (const char* camera :
         {R"({"distance": 0})", R"({"distance": 1e9})", R"({"distance": "1"})",
          R"({"fov_deg": 80})", R"({"elevation_deg": 91})", R"({"target": [0, 0, 9]})",
          R"({"target": 1})", R"({"fixed_to_ground": "yes"})", "1"}) {
        CAPTURE(camera);
        CHECK(contains(refusal(withCamera(camera)), "my.json"));
    }
}

TEST_CASE("Saving leaves the preset and nothing beside it") {
    const TemporaryFolder folder;
    Preset preset;
    preset.title = "one";
    savePreset(folder / "a.json", preset);
    preset.title = "two";
    savePreset(folder / "a.json", preset);
    CHECK(loadPreset(folder / "a.json").preset.title == "two");
    CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
    struct stat status {};
    REQUIRE(::stat((folder / "a.json").c_str(), &status) == 0);
    CHECK((status.st_mode & 0600) == 0600);
}

TEST_CASE("A place that cannot be written is an error that names it, and the old file stays") {
    const TemporaryFolder folder;
    CHECK_THROWS_AS(savePreset(folder / "missing" / "a.json", {}), Error);
    CHECK_THROWS_AS(savePreset(folder.path(), {}), Error);
    std::filesystem::create_directory(folder / "b.json");
    CHECK_THROWS_AS(savePreset(folder / "b.json", {}), Error);
    CHECK(std::filesystem::is_directory(folder / "b.json"));
    CHECK_THROWS_WITH_AS(checkReplaceable(folder / "missing" / "a.json"),
                         doctest::Contains("no folder"), Error);
    CHECK_THROWS_WITH_AS(checkReplaceable("/dev/null/a.json"), doctest::Contains("no folder"),
                         Error);
    CHECK_NOTHROW(checkReplaceable(folder / "a.json"));
    CHECK_FALSE(std::filesystem::exists(folder / "a.json"));
}

TEST_CASE("A file that is no preset file is refused before it is read in full") {
    const TemporaryFolder folder;
    CHECK_THROWS_AS(loadPreset(folder / "missing.json"), Error);
    CHECK_THROWS_AS(loadPreset(folder.path()), Error);
    std::ofstream(folder / "huge.json") << std::string((1 << 20) + 1, ' ');
    CHECK_THROWS_WITH_AS(loadPreset(folder / "huge.json"), doctest::Contains("1 MiB"), Error);
    CHECK_THROWS_WITH_AS(loadPreset("/dev/zero"), doctest::Contains("1 MiB"), Error);
}

TEST_CASE("Presets are found by name, the user's before the bundled ones") {
    const TemporaryFolder home, data;
    const Environment xdg("XDG_DATA_HOME", home.path().string());
    const Environment bundled("NEPHOSCOPE_DATA_DIR", data.path().string());
    std::filesystem::create_directory(data / "presets");
    savePreset(data / "presets" / "storm.json", {"bundled", "", {}, {}});
    savePreset(data / "presets" / "anvil.json", {"bundled", "", {}, {}});
    CHECK(listPresets().size() == 2);
    CHECK(listPresets()[0].name == "anvil");
    savePreset(userPresetFile("storm"), {"mine", "", {}, {}});
    savePreset(userPresetFile("zenith"), {"mine", "", {}, {}});
    CHECK(listPresets().size() == 3);
    CHECK(loadPreset(findPreset("storm")).preset.title == "mine");
    CHECK(loadPreset(findPreset("anvil")).preset.title == "bundled");
    CHECK(findPreset((data / "presets" / "anvil.json").string()) ==
          data / "presets" / "anvil.json");
    CHECK_THROWS_WITH_AS(findPreset("anvill"), doctest::Contains("did you mean anvil?"), Error);
}

TEST_CASE("A name that could leave the user's folder is refused") {
    const TemporaryFolder home;
    const Environment xdg("XDG_DATA_HOME", home.path().string());
    for (const char* name : {"", "../x", "a/b", ".hidden", "new\nline"}) {
        CAPTURE(name);
        CHECK_THROWS_AS(userPresetFile(name), Error);
    }
    CHECK(userPresetFile("my storm").parent_path() == home / "nephoscope" / "presets");
}

TEST_CASE("A camera comes from a preset or from a file with the camera alone") {
    const TemporaryFolder folder;
    std::vector<std::string> warnings;
    std::ofstream(folder / "camera.json") << R"({"distance": 0.25, "azimut_deg": 1})";
    CHECK(loadCamera((folder / "camera.json").string(), warnings).distance == 0.25f);
    REQUIRE(warnings.size() == 1);
    CHECK(contains(warnings[0], "azimuth_deg"));
    CameraPose pose;
    pose.distance = 0.75f;
    savePreset(folder / "preset.json", {"", "", {}, pose});
    CHECK(loadCamera((folder / "preset.json").string(), warnings) == pose);
    savePreset(folder / "none.json", {});
    CHECK_THROWS_WITH_AS(loadCamera((folder / "none.json").string(), warnings),
                         doctest::Contains("no camera"), Error);
}

TEST_CASE("Every bundled preset is right, complete and has a camera and a title") {
    const TemporaryFolder home;
    const Environment xdg("XDG_DATA_HOME", home.path().string());
    const std::filesystem::path presets = NEPH_TEST_SOURCE_DIR "/presets";
    int count = 0;
    for (const auto& item : std::filesystem::directory_iterator(presets)) {
        CAPTURE(item.path().string());
        const LoadedPreset loaded = loadPreset(item.path());
        CHECK(loaded.warnings.empty());
        CHECK(loaded.notes.empty());
        CHECK(loaded.preset.camera.has_value());
        CHECK_FALSE(loaded.preset.title.empty());
        ++count;
    }
    CHECK(count >= 10);  // default, and nine after figures of [Riley03]
}
