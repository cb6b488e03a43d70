// sun_drag_test.cpp: the sun under the mouse, in the image and on the compass rose.
#include "app/ui/camera/sun_drag.h"

#include <doctest/doctest.h>
#include <imgui.h>

#include <array>
#include <cmath>

#include "app/ui/camera/sun_chart.h"
#include "app/ui/shell/actions.h"
#include "app/ui/shell/context.h"
#include "app/ui/shell/frame.h"
#include "core/camera/camera_moves.h"
#include "core/geo/map_place.h"
#include "core/look/sun.h"
#include "tests/core/fake_series.h"
#include "tests/ui/headless.h"

using namespace neph;

namespace {

constexpr int kEscape = 256;  // any code
constexpr double kAspect = 1280.0 / 720.0;

/// A window that is all image; the camera looks north from 12 degrees above, the sun stands at 5
/// degrees before it.
struct SunFixture {
    Headless gui;
    std::shared_ptr<FakeSeries> series = std::make_shared<FakeSeries>();
    Session session{openFake(series)};
    ui::Ui state{session};
    ImGuiIO& io = ImGui::GetIO();

    explicit SunFixture(bool dated = false) {
        if (dated) {
            series->map = {.projection = "+proj=merc +lon_0=-47.882778 +R=6370000"};
            const auto middle = MapPlace(series->map).positionM({-15.793889, -47.882778});
            REQUIRE(middle);
            series->map.originM = *middle - 4000.0;
            series->firstUtc = utcOfText("2010-03-15T12:10:00Z");
        }
        session.open(std::array<std::string, 1>{NEPH_TEST_SOURCE_DIR}, 0);
        REQUIRE(waitUntilShown(session));
        state.columns.shown = false;
        setSunAngles(look(), 0.0, 5.0);
        session.history.restart(session.document);
        io.KeyMap[ImGuiKey_Escape] = kEscape;
        frame();
    }
    /// As the workbench plays it.
    void frame() {
        state.next.animates = false;
        gui.frame([&] { ui::draw(state); });
        session.history.settle(session.document, ImGui::IsAnyMouseDown(), 1.0);
    }
    void moveTo(glm::vec2 at) {
        io.MousePos = {at.x, at.y};
        frame();
    }
    void press(bool down) {
        io.MouseDown[0] = down;
        frame();
    }
    void escape() {
        io.KeysDown[kEscape] = true;
        frame();
        io.KeysDown[kEscape] = false;
    }
    Look& look() { return session.document.look; }
    ui::PanelContext context() { return ui::contextOf(state); }
    glm::vec2 disc() { return ui::sunInImage(context()).value(); }
    ui::SunChart chart() { return ui::sunChartOf(state.layout().image, session.document.camera); }
    glm::vec2 mark() {
        const SunState sun = sunStateOf(look(), session.where());
        return chart().at(
            {static_cast<double>(sun.azimuthDeg), static_cast<double>(sun.elevationDeg)});
    }
};

}  // namespace

TEST_CASE(
    "The chart over the rose has the zenith in the middle, straight ahead up, and goes back") {
    ui::SunChart chart{.middle = {100.0f, 200.0f}, .radius = 50.0f, .aheadDeg = 90.0};
    CHECK(glm::distance(chart.at({10.0, 90.0}), glm::vec2(100.0f, 200.0f)) < 1e-4f);
    CHECK(glm::distance(chart.at({90.0, 0.0}), glm::vec2(100.0f, 150.0f)) < 1e-4f);
    CHECK(glm::distance(chart.at({180.0, 45.0}), glm::vec2(125.0f, 200.0f)) < 1e-4f);
    CHECK(glm::distance(chart.at({180.0, -18.0}), chart.at({180.0, -60.0})) < 1e-4f);
    for (const bool fromBelow : {false, true}) {
        chart.fromBelow = fromBelow;
        const ui::SkyDirection back = chart.directionAt(chart.at({200.0, 30.0}));
        CHECK(std::abs(std::remainder(back.azimuthDeg - 200.0, 360.0)) < 1e-4);
        CHECK(back.elevationDeg == doctest::Approx(30.0));
    }
    CHECK(chart.at({90.0, 0.0}).y > 200.0f);  // looked at from below
}

