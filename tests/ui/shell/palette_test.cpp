// palette_test.cpp: finding commands by their names, and running what was found by keys.
#include <doctest/doctest.h>
#include <imgui.h>

#include <algorithm>

#include "app/ui/shell/actions.h"
#include "app/ui/shell/command_search.h"
#include "app/ui/shell/frame.h"
#include "tests/ui/headless.h"

using namespace neph;

namespace {

std::string bestOf(std::string_view text) {
    const std::vector<ui::Command> found = ui::findCommands(text, {});
    return found.empty() ? std::string() : std::string(found.front().id());
}

/// Keys as the window system would number them.
class Keys {
  public:
    Keys() {
        int code = 1;
        for (int& key : ImGui::GetIO().KeyMap) key = code++;
    }
    static void press(Headless& gui, ui::Ui& state, ImGuiKey key) {
        for (const bool down : {true, false}) {
            ImGui::GetIO().KeysDown[ImGui::GetIO().KeyMap[key]] = down;
            gui.frame([&] { ui::draw(state); });
        }
    }
};

void type(Headless& gui, ui::Ui& state, const char* text) {
    ImGui::GetIO().AddInputCharactersUTF8(text);
    gui.frame([&] { ui::draw(state); });
}

bool anyPopup() {
    return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

}  // namespace

TEST_CASE("Commands and parameters are found by words of their names, in any order and case") {
    CHECK(bestOf("undo") == "edit.undo");
    CHECK(bestOf("FULL screen") == "view.full_screen");
    CHECK(bestOf("mixing cloud") == "cloud.mixing_scale");
    CHECK(bestOf("sun elev") == "sun.elevation");
    CHECK(bestOf("time.first") == "time.first");
    CHECK(bestOf("no such thing").empty());
}

TEST_CASE("A word that begins a word of the label is better than one within, or elsewhere") {
    CHECK(ui::matchOf("time", "Last time", "Time time.last") == 0);
    CHECK(ui::matchOf("view", "Panels", "View view.panels") == 1);
    CHECK(ui::matchOf("nels", "Panels", "View view.panels") == 2);
    CHECK(ui::matchOf("time panels", "Panels", "View view.panels") == -1);
    CHECK(ui::matchOf("", "Panels", "View") == 0);
}

TEST_CASE("With nothing typed what was run recently comes first, then every action") {
    const std::vector<std::string> recent{"cloud.mixing_scale", "help.sheet"};
    const std::vector<ui::Command> found = ui::findCommands("", recent);
    REQUIRE(found.size() == ui::actions().size() + 1);
    CHECK(found[0].id() == "cloud.mixing_scale");
    CHECK(found[1].id() == "help.sheet");
    CHECK(std::ranges::count(found, "help.sheet", &ui::Command::id) == 1);
}

TEST_CASE("The palette runs what Enter is pressed on, and shows a parameter that is chosen") {
    Headless gui;
    const Keys keys;
    Session session(noReaders());
    ui::Ui state(session);
    const auto frame = [&] { gui.frame([&] { ui::draw(state); }); };
    frame();
    REQUIRE(ui::runAction(state, "help.commands"));
    for (int i = 0; i < 4; ++i) {
        state.next.animates = false;
        frame();
        CHECK(state.next.animates == !ImGui::GetIO().WantTextInput);  // until keys go to its line
    }
    CHECK(anyPopup());
    CHECK(ui::keyIsTaken({ui::Key::h}));
    type(gui, state, "panels");
    CHECK(state.palette.text == "panels");
    Keys::press(gui, state, ImGuiKey_Enter);
    CHECK_FALSE(state.columns.shown);
    CHECK_FALSE(anyPopup());
    CHECK(state.next.animates);  // another frame until keys are commands again
    frame();
    CHECK_FALSE(ui::keyIsTaken({ui::Key::h}));
    state.settings.rightColumn = false;
    ui::runAction(state, "help.commands");
    for (int i = 0; i < 3; ++i) frame();
    type(gui, state, "rain radius");
    Keys::press(gui, state, ImGuiKey_DownArrow);
    CHECK(state.palette.chosen == 1);
    Keys::press(gui, state, ImGuiKey_UpArrow);
    Keys::press(gui, state, ImGuiKey_Enter);
    CHECK(state.columns.shown);
    CHECK(state.settings.rightColumn);
    CHECK(state.fields.find.starts_with("rain."));
    CHECK(state.palette.recent.size() == 2);
}

TEST_CASE("Escape closes the palette and changes nothing") {
    Headless gui;
    const Keys keys;
    Session session(noReaders());
    ui::Ui state(session);
    gui.frame([&] { ui::draw(state); });
    ui::runAction(state, "help.commands");
    for (int i = 0; i < 3; ++i) gui.frame([&] { ui::draw(state); });
    type(gui, state, "light theme");
    Keys::press(gui, state, ImGuiKey_Escape);
    CHECK_FALSE(anyPopup());
    CHECK(state.settings.theme == Theme::dark);
    CHECK(state.palette.recent.empty());
}
