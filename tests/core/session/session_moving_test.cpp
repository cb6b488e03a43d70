// session_moving_test.cpp: cameras over a grid that moves over the ground.
#include <doctest/doctest.h>

#include <array>
#include <chrono>
#include <thread>

#include "core/session/session.h"
#include "tests/core/fake_series.h"

using namespace neph;

namespace {

/// Eye of a pose on the ground of the first time, metres.
glm::dvec3 eyeOnGround(const CameraPose& pose, const RegularGrid& grid) {
    return placeCamera(pose, grid, 1.0).eyeWorld + glm::dvec3(grid.movedM, 0.0);
}

glm::dvec3 eyeOf(const Session& session) {
    return eyeOnGround(session.document.camera, session.shown()->grid);
}

bool showTimeOf(Session& session, int time) {
    session.document.time = time;
    for (int i = 0; i < 10000; ++i) {
        session.poll();
        if (session.shows(time)) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
}

struct Moving {
    Moving() {
        series->times = 3;
        series->movesM = {3000.0, -500.0};
        session.open(std::array<std::string, 1>{NEPH_TEST_SOURCE_DIR}, 0);
        REQUIRE(waitUntilShown(session));
    }
    std::shared_ptr<FakeSeries> series = std::make_shared<FakeSeries>();
    Session session{openFake(series)};
};

}  // namespace

TEST_CASE("A camera follows the grid, or stays on the ground where it is fixed to it") {
    Moving moving;
    Session& session = moving.session;
    const CameraPose pose = session.document.camera;
    const glm::dvec3 start = eyeOf(session);
    REQUIRE(showTimeOf(session, 2));
    CHECK(session.shown()->grid.movedM == glm::dvec2(6000.0, -1000.0));
    CHECK(session.document.camera == pose);
    CHECK(glm::length(eyeOf(session) - start - glm::dvec3(6000.0, -1000.0, 0.0)) < 0.01);

    session.document.camera.fixedToGround = true;
    const glm::dvec3 fixed = eyeOf(session);
    for (const int time : {1, 0, 2}) {
        CAPTURE(time);
        REQUIRE(showTimeOf(session, time));
        CHECK(glm::length(eyeOf(session) - fixed) < 0.01);
    }
    CHECK(session.document.camera.azimuthDeg == pose.azimuthDeg);
}

TEST_CASE("Bookmarks, path and history stay on the ground with a fixed camera") {
    Moving moving;
    Session& session = moving.session;
    Document& document = session.document;
    document.camera.fixedToGround = true;
    session.history.commit(document);
    document.bookmarks = {{"here", document.camera}};
    document.path.keys = {{0.0, document.camera}, {4.0, document.camera}};
    document.path.keys[1].pose.fixedToGround = false;  // the first decides
    session.history.commit(document);
    const glm::dvec3 fixed = eyeOf(session);
    REQUIRE(showTimeOf(session, 1));
    session.history.commit(document);
    // The shift is no step of its own: fixed, the lists, the time.
    CHECK(session.history.steps().size() == 3);
    CHECK(session.history.steps().back() == "Time 1 -> 2");
    const RegularGrid& grid = session.shown()->grid;
    CHECK(glm::length(eyeOnGround(document.bookmarks[0].pose, grid) - fixed) < 0.01);
    for (const double atS : {0.0, 2.0, 4.0}) {
        const CameraPose led = poseAt(document.path, grid, atS);
        CHECK(led.fixedToGround);
        CHECK(glm::length(eyeOnGround(led, grid) - fixed) < 0.01);
    }
    REQUIRE(session.undo());
    REQUIRE(showTimeOf(session, document.time));
    CHECK(document.time == 0);
    CHECK(glm::length(eyeOf(session) - fixed) < 0.01);
}