TEST_CASE("The nearest place of a path lies between its points, through north as well") {
    const ui::SunChart chart{.middle = {0.0f, 0.0f}, .radius = 100.0f};
    const std::array<SunPathPoint, 2> path{{{3.0, 350.0, 40.0}, {4.0, 10.0, 40.0}}};
    const auto near = ui::nearestOfPath(chart, path, chart.at({0.0, 42.0}));
    REQUIRE(near.has_value());
    CHECK(near->hour == doctest::Approx(3.5));
    CHECK(std::abs(std::remainder(near->direction.azimuthDeg, 360.0)) < 1e-3);
    CHECK(near->distance < 5.0f);
    CHECK_FALSE(ui::nearestOfPath(chart, {}, {0.0f, 0.0f}).has_value());
}

TEST_CASE("A path that passes far below crosses nothing of the chart") {
    // As at the equator at an equinox: from west to east below the feet.
    const ui::SunChart chart{.middle = {0.0f, 0.0f}, .radius = 100.0f};
    const std::array<SunPathPoint, 4> path{
        {{17.0, 270.0, 10.0}, {18.0, 270.0, -20.0}, {19.0, 90.0, -20.0}, {20.0, 90.0, 10.0}}};
    CHECK(ui::joined(path[0], path[1]));
    CHECK_FALSE(ui::joined(path[1], path[2]));
    const auto near = ui::nearestOfPath(chart, path, {-20.0f, 0.0f});
    CHECK(near.value().hour == doctest::Approx(17.0));
}

TEST_CASE("The sun's disc follows the mouse, the camera does not, and all of it is one step") {
    SunFixture f;
    const CameraPose pose = f.session.document.camera;
    const glm::vec2 grip = f.disc() + glm::vec2(5.0f, -4.0f);
    f.moveTo(grip);
    CHECK(f.state.cameraTools.sun.hovered == ui::SunHandle::disc);
    CHECK(ImGui::GetMouseCursor() == ImGuiMouseCursor_Hand);
    f.press(true);
    CHECK(f.look().sunElevationDeg == 5.0f);  // held, not moved
    for (const glm::vec2 by : {glm::vec2(-40.0f, 5.0f), glm::vec2(200.0f, -30.0f)}) {
        f.moveTo(grip + by);
        CHECK(glm::distance(f.disc(), grip + by - glm::vec2(5.0f, -4.0f)) < 0.1f);
    }
    const Camera camera = placeCamera(pose, f.session.shown()->grid, kAspect);
    const glm::dvec2 share = glm::dvec2(f.disc()) / glm::dvec2(1280.0, 720.0);
    const glm::dvec2 ndc{2.0 * share.x - 1.0, 1.0 - 2.0 * share.y};
    CHECK(glm::length(camera.rayDir(ndc) - sunDirWorld(f.look())) < 1e-3);
    f.press(false);
    CHECK(f.session.document.camera == pose);
    CHECK(f.session.history.steps().size() == 1);
    CHECK(f.session.undo());
    CHECK(f.look().sunAzimuthDeg == 0.0f);
    CHECK(f.look().sunElevationDeg == 5.0f);
}

TEST_CASE("Escape returns the sun, and the rest of the drag moves nothing") {
    SunFixture f;
    const Document before = f.session.document;
    const glm::vec2 at = f.disc();
    f.moveTo(at);
    f.press(true);
    f.moveTo(at + glm::vec2(60.0f, 20.0f));
    CHECK(f.look() != before.look);
    f.escape();
    CHECK(f.session.document == before);
    f.moveTo(at + glm::vec2(120.0f, 40.0f));
    f.press(false);
    CHECK(f.session.document == before);
    CHECK(f.session.history.steps().empty());
}

