// camera_test.cpp: the camera under mouse, keys and panel, and led by its path.
#include <doctest/doctest.h>
#include <imgui.h>

#include <array>
#include <chrono>
#include <thread>

#include "app/ui/camera/camera_view.h"
#include "app/ui/shell/actions.h"
#include "app/ui/shell/frame.h"
#include "app/ui/time/path_lead.h"
#include "app/ui/widgets/places.h"
#include "tests/core/fake_series.h"
#include "tests/ui/headless.h"

using namespace neph;

namespace {

/// A window without panels, so that all of it is the image: 8 km x 8 km x 2 km, six times.
struct Fixture {
    Headless gui;
    std::shared_ptr<FakeSeries> series = std::make_shared<FakeSeries>();
    Session session{openFake(series)};
    ui::Ui state{session};
    ImGuiIO& io = ImGui::GetIO();

    explicit Fixture(glm::dvec2 movesM = {}) {
        series->movesM = movesM;
        session.open(std::array<std::string, 1>{NEPH_TEST_SOURCE_DIR}, 0);
        REQUIRE(waitUntilShown(session));
        state.columns.shown = false;
        state.report.time = -1;
        frame();
    }
    void frame() {
        state.next.animates = false;
        gui.frame([&] { ui::draw(state); });
    }
    void hold(char key, bool down) { io.KeysDown[static_cast<int>(key)] = down; }
    CameraPose& pose() { return session.document.camera; }
    glm::dvec3 eye() { return placeCamera(pose(), session.shown()->grid, 1.0).eyeWorld; }
    glm::dvec3 forward() { return placeCamera(pose(), session.shown()->grid, 1.0).forward; }
};

}  // namespace

TEST_CASE("The wheel zooms to what is under the cursor") {
    Fixture f;
    const RegularGrid grid = f.session.shown()->grid;
    const Camera before = placeCamera(f.pose(), grid, 1280.0 / 720.0);
    const glm::dvec2 ndc{0.5, 0.25};
    const double depthM = 1.1 * 8000.0;
    const glm::dvec3 ray = before.rayDir(ndc);
    const glm::dvec3 point = before.eyeWorld + ray * (depthM / glm::dot(ray, before.forward));
    f.io.MousePos = {960.0f, 270.0f};  // three quarters across, three eighths down
    f.frame();
    f.io.MouseWheel = 3.0f;
    f.frame();
    f.io.MouseWheel = 0.0f;
    CHECK(f.pose().distance == doctest::Approx(1.1f * 0.9f * 0.9f * 0.9f));
    const auto after = ndcOf(placeCamera(f.pose(), grid, 1280.0 / 720.0), point);
    REQUIRE(after.has_value());
    CHECK(glm::length(*after - ndc) < 1e-3);
}

TEST_CASE("In flight W moves forwards, Shift faster, a drag looks around and nothing else types") {
    Fixture f;
    const glm::dvec3 start = f.eye();
    f.hold('W', true);
    f.frame();
    CHECK(f.eye() == start);  // not yet
    f.hold('W', false);
    REQUIRE(ui::runChord(f.state, {ui::Key::g}));
    f.hold('W', true);
    f.frame();
    CHECK(f.state.next.animates);
    const glm::dvec3 first = f.eye();
    f.frame();  // 0.1 s at 0.05 of 8 km a second
    CHECK(glm::length(f.eye() - first - f.forward() * 40.0) < 0.05);
    f.io.KeyShift = true;
    const glm::dvec3 second = f.eye();
    f.frame();
    CHECK(glm::length(f.eye() - second - f.forward() * 160.0) < 0.05);
    f.io.KeyShift = false;
    f.io.KeyCtrl = true;  // Ctrl+S is a command
    const glm::dvec3 third = f.eye();
    f.frame();
    CHECK(f.eye() == third);
    CHECK_FALSE(f.state.next.animates);
    f.io.KeyCtrl = false;
    f.hold('W', false);
    f.io.MouseDown[0] = true;
    f.frame();
    f.io.MousePos = {568.0f, 300.0f};  // a tenth of the height to the left
    f.frame();
    f.io.MouseDown[0] = false;
    // The image goes with the hand: the view turns right by a tenth of the field of view.
    CHECK(f.pose().azimuthDeg == doctest::Approx(184.0f));
    CHECK(glm::length(f.eye() - third) < 0.01);
}

