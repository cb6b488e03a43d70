// panels_test.cpp: panels laid out without a window, with a mouse and keys that are made up.
#include <doctest/doctest.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "app/ui/shell/actions.h"
#include "app/ui/shell/frame.h"
#include "app/ui/widgets/parameter_widget.h"
#include "app/ui/widgets/places.h"
#include "core/volume/memory_setting.h"
#include "tests/core/fake_series.h"
#include "tests/ui/headless.h"

using namespace neph;

namespace {

/// A window of 300 pixels at the origin with one parameter in it.
bool drawParameter(Headless& gui, const Parameter& row, ParameterSet& values) {
    bool changed = false;
    gui.frame([&] {
        ImGui::SetNextWindowPos({0.0f, 0.0f});
        ImGui::SetNextWindowSize({300.0f, 100.0f});
        ImGui::Begin("test", nullptr, ImGuiWindowFlags_NoDecoration);
        changed = ui::parameterWidget(row, values, Look{});
        ImGui::End();
    });
    return changed;
}

}  // namespace

TEST_CASE("Drawing a parameter changes nothing while the mouse is elsewhere") {
    Headless gui;
    for (const Parameter& row : parameterTable()) {
        CAPTURE(row.id);
        ParameterSet values;
        for (int i = 0; i < 3; ++i) CHECK_FALSE(drawParameter(gui, row, values));
        CHECK(values == ParameterSet{});
    }
}

TEST_CASE("A drag on a slider sets the parameter of its row alone, within its range") {
    for (const char* id : {"cloud.mixing_scale", "rain.effective_radius", "sun.elevation"}) {
        CAPTURE(id);
        Headless gui;
        const Parameter& row = parameter(id);
        ParameterSet values;
        drawParameter(gui, row, values);
        ImGui::GetIO().MousePos = {220.0f, 18.0f};
        drawParameter(gui, row, values);
        ImGui::GetIO().MouseDown[0] = true;
        for (const float x : {220.0f, 240.0f, 5000.0f}) {
            ImGui::GetIO().MousePos = {x, 18.0f};
            drawParameter(gui, row, values);
        }
        const float value = std::get<float>(valueOf(values, row));
        CHECK(static_cast<double>(value) == doctest::Approx(row.range.hi).epsilon(1e-6));
        ImGui::GetIO().MousePos = {-5000.0f, 18.0f};
        drawParameter(gui, row, values);
        CHECK(static_cast<double>(std::get<float>(valueOf(values, row))) ==
              doctest::Approx(row.range.lo).epsilon(1e-6));
        setValue(values, row, defaultOf(row));
        CHECK(values == ParameterSet{});
    }
}

TEST_CASE("A double click on the label resets to the default") {
    Headless gui;
    const Parameter& row = parameter("cloud.mixing_scale");
    ParameterSet values;
    values.look.of(Species::cloud).mixingScale = 0.25f;
    ImGui::GetIO().MousePos = {30.0f, 18.0f};
    for (const bool down : {false, true, false, true, false}) {
        ImGui::GetIO().MouseDown[0] = down;
        drawParameter(gui, row, values);
    }
    CHECK(values == ParameterSet{});
}

TEST_CASE("All panels are laid out without data, with help, messages and every fold") {
    Headless gui;
    Session session(noReaders());
    ui::Ui state(session);
    state.showHelp = state.showMessages = true;
    session.say(Message::Kind::error, "a fault\n       found: 100 %d");
    const Document before = session.document;
    for (int i = 0; i < 5; ++i) gui.frame([&] { ui::draw(state); });
    CHECK(session.document == before);
    CHECK(ImGui::GetDrawData()->TotalVtxCount > 0);
}

TEST_CASE("The data panel is laid out, and its buttons choose the part of the domain") {
    Headless gui;
    auto series = std::make_shared<FakeSeries>();
    Session session(openFake(series));
    session.setBudget({2000, kSoftwareGpuBytes});  // of 16 KiB: coarsened
    session.open(std::array<std::string, 1>{NEPH_TEST_SOURCE_DIR}, 0);
    REQUIRE(waitUntilShown(session));
    ui::Ui state(session);
    state.settings.dataDetails = true;
    const Document before = session.document;
    for (int i = 0; i < 3; ++i) gui.frame([&] { ui::draw(state); });
    CHECK(session.document == before);
    CHECK_FALSE(session.region().has_value());
    CHECK_FALSE(state.requests.memory.has_value());
    CHECK(ui::runChord(state, {ui::Key::c}));
    REQUIRE(session.region().has_value());
    CHECK(session.region()->lowerM.x > 0.0);
    CHECK(session.region()->lowerM.y == 0.0);  // the margin ends at the domain's border
    CHECK(session.region()->upperM.y == 8000.0);
    gui.frame([&] { ui::draw(state); });
    CHECK(ui::runChord(state, {ui::Key::d, true}));
    CHECK_FALSE(session.region().has_value());
    CHECK_FALSE(ui::runChord(state, {ui::Key::d, true}));
    CHECK(ui::runChord(state, {ui::Key::f, true}));
    CHECK(session.follow);
}

