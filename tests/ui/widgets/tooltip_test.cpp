// tooltip_test.cpp: tooltips stand beside what they explain, and wait for the mouse after a click.
#include <doctest/doctest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <string>

#include "app/ui/widgets/input.h"
#include "tests/ui/headless.h"

using namespace neph;

namespace {

bool shareRoom(const ui::Area& a, const ui::Area& b) {
    return a.lower.x < b.upper.x && b.lower.x < a.upper.x && a.lower.y < b.upper.y &&
           b.lower.y < a.upper.y;
}

/// A button with a long tooltip somewhere in the window of 1280 x 720 pixels.
struct Explained {
    void frames(int count) {
        for (int i = 0; i < count; ++i) {
            gui.frame([&] {
                ImGui::SetNextWindowPos({0.0f, 0.0f});
                ImGui::SetNextWindowSize({1280.0f, 720.0f});
                ImGui::Begin("test", nullptr, ImGuiWindowFlags_NoDecoration);
                ImGui::SetCursorPos({at.x, at.y});
                ImGui::Button("Explained", {120.0f, 20.0f});
                item = ui::lastItem();
                ui::tooltip(words);
                ImGui::End();
            });
        }
    }
    bool shown() const {
        const ImGuiWindow* window = ImGui::FindWindowByName("##Tooltip_00");
        return window != nullptr && window->WasActive && !window->Hidden;
    }
    ui::Area tip() const {
        const ImGuiWindow* window = ImGui::FindWindowByName("##Tooltip_00");
        return {{window->Pos.x, window->Pos.y},
                {window->Pos.x + window->Size.x, window->Pos.y + window->Size.y}};
    }

    Headless gui;
    std::string words = std::string(80, 'x') + "\nand more\nand more";
    glm::vec2 at{0.0f};
    ui::Area item;
};

}  // namespace

TEST_CASE("A tooltip is in the window and covers no part of what it explains") {
    for (const glm::vec2 at : {glm::vec2(0.0f), glm::vec2(1150.0f, 0.0f), glm::vec2(0.0f, 695.0f),
                               glm::vec2(1150.0f, 695.0f), glm::vec2(600.0f, 350.0f)}) {
        CAPTURE(at.x);
        CAPTURE(at.y);
        Explained scene;
        scene.at = at;
        ImGui::GetIO().MousePos = {at.x + 60.0f, at.y + 10.0f};
        scene.frames(4);
        REQUIRE(scene.shown());
        CHECK_FALSE(shareRoom(scene.tip(), scene.item));
        CHECK(scene.tip().lower.x >= 0.0f);
        CHECK(scene.tip().lower.y >= 0.0f);
        CHECK(scene.tip().upper.x <= 1280.0f);
        CHECK(scene.tip().upper.y <= 720.0f);
    }
}

TEST_CASE(
    "Below comes first, beside a menu's line its side, and where nothing fits ImGui's place") {
    Headless gui;
    gui.frame([] {
        const ui::Area item{{100.0f, 100.0f}, {200.0f, 120.0f}};
        const glm::vec2 window(400.0f, 300.0f), mouse(150.0f, 110.0f);
        const auto at = [&](glm::vec2 size, bool sideways) {
            return ui::besideItem(item, size, window, mouse, sideways);
        };
        CHECK(at({50.0f, 40.0f}, false)->y > 120.0f);
        CHECK(at({50.0f, 40.0f}, true)->x > 200.0f);
        CHECK(at({50.0f, 178.0f}, false)->x > 200.0f);   // neither below nor above
        CHECK(at({190.0f, 178.0f}, false)->x > 200.0f);  // nor at the left
        CHECK_FALSE(at({250.0f, 250.0f}, false).has_value());
        CHECK_FALSE(at({500.0f, 40.0f}, false).has_value());
    });
}

TEST_CASE("After a click no tooltip appears until the mouse has moved") {
    Explained scene;
    ImGuiIO& io = ImGui::GetIO();
    scene.at = {600.0f, 350.0f};
    io.MousePos = {650.0f, 360.0f};
    scene.frames(4);
    CHECK(scene.shown());
    io.MouseDown[0] = true;
    scene.frames(2);
    CHECK_FALSE(scene.shown());
    io.MouseDown[0] = false;
    scene.frames(20);
    CHECK_FALSE(scene.shown());
    io.MousePos.x += 1.0f;  // a hand is never quite still
    scene.frames(4);
    CHECK_FALSE(scene.shown());
    io.MousePos.x += 20.0f;
    scene.frames(4);
    CHECK(scene.shown());
}
