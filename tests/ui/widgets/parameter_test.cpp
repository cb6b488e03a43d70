// parameter_test.cpp: the widget of a parameter under a mouse and keys that are made up.
#include "app/ui/widgets/parameter_widget.h"

#include <doctest/doctest.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "app/ui/widgets/format.h"
#include "app/ui/widgets/input.h"
#include "app/ui/widgets/places.h"
#include "app/ui/widgets/words.h"
#include "core/base/error.h"
#include "tests/ui/headless.h"

using namespace neph;
using doctest::Approx;

namespace {

/// One parameter in a window of 400 pixels, and hands on it.
struct Bench {
    explicit Bench(const char* id) : row(parameter(id)) {
        ui::wantPlaces(true);
        ImGui::GetIO().KeyMap[ImGuiKey_Enter] = kEnter;
        ImGui::GetIO().KeyMap[ImGuiKey_Escape] = kEscape;
        away();
    }
    ~Bench() { ui::wantPlaces(false); }

    bool frame() {
        bool changed = false;
        ui::clearPlaces();
        gui.frame([&] {
            ImGui::SetNextWindowPos({0.0f, 0.0f});
            ImGui::SetNextWindowSize({400.0f, 100.0f});
            ImGui::Begin("test", nullptr, ImGuiWindowFlags_NoDecoration);
            changed = ui::parameterWidget(row, values, preset);
            ImGui::End();
        });
        return changed;
    }
    void away() {
        io().MousePos = {390.0f, 90.0f};
        frame();
    }
    /// A share of the way across a place.
    ImVec2 at(const std::string& name, float share = 0.5f) {
        const auto where = ui::placeOf(name);
        REQUIRE_MESSAGE(where.has_value(), name);
        return {where->lower.x + share * (where->upper.x - where->lower.x),
                (where->lower.y + where->upper.y) / 2.0f};
    }
    void moveTo(ImVec2 point) {
        io().MousePos = point;
        frame();
    }
    void press(bool down, int button = 0) {
        io().MouseDown[button] = down;
        frame();
    }
    void click(ImVec2 point, int button = 0) {
        moveTo(point);
        press(true, button);
        press(false, button);
    }
    void tap(int key) {
        io().KeysDown[key] = true;
        frame();
        io().KeysDown[key] = false;
        frame();
    }
    void type(const std::string& text) {
        for (const char c : text) io().AddInputCharacter(static_cast<unsigned>(c));
        frame();
    }
    /// Ctrl+click on the slider, then keys.
    void beginTyping() {
        io().KeyCtrl = true;
        click(at(row.id));
        io().KeyCtrl = false;
        for (int i = 0; i < 3; ++i) frame();
    }
    double value() const { return static_cast<double>(std::get<float>(valueOf(values, row))); }
    static ImGuiIO& io() { return ImGui::GetIO(); }

    static constexpr int kEnter = 10, kEscape = 11;
    Headless gui;
    const Parameter& row;
    ParameterSet values;
    Look preset;
};

}  // namespace

TEST_CASE("A drag with Shift moves a tenth as far, on linear and on logarithmic sliders") {
    for (const char* id : {"sun.azimuth", "rain.effective_radius"}) {
        CAPTURE(id);
        std::array<double, 2> moved{};
        for (const bool fine : {false, true}) {
            Bench bench(id);
            const ImVec2 start = bench.at(id);
            bench.moveTo(start);
            bench.press(true);
            const double before = bench.value();
            bench.io().KeyShift = fine;
            bench.moveTo({start.x + 40.0f, start.y});
            const double after = bench.value();
            moved.at(fine ? 1 : 0) =
                bench.row.range.log ? std::log(after / before) : after - before;
            bench.press(false);
            bench.io().KeyShift = false;
        }
        CHECK(moved[0] > 0.0);
        CHECK(moved[1] == Approx(0.1 * moved[0]).epsilon(0.02));
    }
}

TEST_CASE("A press with Shift does not move a slider, one without goes to the mouse") {
    Bench bench("sun.azimuth");
    const ImVec2 there = bench.at("sun.azimuth", 0.9f);
    bench.io().KeyShift = true;
    bench.click(there);
    CHECK((bench.values == ParameterSet{}));
    bench.io().KeyShift = false;
    bench.click(there);
    CHECK(bench.value() > 310.0);
}

TEST_CASE("The wheel over a slider changes nothing") {
    Bench bench("sun.azimuth");
    bench.moveTo(bench.at("sun.azimuth"));
    for (int i = 0; i < 5; ++i) {
        bench.io().MouseWheel = 1.0f;
        bench.frame();
    }
    CHECK((bench.values == ParameterSet{}));
}

TEST_CASE("A typed number is in the units of the screen, with or without the unit") {
    for (const char* text : {"250", " 250 \xC2\xB5m"}) {
        CAPTURE(text);
        Bench bench("rain.effective_radius");
        bench.beginTyping();
        // Input in UTF-8 goes in whole.
        ImGui::GetIO().AddInputCharactersUTF8(text);
        bench.frame();
        bench.tap(Bench::kEnter);
        CHECK(bench.value() == Approx(250e-6).epsilon(1e-6));
    }
}

TEST_CASE("A typed number beyond the range becomes its bound") {
    Bench bench("sun.elevation");
    bench.beginTyping();
    bench.type("4000");
    bench.tap(Bench::kEnter);
    CHECK(bench.value() == 90.0);
}