TEST_CASE("The right button alone moves nearer; with a key of flight it flies while it is held") {
    Fixture f;
    f.frame();
    f.io.MouseDown[1] = true;
    f.hold('E', true);
    f.frame();
    f.frame();
    CHECK(f.state.cameraTools.fliesHeld);
    const float distance = f.pose().distance;
    f.hold('E', false);
    f.io.MousePos.y += 72.0f;
    f.frame();
    CHECK(f.pose().distance == distance);  // looks up instead
    CHECK(f.pose().elevationDeg == doctest::Approx(8.0f));
    f.io.MouseDown[1] = false;
    f.frame();
    CHECK_FALSE(f.state.cameraTools.fliesHeld);
    f.io.MouseDown[1] = true;
    f.frame();
    f.io.MousePos.y += 72.0f;
    f.frame();
    CHECK(f.pose().distance > distance);
}

TEST_CASE("Actions of the camera look from where they say, and from the ground at the target") {
    Fixture f;
    for (const char* id : {"camera.fit", "camera.north", "camera.east", "camera.south",
                           "camera.west", "camera.plan", "camera.below", "camera.observer"}) {
        CAPTURE(id);
        f.pose() = CameraPose{};
        CHECK(ui::runAction(f.state, id));
        CHECK(f.pose() != CameraPose{});
    }
    const Observer observer = observerOf(f.pose(), f.session.shown()->grid);
    CHECK(observer.heightM == doctest::Approx(1.7).epsilon(1e-2));
    // From below the default camera's eye, 8.6 km south of the middle, to the target 700 m up.
    CHECK(observer.eastM == doctest::Approx(4000.0));
    CHECK(observer.northM == doctest::Approx(4000.0 - 8800.0 * 0.97815).epsilon(1e-3));
    CHECK(observer.azimuthDeg == doctest::Approx(0.0));
    CHECK(observer.elevationDeg == doctest::Approx(4.64).epsilon(1e-2));
    f.pose() = CameraPose{};
    ui::runAction(f.state, "camera.plan");
    CHECK(f.forward().z < -0.99999);
}

TEST_CASE("A path leads the camera, and its own comes back when the path is left") {
    Fixture f;
    Document& document = f.session.document;
    const CameraPose own = document.camera;
    document.path.withTime = true;
    ui::addPathKey(f.session, f.state.playback);
    document.camera.azimuthDeg = 240.0f;
    ui::addPathKey(f.session, f.state.playback);
    REQUIRE(document.path.keys.size() == 2);
    CHECK(document.path.keys[1].atS == 4.0);
    document.camera = own;
    f.state.playback.atS = 2.0;
    ui::leadAlongPath(f.session, f.state.playback);
    CHECK(document.camera.azimuthDeg == doctest::Approx(210.0f));
    CHECK(document.time == 3);  // the fourth of six begins half way
    f.frame();
    CHECK(document.camera.azimuthDeg == doctest::Approx(210.0f));
    f.state.playback.alongPath = false;
    f.frame();
    CHECK(document.camera == own);
    // A hand that moves the camera takes it over where it is.
    f.state.playback.alongPath = f.state.playback.playing = true;
    ui::leadAlongPath(f.session, f.state.playback);
    document.camera.distance = 0.5f;
    f.frame();
    CHECK_FALSE(f.state.playback.alongPath);
    CHECK_FALSE(f.state.playback.playing);
    CHECK(document.camera.distance == 0.5f);
    CHECK(document.camera.azimuthDeg == doctest::Approx(210.0f));
}