TEST_CASE("Beside the sun, with Shift, in flight and behind the ground the mouse is the camera's") {
    SunFixture f;
    const auto drags = [&f](glm::vec2 from) {
        const Look look = f.look();
        const CameraPose pose = f.session.document.camera;
        f.moveTo(from);
        f.press(true);
        f.moveTo(from + glm::vec2(30.0f, 10.0f));
        f.press(false);
        CHECK(f.look() == look);
        CHECK(f.session.document.camera != pose);
        f.session.document.camera = pose;
    };
    drags(f.disc() + glm::vec2(0.0f, 40.0f));
    f.io.KeyShift = true;
    drags(f.disc());
    f.io.KeyShift = false;
    REQUIRE(ui::runAction(f.state, "camera.fly"));
    drags(f.disc());
    REQUIRE(ui::runAction(f.state, "camera.fly"));
    const glm::vec2 low = f.disc() + glm::vec2(0.0f, 120.0f);
    setSunAngles(f.look(), 0.0, -3.0);
    CHECK_FALSE(ui::sunInImage(f.context()).has_value());
    drags(low);
    f.look().groundVisible = false;
    CHECK(ui::sunInImage(f.context()).has_value());
}

TEST_CASE("On the rose a sun by angles goes anywhere, one by date along the hours of its day") {
    SunFixture f;
    f.moveTo(f.mark());
    CHECK(f.state.cameraTools.sun.hovered == ui::SunHandle::rose);
    f.press(true);
    f.moveTo(f.chart().at({140.0, 50.0}));
    f.press(false);
    // The mouse is at whole pixels.
    const float pixelDeg = 90.0f / f.chart().radius;
    CHECK(std::abs(f.look().sunAzimuthDeg - 140.0f) < pixelDeg / 0.4f);
    CHECK(std::abs(f.look().sunElevationDeg - 50.0f) < pixelDeg);
    f.look().sunSource = SunSource::date;  // 20 May over the southern plains, 22 UTC
    const SunState then = [&f] {
        Look later = f.look();
        later.sunHour = 16.0f;
        return sunStateOf(later, {});
    }();
    f.frame();
    f.moveTo(f.mark());
    f.press(true);
    // Beside the path: the sun stays on it.
    f.moveTo(f.chart().at(
        {static_cast<double>(then.azimuthDeg), static_cast<double>(then.elevationDeg) + 1.0}));
    f.press(false);
    CHECK(f.look().sunSource == SunSource::date);
    CHECK(f.look().sunHour == doctest::Approx(16.0).epsilon(0.01));
    CHECK(f.look().sunDay == 141);
    CHECK(f.session.messages.empty());
    f.state.settings.compass = false;
    f.moveTo(f.mark() + 1.0f);
    CHECK(f.state.cameraTools.sun.hovered == ui::SunHandle::none);
}

TEST_CASE("A sun of the data's date stands by angles once it is dragged, and that is said") {
    SunFixture f(true);
    f.look().sunSource = SunSource::date;
    f.frame();
    f.moveTo(f.mark());
    f.press(true);
    f.press(false);
    CHECK(f.look().sunSource == SunSource::date);  // a click alone does nothing
    // Within reach of the path it is taken to it: two hours on.
    const SunPathPoint on = sunPathOf(f.look(), f.session.where())[4 * 15];
    f.moveTo(f.mark());
    f.press(true);
    f.moveTo(f.chart().at({on.azimuthDeg, on.elevationDeg}) + 2.0f);
    CHECK(f.look().sunSource == SunSource::angles);
    const ui::SkyDirection put{static_cast<double>(f.look().sunAzimuthDeg),
                               static_cast<double>(f.look().sunElevationDeg)};
    const auto near =
        ui::nearestOfPath(f.chart(), sunPathOf(f.look(), f.session.where()), f.chart().at(put));
    CHECK(near.value().distance < 0.1f);
    REQUIRE(f.session.messages.size() == 1);
    CHECK(f.session.messages.back().kind == Message::Kind::note);
    f.escape();
    CHECK(f.look().sunSource == SunSource::date);
    f.press(false);
}
