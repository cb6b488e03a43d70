// layout_test.cpp: where everything stands, at the sizes and scales that people have.
#include "app/ui/panel/layout.h"

#include <doctest/doctest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <array>
#include <set>
#include <string>
#include <thread>

#include "app/ui/shell/actions.h"
#include "app/ui/shell/frame.h"
#include "app/ui/widgets/places.h"
#include "tests/core/fake_series.h"
#include "tests/ui/headless.h"

using namespace neph;

namespace {

struct Window {
    glm::vec2 size;
    float scale;
};
constexpr std::array kWindows{Window{{960.0f, 600.0f}, 1.0f},   Window{{1280.0f, 720.0f}, 1.0f},
                              Window{{1920.0f, 1080.0f}, 1.0f}, Window{{960.0f, 600.0f}, 2.0f},
                              Window{{1280.0f, 720.0f}, 2.0f},  Window{{1920.0f, 1080.0f}, 2.0f}};

/// A session with six times, and panels in a window.
class Scene {
  public:
    Scene() {
        session.open(std::array<std::string, 1>{NEPH_TEST_SOURCE_DIR}, 0);
        REQUIRE(waitUntilShown(session));
    }

    void show(const Window& window) {
        ImGuiIO& io = ImGui::GetIO();
        io.DisplaySize = {window.size.x, window.size.y};
        ui::restyle(window.scale, state.settings);
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
        frames(4);
    }

    void frames(int count) {
        for (int i = 0; i < count; ++i) gui.frame([&] { ui::draw(state); });
    }

    Headless gui;
    Session session{openFake(std::make_shared<FakeSeries>())};
    ui::Ui state{session};
};

bool overlap(const ui::Area& a, const ui::Area& b) {
    return !a.empty() && !b.empty() && a.lower.x < b.upper.x && b.lower.x < a.upper.x &&
           a.lower.y < b.upper.y && b.lower.y < a.upper.y;
}

/// What must neither overlap nor leave the window.
std::array<ui::Area, 8> areasOf(const ui::Layout& layout) {
    return {layout.menu,      layout.left,  layout.leftEdge, layout.image,
            layout.rightEdge, layout.right, layout.time,     layout.status};
}

void checkAreas(const ui::Layout& layout, glm::vec2 size) {
    const std::array<ui::Area, 8> areas = areasOf(layout);
    float covered = 0.0f;
    for (std::size_t i = 0; i < areas.size(); ++i) {
        CAPTURE(i);
        if (!areas[i].empty()) covered += areas[i].size().x * areas[i].size().y;
        CHECK(areas[i].lower.x >= 0.0f);
        CHECK(areas[i].lower.y >= 0.0f);
        CHECK(areas[i].upper.x <= size.x);
        CHECK(areas[i].upper.y <= size.y);
        for (std::size_t k = 0; k < i; ++k) CHECK_FALSE(overlap(areas[i], areas[k]));
    }
    CHECK(covered == doctest::Approx(size.x * size.y));  // nothing is left over
}

/// Nothing outside the display, and no line wider than the panel that it is on.
void checkWindows(glm::vec2 size) {
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
        if (!window->WasActive || window->Hidden || window->RootWindow != window) continue;
        const std::string name = window->Name;
        if (name.starts_with("Debug")) continue;
        CAPTURE(name);
        CHECK(window->Pos.x >= 0.0f);
        CHECK(window->Pos.y >= 0.0f);
        CHECK(window->Pos.x + window->Size.x <= size.x);
        CHECK(window->Pos.y + window->Size.y <= size.y);
        const float room = window->InnerRect.GetWidth() - 2.0f * window->WindowPadding.x;
        // A pair of sliders ends with an empty label, behind a gap.
        CHECK(window->ContentSize.x <= room + ImGui::GetStyle().ItemInnerSpacing.x);
    }
}

/// Nothing is outside the display, and what is taller than its window scrolls.
void checkShown(glm::vec2 size) {
    int shown = 0;
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
        if (!window->WasActive || window->Hidden || window->RootWindow != window) continue;
        const std::string name = window->Name;
        if (name.starts_with("Debug")) continue;
        CAPTURE(name);
        CHECK(window->Pos.x >= 0.0f);
        CHECK(window->Pos.y >= 0.0f);
        CHECK(window->Pos.x + window->Size.x <= size.x);
        CHECK(window->Pos.y + window->Size.y <= size.y);
        // Columns and bars are what other tests are about.
        const bool popup = (window->Flags & ImGuiWindowFlags_Popup) != 0;
        if (name.starts_with("##") && !popup) continue;
        ++shown;
        const ImVec2 room = window->InnerRect.GetSize();
        CHECK(window->ContentSize.x <= room.x - 2.0f * window->WindowPadding.x + 1.0f);
        const bool scrolls = window->ScrollbarY || window->ChildId != 0;
        CHECK((scrolls || window->ContentSize.y <= room.y));
    }
    CHECK(shown > 0);
}

}  // namespace