TEST_CASE("The Camera panel adds and deletes bookmarks and keys, and goes to them") {
    Fixture f;
    f.state.columns.shown = true;
    f.io.DisplaySize = {1600.0f, 3000.0f};
    ui::wantPlaces(true);
    const auto click = [&](const char* name) {
        const auto where = ui::placeOf(name);
        CAPTURE(name);
        REQUIRE(where.has_value());
        f.io.MousePos = {(where->lower.x + where->upper.x) / 2.0f,
                         (where->lower.y + where->upper.y) / 2.0f};
        f.frame();
        f.io.MouseDown[0] = true;
        f.frame();
        f.io.MouseDown[0] = false;
        f.frame();
        f.frame();
    };
    f.frame();
    f.frame();
    click("group:Camera");
    Document& document = f.session.document;
    const CameraPose start = document.camera;
    click("camera.bookmark");
    click("camera.path_key");
    REQUIRE(document.bookmarks.size() == 1);
    CHECK(document.bookmarks[0].name == "View 1");
    document.camera.distance = 0.4f;
    click("camera.path_key");
    REQUIRE(document.path.keys.size() == 2);
    click("bookmark:0");
    CHECK(document.camera == start);
    click("path.go:1");
    CHECK(document.camera.distance == 0.4f);
    click("path.leave");
    CHECK(document.camera == start);
    click("path.delete:0");
    click("bookmark.delete:0");
    CHECK(document.path.keys.size() == 1);
    CHECK(document.bookmarks.empty());
    ui::wantPlaces(false);
}

TEST_CASE("What lies over the image stays within it, and is switched off one by one") {
    Fixture f;
    const auto vertices = [&] {
        f.frame();
        return ImGui::GetBackgroundDrawList()->VtxBuffer.Size;
    };
    f.state.settings.scaleBar = f.state.settings.compass = f.state.settings.heightRuler = false;
    const int none = vertices();
    for (const char* id : {"camera.scale_bar", "camera.compass", "camera.height_ruler"}) {
        CAPTURE(id);
        REQUIRE(ui::runAction(f.state, id));
        CHECK(vertices() > none);
        REQUIRE(ui::runAction(f.state, id));
        CHECK(vertices() == none);
    }
    f.state.settings.scaleBar = f.state.settings.compass = f.state.settings.heightRuler = true;
    f.state.columns.shown = true;
    f.frame();
    f.frame();
    const ui::Area image = f.state.layout().image;
    int within = 0;
    for (const ImDrawCmd& command : ImGui::GetBackgroundDrawList()->CmdBuffer) {
        if (command.ElemCount == 0) continue;
        CHECK(command.ClipRect.x >= image.lower.x - 1.0f);
        CHECK(command.ClipRect.z <= image.upper.x + 1.0f);
        ++within;
    }
    CHECK(within > 0);
    CHECK(ui::lengthText(999.0) == "999 m");
    CHECK(ui::lengthText(12345.0) == "12.3 km");
    CHECK(ui::lengthText(1.7) == "1.7 m");
}

TEST_CASE("A path that is fixed to the ground keeps the camera while the grid moves under it") {
    Fixture f({4000.0, -1000.0});
    Document& document = f.session.document;
    document.camera.fixedToGround = true;
    const CameraPose own = document.camera;
    document.path.withTime = true;
    ui::addPathKey(f.session, f.state.playback);
    ui::addPathKey(f.session, f.state.playback);
    const auto onGround = [&] { return f.eye() + glm::dvec3(f.session.shown()->grid.movedM, 0.0); };
    const glm::dvec3 start = onGround();
    for (const double atS : {0.0, 2.0, 3.9}) {
        CAPTURE(atS);
        f.state.playback.atS = atS;
        ui::leadAlongPath(f.session, f.state.playback);
        for (int i = 0; i < 10000 && !f.session.shows(document.time); ++i) {
            f.session.poll();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        f.frame();
        CHECK(f.state.playback.alongPath);  // the shift is no hand on the camera
        CHECK(glm::length(onGround() - start) < 0.05);
    }
    CHECK(f.session.shown()->grid.movedM == glm::dvec2(20000.0, -5000.0));
    f.state.playback.alongPath = false;
    f.frame();
    CHECK(document.camera.fixedToGround);
    CHECK(glm::length(onGround() - start) < 0.05);
    CHECK(document.camera.azimuthDeg == own.azimuthDeg);
}
