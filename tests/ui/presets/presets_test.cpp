// presets_test.cpp: the browser of presets with a made-up mouse, a folder of its own and the
// clipboard; without images.
#include <doctest/doctest.h>
#include <imgui.h>

#include <algorithm>
#include <fstream>

#include "app/ui/presets/preset_browser.h"
#include "app/ui/presets/preset_card.h"
#include "app/ui/presets/preset_commands.h"
#include "app/ui/presets/preset_dialogs.h"
#include "app/ui/shell/actions.h"
#include "app/ui/shell/context.h"
#include "app/ui/widgets/places.h"
#include "core/preset/preset_files.h"
#include "tests/environment.h"
#include "tests/temporary_folder.h"
#include "tests/text.h"
#include "tests/ui/headless.h"

using namespace neph;

namespace {

/// A window with the browser alone, and a library of one bundled preset and one of the user's.
struct Browser {
    TemporaryFolder home, data;
    Environment xdg{"XDG_DATA_HOME", home.path().string()};
    Environment bundled{"NEPHOSCOPE_DATA_DIR", data.path().string()};
    Headless gui;
    Session session{noReaders()};
    ui::Ui state{session};

    Browser() {
        std::filesystem::create_directory(data / "presets");
        Preset storm{"A storm", "of the test", {}, CameraPose{}};
        storm.look.sunElevationDeg = 10.0f;
        storm.look.of(Species::rain).visible = false;
        storm.camera->fovDeg = 34.0f;
        savePreset(data / "presets" / "storm.json", storm);
        Preset mine;
        mine.look.exposureEv = 2.0f;
        saveOwnPreset("mine", mine, false);
        ui::wantPlaces(true);
        frame();
        frame();
    }
    ~Browser() { ui::wantPlaces(false); }

    void frame() {
        ui::clearPlaces();
        gui.frame([&] {
            ImGui::SetNextWindowPos({0.0f, 0.0f});
            ImGui::SetNextWindowSize({280.0f, 700.0f});
            ImGui::Begin("column", nullptr, ImGuiWindowFlags_NoDecoration);
            ui::drawPresets(ui::contextOf(state), state.presets);
            ImGui::End();
            ui::drawPresetDialogs(ui::contextOf(state), state.presets);
        });
    }
    void click(const std::string& name, int button = 0) {
        frame();  // a dialog that was just opened is now where it stays
        const auto place = ui::placeOf(name);
        INFO(name);
        REQUIRE(place.has_value());
        const glm::vec2 at = place->lower * 0.75f + place->upper * 0.25f;
        ImGui::GetIO().MousePos = {at.x, at.y};
        frame();
        ImGui::GetIO().MouseDown[button] = true;
        frame();
        ImGui::GetIO().MouseDown[button] = false;
        frame();
        frame();
    }
    std::string said() const {
        return session.messages.empty() ? "" : session.messages.back().text;
    }
};

}  // namespace

TEST_CASE(
    "A click on a card loads the preset as one step, says what it changed and can be undone") {
    Browser browser;
    const Document before = browser.session.document;
    browser.click("preset:storm");
    CHECK(browser.session.presetName == "storm");
    CHECK(browser.session.document.look.sunElevationDeg == 10.0f);
    CHECK(browser.session.document.camera.fovDeg == 34.0f);
    CHECK(browser.state.presets.applied.rows.size() == 3);
    CHECK_FALSE(ui::presetChanged(browser.session));
    browser.click("presets.undo");
    CHECK(browser.session.document == before);
    CHECK_FALSE(browser.session.history.canUndo());
    CHECK(ui::presetChanged(browser.session));
    browser.frame();
    CHECK_FALSE(ui::placeOf("presets.undo").has_value());
}

TEST_CASE("The details of a card apply a part of it and leave the rest") {
    Browser browser;
    browser.click("preset:storm.details");
    REQUIRE(ui::placeOf("preset_details.light").has_value());
    browser.click("preset_details.light");
    CHECK(browser.session.document.look.sunElevationDeg == 10.0f);
    CHECK(browser.session.document.look.of(Species::rain).visible);
    CHECK(browser.session.document.camera == CameraPose{});
    CHECK(browser.session.presetName.empty());
    CHECK(browser.session.history.undoLabel() == "Preset storm: light");
    browser.frame();
    CHECK_FALSE(ui::placeOf("preset_details.light").has_value());  // and are closed
}

TEST_CASE("A card tells title, description and what it would change, the first dozen of it") {
    Browser browser;
    REQUIRE(browser.state.presets.cards.size() == 2);
    const ui::PresetCard& storm = browser.state.presets.cards[0];
    const std::string text = ui::describePresetCard(browser.session, storm, 12);
    CHECK(text.starts_with("A storm\nof the test\n"));
    CHECK(contains(text, "Sun and sky: Sun elevation 35° -> 10°"));
    CHECK_FALSE(contains(text, "more"));
    CHECK(contains(ui::describePresetCard(browser.session, storm, 1), "and 2 more"));
    browser.click("preset:storm");
    CHECK(contains(ui::describePresetCard(browser.session, storm, 12), "Just as it is now"));
}

TEST_CASE("A card without a thumbnail has the sky of its look behind the storm, made once") {
    Browser browser;
    Preset airy;
    airy.look.skyModel = SkyModel::atmosphere;
    airy.camera = CameraPose{.elevationDeg = -4.0f};
    saveOwnPreset("airy", airy, false);
    browser.state.presets.listed = false;
    for (int i = 0; i < 5; ++i) browser.frame();
    const auto& cards = browser.state.presets.cards;
    REQUIRE(cards.size() == 3);
    for (const ui::PresetCard& card : cards) {
        CAPTURE(card.entry.name);
        REQUIRE(card.placeholder.has_value());
        CHECK(card.placeholder->horizon > 0.0f);
        CHECK(card.placeholder->horizon < 1.0f);
    }
    const auto& made = *std::ranges::find(cards, "airy", [](const ui::PresetCard& card) {
                            return card.entry.name;
                        })->placeholder;
    // Blue above; seen from the ground the horizon is below the middle.
    CHECK(made.sky[2].b > 1.2f * made.sky[2].r);
    CHECK(made.horizon > 0.5f);
    CHECK(made.sky[2] != ui::placeholderOf(Preset{}).sky[2]);
}