TEST_CASE("A decimal comma is a point, and what may be thousands is no number") {
    CHECK(ui::withDecimalPoint("0,5") == "0.5");
    CHECK(ui::withDecimalPoint("-12,25") == "-12.25");
    CHECK(ui::withDecimalPoint("0,125") == "0.125");
    CHECK(ui::withDecimalPoint("1500,125") == "1500.125");
    CHECK(ui::withDecimalPoint(",5") == ".5");
    CHECK(ui::withDecimalPoint("2,5e-3") == "2.5e-3");
    for (const char* kept : {"1,000", "12,500", "1,000,000", "1.000,5", "1,000.5", "high", ""}) {
        CHECK(ui::withDecimalPoint(kept) == kept);
    }
    Bench bench("cloud.mixing_scale");
    bench.beginTyping();
    bench.type("0,5");
    bench.tap(Bench::kEnter);
    CHECK(bench.value() == 0.5);
    bench.beginTyping();
    bench.type("1,000");
    bench.tap(Bench::kEnter);
    CHECK(bench.value() == 0.5);
    bench.tap(Bench::kEscape);
    CHECK(bench.value() == 0.5);
}

TEST_CASE("ImGui's own fields for numbers take a decimal comma, and lines of text keep theirs") {
    for (const bool number : {true, false}) {
        CAPTURE(number);
        Headless gui;
        ImGuiIO& io = ImGui::GetIO();
        io.KeyMap[ImGuiKey_Enter] = Bench::kEnter;
        double value = 7.0;
        std::string text;
        const auto frame = [&] {
            gui.frame([&] {
                ui::takeDecimalCommas();
                ImGui::Begin("test");
                if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
                if (number) {
                    ImGui::InputDouble("##number", &value);
                    ui::noteNumberField();
                } else {
                    ImGui::InputText("##text", &text);
                }
                ImGui::End();
            });
        };
        for (int i = 0; i < 4; ++i) frame();
        for (const char c : {'0', ',', '5'}) io.AddInputCharacter(static_cast<unsigned>(c));
        frame();
        for (const bool down : {true, false}) {
            io.KeysDown[Bench::kEnter] = down;
            frame();
        }
        CHECK(value == (number ? 0.5 : 7.0));
        CHECK(text == (number ? "" : "0,5"));
    }
}

TEST_CASE("What is not a number changes nothing, and can be corrected at once; Esc leaves it") {
    Bench bench("sun.elevation");
    bench.beginTyping();
    bench.type("high");
    bench.tap(Bench::kEnter);
    CHECK((bench.values == ParameterSet{}));
    bench.frame();
    bench.type("12");  // typed over what was wrong
    bench.tap(Bench::kEnter);
    CHECK(bench.value() == 12.0);
    bench.beginTyping();
    bench.type("50");
    bench.tap(Bench::kEscape);
    CHECK(bench.value() == 12.0);
}

TEST_CASE("A double click on the label goes back to the preset, the menu there or to the default") {
    Bench bench("cloud.mixing_scale");
    bench.preset.of(Species::cloud).mixingScale = 0.25f;
    bench.values.look.of(Species::cloud).mixingScale = 4.0f;
    const ImVec2 label = bench.at("cloud.mixing_scale:label");
    bench.moveTo(label);
    for (const bool down : {true, false, true, false}) bench.press(down);
    CHECK(bench.value() == 0.25);
    for (const auto& [item, wanted] :
         {std::pair<const char*, double>{"menu.default", 1.0}, {"menu.preset", 0.25}}) {
        bench.click(label, 1);
        bench.frame();
        bench.click(bench.at(item));
        bench.away();
        CHECK(bench.value() == wanted);
    }
}

TEST_CASE("What is not the preset's has a mark, what is has none") {
    Bench bench("cloud.mixing_scale");
    const auto vertices = [&] {
        bench.away();
        return ImGui::GetDrawData()->TotalVtxCount;
    };
    const int plain = vertices();
    bench.preset.of(Species::cloud).mixingScale = 2.0f;  // both default, but the preset has another
    CHECK(vertices() > plain);
    bench.preset = bench.values.look;
    CHECK(vertices() == plain);
}

TEST_CASE("Values are pasted as screens and as --set spell them, and refused with reasons") {
    const Parameter& radius = parameter("rain.effective_radius");
    const auto number = [&](const char* text) {
        return static_cast<double>(std::get<float>(ui::pastedValue(radius, text)));
    };
    CHECK(number("rain.effective_radius=0.0005\n") == Approx(5e-4));
    CHECK(number("500") == Approx(5e-4));
    CHECK(number("500 \xC2\xB5m") == Approx(5e-4));
    CHECK(number("500,5 \xC2\xB5m") == Approx(5.005e-4));
    CHECK_THROWS_AS(number("1,000"), Error);
    CHECK_THROWS_AS(number("red"), Error);
    CHECK_THROWS_AS(number("1e9"), Error);
    CHECK(std::get<glm::vec3>(ui::pastedValue(parameter("sun.colour"), "1,0.5,0")) ==
          glm::vec3(1.0f, 0.5f, 0.0f));
    CHECK(std::get<int>(ui::pastedValue(parameter("view.engine"), "view.engine=slicing")) == 1);
}

TEST_CASE("Sampling, which no preset holds, goes back to the default") {
    Bench bench("view.target_error");
    bench.values.sampling.targetError = 0.1f;
    const ImVec2 label = bench.at("view.target_error:label");
    bench.moveTo(label);
    for (const bool down : {true, false, true, false}) bench.press(down);
    CHECK((bench.values == ParameterSet{}));
    bench.click(label, 1);
    bench.frame();
    CHECK(ui::placeOf("menu.default").has_value());
    CHECK_FALSE(ui::placeOf("menu.preset").has_value());
}