TEST_CASE("The status line says so where the image is not to scale") {
    Headless gui;
    Session session(openFake(std::make_shared<FakeSeries>()));
    ui::Ui state(session);
    ui::wantPlaces(true);
    const auto marked = [&] {
        for (int i = 0; i < 2; ++i) {
            ui::clearPlaces();
            gui.frame([&] { ui::draw(state); });
        }
        return ui::placeOf("status.scale").has_value();
    };
    session.document.look.of(Species::cloud).mixingScale = 0.5f;
    CHECK_FALSE(marked());  // without data there is no scale
    session.open(std::array<std::string, 1>{NEPH_TEST_SOURCE_DIR}, 0);
    REQUIRE(waitUntilShown(session));
    CHECK(marked());
    session.document.look.of(Species::cloud).mixingScale = 1.0f;
    CHECK_FALSE(marked());
    session.document.look.transport = Transport::lowAlbedo;
    CHECK(marked());
    ui::wantPlaces(false);
}

TEST_CASE("The image has what the panels leave of the window, and all of it without them") {
    Headless gui;
    Session session(noReaders());
    ui::Ui state(session);
    gui.frame([&] { ui::draw(state); });
    const PixelBox box = ui::imageBox(state.layout());
    // Letters of 13 pixels: columns of 20, edges of 3/4; the status line of 7/4, and a line of
    // menus with 3 pixels above and below.
    CHECK(box.lower == glm::ivec2(260 + 10, 23));
    CHECK(box.upper == glm::ivec2(1280 - 260 - 10, 720 - 19));
    state.columns.shown = false;
    CHECK(ui::imageBox(state.layout()).size() == glm::ivec2(1280, 720));
    ImGui::GetIO().DisplayFramebufferScale = {2.0f, 2.0f};
    CHECK(ui::imageBox(state.layout()).size() == glm::ivec2(2560, 1440));
    ImGui::GetIO().DisplaySize = {30.0f, 10.0f};
    state.columns.shown = true;
    CHECK(ui::imageBox(state.layout()).size() == glm::ivec2(1, 1));
}

TEST_CASE("A drag on the image orbits, with shift it pans, and the wheel comes nearer") {
    Headless gui;
    Session session(noReaders());
    ui::Ui state(session);
    state.columns.shown = false;
    session.say(Message::Kind::note, "no notice over the image");
    const auto frame = [&] { gui.frame([&] { ui::draw(state); }); };
    ImGuiIO& io = ImGui::GetIO();
    const auto dragBy = [&](float dx, float dy) {
        io.MousePos = {640.0f, 100.0f};
        frame();
        io.MouseDown[0] = true;
        frame();
        io.MousePos = {640.0f + dx, 100.0f + dy};
        frame();
        io.MouseDown[0] = false;
        frame();
    };
    const CameraPose start = session.document.camera;
    dragBy(72.0f, 0.0f);  // a tenth of the height: 18 degrees
    CHECK(session.document.camera.azimuthDeg == doctest::Approx(start.azimuthDeg + 18.0f));
    CHECK(session.document.camera.target == start.target);
    io.KeyShift = true;
    dragBy(0.0f, 72.0f);
    io.KeyShift = false;
    CHECK(session.document.camera.target.z > start.target.z);
    CHECK(session.document.camera.elevationDeg == start.elevationDeg);
    io.MouseWheel = 1.0f;
    frame();
    CHECK(session.document.camera.distance < start.distance);
}

TEST_CASE("A drag that begins on a panel leaves the camera alone") {
    Headless gui;
    Session session(noReaders());
    ui::Ui state(session);
    ImGuiIO& io = ImGui::GetIO();
    const CameraPose start = session.document.camera;
    const auto frame = [&] { gui.frame([&] { ui::draw(state); }); };
    frame();
    io.MousePos = {20.0f, 500.0f};
    frame();
    io.MouseDown[0] = true;
    frame();
    io.MousePos = {640.0f, 300.0f};
    frame();
    frame();
    CHECK(session.document.camera == start);
}

TEST_CASE("No two actions share an id or a chord, and each says what it does") {
    std::set<std::string_view> ids;
    std::set<std::string> chords;
    for (const ui::Action& action : ui::actions()) {
        CAPTURE(action.id);
        CHECK(ids.insert(action.id).second);
        CHECK(action.id.find('.') != std::string_view::npos);
        CHECK_FALSE(action.label.empty());
        CHECK_FALSE(action.help.empty());
        REQUIRE((action.run != nullptr));
        const std::string chord = ui::chordText(action.chord);
        if (!chord.empty()) CHECK(chords.insert(chord).second);
    }
    CHECK(ui::chordText({ui::Key::s, true, true}) == "Ctrl+Shift+S");
    CHECK(ui::chordText({ui::Key::f12}) == "F12");
    CHECK(ui::chordText({ui::Key::pageDown}) == "PageDown");
}

TEST_CASE("Chords act where they are enabled and not otherwise") {
    Session session(noReaders());
    ui::Ui state(session);
    CHECK_FALSE(ui::runChord(state, {ui::Key::z, true}));  // nothing to undo
    session.document.camera.distance = 0.2f;
    session.history.commit(session.document);
    CHECK(ui::runChord(state, {ui::Key::z, true}));
    CHECK(session.document == Document{});
    CHECK(ui::runChord(state, {ui::Key::y, true}));
    CHECK(session.document.camera.distance == 0.2f);
    session.homeCamera.distance = 3.0f;
    CHECK(ui::runChord(state, {ui::Key::r}));
    CHECK(session.document.camera.distance == 3.0f);
    CHECK_FALSE(ui::runChord(state, {ui::Key::right}));  // no data, no times
    CHECK(ui::runChord(state, {ui::Key::h}));
    CHECK(state.showHelp);
    CHECK(ui::runChord(state, {ui::Key::q, true}));
    CHECK(state.requests.quit);
    CHECK_FALSE(ui::runChord(state, {ui::Key::q}));
}