TEST_CASE("Nothing overlaps and nothing is cut, whatever the window's size and scale") {
    Scene scene;
    for (const Window& window : kWindows) {
        CAPTURE(window.size.x);
        CAPTURE(window.scale);
        for (const bool columns : {true, false}) {
            CAPTURE(columns);
            scene.state.settings.dataDetails = columns;
            scene.state.settings.leftColumn = scene.state.settings.rightColumn = columns;
            scene.show(window);
            const ui::Layout layout = scene.state.layout();
            checkAreas(layout, window.size);
            checkWindows(window.size);
            CHECK(layout.image.size().x >= 0.25f * window.size.x);
            CHECK(layout.image.size().y >= 0.6f * window.size.y);
            CHECK_FALSE(layout.time.empty());
        }
    }
}

TEST_CASE("Where there is no room for both columns, the one opened last has it") {
    Scene scene;
    scene.show({{960.0f, 600.0f}, 2.0f});
    CHECK(scene.state.layout().left.empty());
    CHECK_FALSE(scene.state.layout().right.empty());
    CHECK(ui::runAction(scene.state, "view.left"));
    CHECK_FALSE(scene.state.layout().left.empty());
    CHECK(scene.state.layout().right.empty());
    CHECK(ui::runAction(scene.state, "view.left"));
    CHECK_FALSE(scene.state.settings.leftColumn);
    scene.show({{1920.0f, 1080.0f}, 1.0f});
    CHECK(ui::runAction(scene.state, "view.left"));
    CHECK_FALSE(scene.state.layout().left.empty());
    CHECK_FALSE(scene.state.layout().right.empty());
}

TEST_CASE("A column's edge is dragged to another width, and a click on it closes the column") {
    Scene scene;
    scene.show({{1280.0f, 720.0f}, 1.0f});
    ImGuiIO& io = ImGui::GetIO();
    const auto drag = [&](float from, float to) {
        io.MousePos = {from, 400.0f};
        scene.frames(2);
        io.MouseDown[0] = true;
        scene.frames(2);
        io.MousePos = {to, 400.0f};
        scene.frames(2);
        io.MouseDown[0] = false;
        scene.frames(2);
    };
    const float edge = scene.state.layout().leftEdge.lower.x;
    drag(edge + 5.0f, edge + 65.0f);
    CHECK(scene.state.layout().leftEdge.lower.x == doctest::Approx(edge + 60.0f).epsilon(0.01));
    drag(edge + 65.0f, edge + 65.0f);
    CHECK_FALSE(scene.state.settings.leftColumn);
    CHECK(scene.state.layout().left.empty());
    drag(5.0f, 5.0f);
    CHECK(scene.state.settings.leftColumn);
}

TEST_CASE("Dialogues stay within the window at the largest text") {
    Scene scene;
    const Window large{{1280.0f, 720.0f}, 2.5f};
    const auto within = [&] {
        scene.show(large);
        scene.frames(3);
        checkShown(large.size);
    };
    ui::Ui& ui = scene.state;
    SUBCASE("export") {
        ui.output.open = true;
        within();
    }
    SUBCASE("save a preset") {
        CHECK(ui::runAction(ui, "preset.save_as"));
        within();
    }
    SUBCASE("file browser") {
        ui::browse(ui.settings, ui.sessionDialogs, ui::BrowseFor::data);
        within();
    }
    SUBCASE("recent data") {
        for (int i = 0; i < 12; ++i) ui.settings.recent.push_back("/data/" + std::to_string(i));
        ui.sessionDialogs.showRecent = true;
        within();
    }
    SUBCASE("data that have moved") {
        ui.sessionDialogs.waiting.emplace();
        ui.sessionDialogs.waiting->name = "storm.nephoscope.json";
        for (int i = 0; i < 9; ++i) {
            ui.sessionDialogs.waiting->missing.push_back("/data/of/a/run/wrfout_d01_" +
                                                         std::to_string(i));
        }
        within();
    }
    SUBCASE("an export when the window closes") {
        ui.output.asksToQuit = true;
        within();
    }
    SUBCASE("palette") {
        ui.palette.open = true;
        within();
    }
    SUBCASE("help") {
        ui.showHelp = true;
        within();
    }
    SUBCASE("history and messages") {
        ui.showHistory = ui.showMessages = true;
        within();
    }
}

