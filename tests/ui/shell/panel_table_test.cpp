// panel_table_test.cpp: what follows from a row of the table of panels.
#include "app/ui/shell/panel_table.h"

#include <doctest/doctest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <set>
#include <string>

#include "app/ui/shell/actions.h"
#include "app/ui/shell/frame.h"
#include "app/ui/shell/wishes.h"
#include "core/preset/preset.h"
#include "tests/temporary_folder.h"
#include "tests/ui/headless.h"

using namespace neph;

namespace {

/// Windows that were drawn in the last frame.
std::set<std::string> windows(Headless& gui, ui::Ui& state) {
    for (int i = 0; i < 2; ++i) gui.frame([&] { ui::draw(state); });
    std::set<std::string> names;
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
        if (window->WasActive) names.insert(window->Name);
    }
    return names;
}

}  // namespace

TEST_CASE("Every panel has an id of its own, is drawn by something, and is hidden by an action") {
    std::set<std::string_view> ids;
    for (const ui::Panel& panel : ui::panels()) {
        CAPTURE(panel.id);
        CHECK_FALSE(panel.id.empty());
        CHECK(ids.insert(panel.id).second);
        CHECK((panel.draw != nullptr));
        CHECK((panel.shown != nullptr) == !panel.toggle.id.empty());
        if (!panel.before.empty()) CHECK(ui::findAction(panel.before) != nullptr);
    }
}

TEST_CASE("The action of a panel shows it and hides it again, and stands where its row says") {
    Headless gui;
    Session session(noReaders());
    ui::Ui state(session);
    const std::set<std::string> without = windows(gui, state);
    for (const ui::Panel& panel : ui::panels()) {
        if (panel.shown == nullptr) continue;
        CAPTURE(panel.id);
        const ui::Action* action = ui::findAction(panel.toggle.id);
        REQUIRE((action != nullptr));
        REQUIRE(ui::runAction(state, action->id));
        CHECK(ui::isChecked(*action, state));
        CHECK(windows(gui, state).size() > without.size());
        REQUIRE(ui::runAction(state, action->id));
        CHECK_FALSE(ui::isChecked(*action, state));
        CHECK(windows(gui, state) == without);
        const ui::Action* next = action + 1;
        REQUIRE(next < ui::actions().data() + ui::actions().size());
        CHECK(next->id == panel.before);
        CHECK(next->menu == action->menu);
    }
}

TEST_CASE("What a panel asks of another is carried out within the frame") {
    const TemporaryFolder folder;
    Preset preset;
    preset.look.exposureEv = 2.0f;
    savePreset(folder / "p.json", preset);
    Headless gui;
    Session session(noReaders());
    ui::Ui state(session);
    state.requests.preset = (folder / "p.json").string();
    gui.frame([&] { ui::draw(state); });
    CHECK_FALSE(state.requests.preset.has_value());
    CHECK(session.document.look.exposureEv == 2.0f);
    CHECK(session.history.canUndo());
}