TEST_CASE("A search leaves the cards with all of its words, in whatever case") {
    Browser browser;
    struct Case {
        const char* search;
        bool storm, mine;
    };
    for (const Case& c : {Case{"STOR test", true, false}, Case{"mine", false, true},
                          Case{"storm mine", false, false}, Case{"", true, true}}) {
        CAPTURE(c.search);
        browser.state.presets.search = c.search;
        browser.frame();
        CHECK(ui::placeOf("preset:storm").has_value() == c.storm);
        CHECK(ui::placeOf("preset:mine").has_value() == c.mine);
    }
}

TEST_CASE("Ctrl+S saves a preset of the user's own, and asks for a name where it is bundled") {
    Browser browser;
    browser.session.loadPreset("mine");
    browser.session.document.look.exposureEv = 3.0f;
    CHECK(ui::runChord(browser.state, {ui::Key::s, true}));
    CHECK(loadPreset(findPreset("mine")).preset.look.exposureEv == 3.0f);
    CHECK_FALSE(ui::presetChanged(browser.session));
    browser.session.loadPreset("storm");
    browser.session.document.look.exposureEv = -1.0f;
    CHECK(ui::runChord(browser.state, {ui::Key::s, true}));
    CHECK(presetNameUse("storm") == PresetNameUse::bundled);
    CHECK(browser.state.presets.name == "storm 2");
    browser.frame();
    browser.click("preset_dialog.ok");
    CHECK(loadPreset(findPreset("storm 2")).preset.look.exposureEv == -1.0f);
    CHECK(browser.session.presetName == "storm 2");
    browser.frame();
    CHECK(ui::placeOf("preset:storm 2").has_value());
    CHECK_FALSE(ui::placeOf("preset_dialog.ok").has_value());
}

TEST_CASE("A name that cannot be is told while it is typed, and does nothing") {
    Browser browser;
    ui::openPresetDialog(browser.session, browser.state.presets, ui::PresetDialog::saveAs);
    for (const char* name : {"", "a/b", ".x"}) {
        CAPTURE(name);
        browser.state.presets.name = name;
        browser.frame();
        browser.click("preset_dialog.ok");
        REQUIRE(ui::placeOf("preset_dialog.ok").has_value());  // stays open
        CHECK(listPresets().size() == 2);
    }
    browser.click("preset_dialog.cancel");
    CHECK_FALSE(ui::placeOf("preset_dialog.ok").has_value());
}

TEST_CASE("The menu of a card duplicates it, and deletes the user's own alone") {
    Browser browser;
    browser.click("preset:storm", 1);
    browser.click("preset_menu.delete");  // greyed: nothing happens
    CHECK(presetNameUse("storm") == PresetNameUse::bundled);
    browser.click("preset_menu.duplicate");
    browser.frame();
    REQUIRE(ui::placeOf("preset:storm 2").has_value());
    browser.click("preset:mine", 1);
    browser.click("preset_menu.delete");
    CHECK(contains(browser.said(), "Trash"));
    browser.frame();
    CHECK_FALSE(ui::placeOf("preset:mine").has_value());
    CHECK(std::filesystem::exists(browser.home / "Trash" / "files" / "mine.json"));
}

TEST_CASE("A look goes through the clipboard as JSON, and what is no preset changes nothing") {
    Browser browser;
    browser.session.document.look.sunAzimuthDeg = 123.25f;
    const Document kept = browser.session.document;
    CHECK(ui::runChord(browser.state, {ui::Key::c, true, true}));
    CHECK(parsePreset(ImGui::GetClipboardText(), "").preset.look == kept.look);
    browser.session.document = {};
    CHECK(ui::runChord(browser.state, {ui::Key::v, true, true}));
    CHECK(browser.session.document == kept);
    CHECK(browser.session.undo());
    CHECK(browser.session.document == Document{});
    for (const char* wrong :
         {"", "hello",
          R"({"type": "nephoscope-look", "version": 1, "look": {"sun.azimuth": 999}})"}) {
        CAPTURE(wrong);
        ImGui::SetClipboardText(wrong);
        CHECK(ui::runChord(browser.state, {ui::Key::v, true, true}));
        CHECK(browser.session.document == Document{});
        CHECK(browser.session.messages.back().kind == Message::Kind::error);
        CHECK(contains(browser.said(), "clipboard"));
    }
    CHECK(contains(browser.said(), "sun.azimuth"));
    CHECK(contains(browser.said(), "from 0 to 360"));
}

TEST_CASE("A preset file that is broken stands among the cards and says why") {
    Browser browser;
    std::ofstream(userPresetFile("broken")) << "{";
    browser.state.presets.listed = false;
    browser.frame();
    REQUIRE(browser.state.presets.cards.size() == 3);
    const ui::PresetCard& broken = browser.state.presets.cards[1];  // after those bundled
    CHECK(broken.entry.name == "broken");
    CHECK(contains(ui::describePresetCard(browser.session, broken, 12), "JSON"));
    const Document before = browser.session.document;
    browser.frame();
    browser.click("preset:broken");
    CHECK(browser.session.document == before);
    CHECK(browser.session.messages.back().kind == Message::Kind::error);
}