TEST_CASE("The width of a column is a setting") {
    Scene scene;
    scene.show({{1920.0f, 1080.0f}, 1.0f});
    const float em = ImGui::GetFontSize();
    CHECK(scene.state.layout().left.size().x == doctest::Approx(20.0f * em).epsilon(0.01));
    scene.state.settings.leftColumnEms = 30.0f;
    CHECK(scene.state.layout().left.size().x == doctest::Approx(30.0f * em).epsilon(0.01));
    CHECK(scene.state.layout().right.size().x == doctest::Approx(20.0f * em).epsilon(0.01));
}

TEST_CASE("Fields come first: all six are in sight below one line that says what is open") {
    Scene scene;
    ui::wantPlaces(true);
    const auto draw = [&] {
        for (int i = 0; i < 4; ++i) {
            ui::clearPlaces();
            scene.frames(1);
        }
    };
    const auto click = [&](const char* name) {
        ImGuiIO& io = ImGui::GetIO();
        const auto at = ui::placeOf(name);
        REQUIRE(at.has_value());
        io.MousePos = {(at->lower.x + at->upper.x) / 2.0f, (at->lower.y + at->upper.y) / 2.0f};
        for (const bool down : {false, true, false}) {
            io.MouseDown[0] = down;
            draw();
        }
    };
    scene.show({{1280.0f, 720.0f}, 1.0f});
    draw();
    const float bottom = scene.state.layout().left.upper.y;
    for (int s = 0; s < kSpeciesCount; ++s) {
        const std::string id(info(static_cast<Species>(s)).id);
        CAPTURE(id);
        const auto row = ui::placeOf(id + ".fold");
        REQUIRE(row.has_value());
        CHECK(row->lower.y > 0.0f);
        CHECK(row->upper.y <= bottom);
    }
    CHECK_FALSE(ui::placeOf("data.memory").has_value());
    click("data.header");
    CHECK(scene.state.settings.dataDetails);
    CHECK(ui::placeOf("data.memory").has_value());
    click("data.header");
    CHECK_FALSE(scene.state.settings.dataDetails);
    CHECK_FALSE(ui::placeOf("data.memory").has_value());
    ui::wantPlaces(false);
}

TEST_CASE("Every action stands in the menu that it names, once, and can be reached by mouse") {
    Scene scene;
    ui::wantPlaces(true);
    scene.show({{1920.0f, 1080.0f}, 1.0f});
    ImGuiIO& io = ImGui::GetIO();
    for (int i = 0; i < ui::kMenuCount; ++i) {
        const auto menu = static_cast<ui::Menu>(i);
        const std::string name = "menu:" + std::string(ui::menuName(menu));
        CAPTURE(name);
        const std::optional<ui::Area> bar = ui::placeOf(name);
        REQUIRE(bar.has_value());
        io.MousePos = {(bar->lower.x + bar->upper.x) / 2.0f, (bar->lower.y + bar->upper.y) / 2.0f};
        scene.frames(2);
        for (const bool down : {true, false, false}) {
            io.MouseDown[0] = down;
            ui::clearPlaces();
            scene.frames(1);
        }
        for (const ui::Action& action : ui::actions()) {
            const bool shown = ui::placeOf(action.id).has_value();
            if (action.menu == menu) CHECK_MESSAGE(shown, std::string(action.id));
        }
        checkWindows({1920.0f, 1080.0f});
        io.MouseDown[0] = true;  // closes it
        scene.frames(1);
        io.MouseDown[0] = false;
        scene.frames(2);
    }
    ui::wantPlaces(false);
    ui::clearPlaces();
}

TEST_CASE("The sheet of keys fits the smallest window") {
    Scene scene;
    scene.state.showHelp = true;
    scene.show({{960.0f, 600.0f}, 1.0f});
    const ImGuiWindow* sheet = ImGui::FindWindowByName("Mouse and keys");
    REQUIRE(sheet != nullptr);
    CHECK(sheet->Size.x <= 960.0f);
    CHECK(sheet->Size.y <= 600.0f);
    CHECK(sheet->ScrollMax.x == 0.0f);
    CHECK(sheet->ScrollMax.y == 0.0f);
}

TEST_CASE("Playing through the times steps them as they come in, and the last stays in a series") {
    Scene scene;
    scene.show({{1280.0f, 720.0f}, 1.0f});
    scene.state.playback.loop = false;
    scene.state.playback.timesPerSecond = 20.0;  // a frame of the test takes 0.1 s
    REQUIRE(ui::runAction(scene.state, "time.play"));
    std::set<int> seen;
    for (int i = 0; i < 2000 && scene.state.playback.playing; ++i) {
        scene.frames(1);
        scene.session.poll();
        if (scene.session.shows(scene.session.document.time)) {
            seen.insert(scene.session.document.time);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    CHECK_FALSE(scene.state.playback.playing);
    CHECK((seen == std::set{1, 2, 3, 4, 5}));  // it began at 0
    CHECK(scene.session.document.time == 5);
}
