// preset_difference_test.cpp: every parameter in one part, differences in words, parts taken over.
#include "core/preset/preset_difference.h"

#include <doctest/doctest.h>

#include <bit>
#include <set>

#include "core/base/error.h"
#include "core/camera/camera_format.h"
#include "tests/text.h"

using namespace neph;

namespace {

/// A look and a camera that differ from the defaults in every parameter.
Preset allOther() {
    Preset preset;
    for (const Parameter& row : lookTable()) {
        const ParameterValue value = valueOf(preset.look, row);
        if (const auto* on = std::get_if<bool>(&value)) {
            setValue(preset.look, row, !*on);
        } else if (std::holds_alternative<glm::vec3>(value)) {
            setValue(preset.look, row, glm::vec3(0.5f, 0.25f, 0.125f));
        } else if (row.kind == ParameterKind::choice) {
            setValue(preset.look, row, std::get<int>(value) == 0 ? 1 : 0);
        } else if (row.kind == ParameterKind::integer) {
            setValue(preset.look, row, std::get<int>(value) + 1);
        } else {
            const auto lo = static_cast<float>(row.range.lo), hi = static_cast<float>(row.range.hi);
            setValue(preset.look, row, std::get<float>(value) == hi ? lo : hi);
        }
    }
    preset.camera = CameraPose{{0.1f, 0.2f, 0.3f}, 2.0f, 10.0f, 20.0f, 30.0f};
    return preset;
}

}  // namespace

TEST_CASE("Every parameter belongs to one part of a preset, the one that its id suggests") {
    PresetParts seen = 0;
    for (const Parameter& row : lookTable()) {
        CAPTURE(row.id);
        const PresetParts part = partOf(row);
        CHECK(std::has_single_bit(part));
        CHECK(part != kPresetCamera);
        seen |= part;
        if (row.species) CHECK(part == kPresetFields);
        for (const char* opening : {"sun.", "sky.", "ground.", "light.f"}) {
            if (row.id.starts_with(opening)) CHECK(part == kPresetLight);
        }
        CHECK(row.id.starts_with("view.") == (part == kPresetView));
    }
    CHECK(seen == (kPresetAll & ~kPresetCamera));
    CHECK(partOf(parameter("light.transport")) == kPresetLight);
    CHECK(partOf(parameter("mode.extinction")) == kPresetFields);
    CHECK(partOf(parameter("light.equal_extinction")) == kPresetFields);
}

TEST_CASE(
    "The parts of a preset, taken over one by one, are the preset; one alone leaves the rest") {
    const Preset preset = allOther();
    REQUIRE(differences(Look{}, preset.look).size() == lookTable().size());
    Look look;
    CameraPose camera;
    for (const PresetPart& part : kPresetParts) {
        Look alone;
        CameraPose alonePose;
        takeOver(preset, part.bit, alone, alonePose);
        CHECK((alonePose != CameraPose{}) == (part.bit == kPresetCamera));
        for (const Parameter& row : lookTable()) {
            CAPTURE(row.id);
            const bool taken = valueOf(alone, row) == valueOf(preset.look, row);
            CHECK(taken == (partOf(row) == part.bit));
        }
        takeOver(preset, part.bit, look, camera);
    }
    CHECK(look == preset.look);
    CHECK(camera == *preset.camera);
}

TEST_CASE("A preset without a camera leaves the camera alone") {
    Preset preset = allOther();
    preset.camera.reset();
    Look look;
    CameraPose camera;
    camera.distance = 3.0f;
    takeOver(preset, kPresetAll, look, camera);
    CHECK(camera.distance == 3.0f);
    CHECK(differences(Preset{"", "", preset.look, CameraPose{}}, preset).empty());
}

TEST_CASE("A difference names group, label and both values as the screen shows them") {
    Preset before{"", "", {}, CameraPose{}}, after = before;
    CHECK(differences(before, after).empty());
    before.look.of(Species::rain).effectiveRadiusM = 250e-6f;
    after.look.of(Species::rain).effectiveRadiusM = 1e-3f;
    after.look.transport = Transport::lowAlbedo;
    after.camera->fovDeg = 34.0f;
    after.camera->target.z = 0.5f;
    const std::vector<PresetDifference> rows = differences(before, after);
    REQUIRE(rows.size() == 4);
    CHECK(lineOf(rows[0]) == "Rain: Effective radius 250 µm -> 1000 µm");
    CHECK(rows[0].part == kPresetFields);
    CHECK(lineOf(rows[1]) == "Light: Transport Full -> Low albedo");
    CHECK(rows[1].part == kPresetLight);
    CHECK(lineOf(rows[2]) == "Camera: Target height 0.35 -> 0.5");
    CHECK(lineOf(rows[3]) == "Camera: Field of view 40° -> 34°");
    CHECK(rows[3].part == kPresetCamera);
    CHECK(linesOf(rows, 4).find("more") == std::string::npos);
    CHECK(contains(linesOf(rows, 1), "\nand 3 more"));
}

TEST_CASE("Two cameras differ in as many rows as a camera has numbers in its file") {
    Preset before{"", "", {}, CameraPose{}}, after = before;
    after.camera->target = {0.0f, 0.0f, 0.0f};
    for (const CameraKey& key : kCameraKeys) after.camera.value().*(key.member) = key.hi;
    CHECK(differences(before, after).size() == 3 + kCameraKeys.size());
}

TEST_CASE("What differs beyond the digits on screen is shown in full") {
    Look before, after;
    before.sunIntensity = 1.0f;
    after.sunIntensity = 1.00001f;
    const auto rows = differences(before, after);
    REQUIRE(rows.size() == 1);
    CHECK(rows[0].before != rows[0].after);
    CHECK(rows[0].after == "1.00001");
}

TEST_CASE("Parts are named in a list, and a wrong name is told with those there are") {
    CHECK(parsePresetParts("all") == kPresetAll);
    CHECK(parsePresetParts("fields,camera") == (kPresetFields | kPresetCamera));
    CHECK(presetPartsText(kPresetFields | kPresetCamera) == "fields, camera");
    CHECK(presetPartsText(kPresetAll) == "all");
    for (const char* wrong : {"", "fields,", "lihgt", "Fields"}) {
        CAPTURE(wrong);
        CHECK_THROWS_WITH_AS(parsePresetParts(wrong), doctest::Contains("fields, light, view"),
                             Error);
    }
    CHECK_THROWS_WITH_AS(parsePresetParts("lihgt"), doctest::Contains("did you mean light?"),
                         Error);
}
