// camera_test.cpp: where the eye stands and looks, and what a gesture does to it.
#include "core/camera/camera.h"

#include <doctest/doctest.h>

using namespace neph;

namespace {

// 100 km x 50 km x 20 km, away from the origin.
const RegularGrid kGrid{{100, 50, 40}, {1000.0, 2000.0, 500.0}, {1000.0, 1000.0, 500.0}};

CameraPose levelFromSouth() {
    CameraPose pose;
    pose.target = {0.5f, 0.5f, 0.5f};
    pose.azimuthDeg = 180.0f;
    pose.elevationDeg = 0.0f;
    pose.distance = 1.0f;
    pose.fovDeg = 90.0f;
    return pose;
}

void checkNear(const glm::dvec3& a, const glm::dvec3& b, double toleranceM) {
    CAPTURE(a.x);
    CAPTURE(a.y);
    CAPTURE(a.z);
    CHECK(glm::length(a - b) <= toleranceM);
}

}  // namespace

TEST_CASE("An eye in the south looks north, with east to its right and the zenith up") {
    const Camera camera = placeCamera(levelFromSouth(), kGrid, 2.0);
    checkNear(camera.eyeWorld, {51000.0, 27000.0 - 100000.0, 10500.0}, 0.02);
    checkNear(camera.forward, {0.0, 1.0, 0.0}, 1e-7);
    checkNear(camera.right, {1.0, 0.0, 0.0}, 1e-7);
    checkNear(camera.up, {0.0, 0.0, 1.0}, 1e-7);
    CHECK(camera.tanHalfFovY == doctest::Approx(1.0));
}

TEST_CASE("An eye in the east looks west") {
    CameraPose pose = levelFromSouth();
    pose.azimuthDeg = 90.0f;
    checkNear(placeCamera(pose, kGrid, 1.0).forward, {-1.0, 0.0, 0.0}, 1e-7);
}

TEST_CASE("The eye stands at the elevation of its pose") {
    CameraPose pose = levelFromSouth();
    pose.elevationDeg = 30.0f;
    const Camera camera = placeCamera(pose, kGrid, 1.0);
    CHECK(camera.eyeWorld.z - 10500.0 == doctest::Approx(50000.0));  // sin 30 of 100 km
    CHECK(camera.forward.z == doctest::Approx(-0.5));
}

TEST_CASE("Rays open with the field of view, wider by the aspect") {
    const Camera camera = placeCamera(levelFromSouth(), kGrid, 2.0);
    checkNear(camera.rayDir({0.0, 0.0}), {0.0, 1.0, 0.0}, 1e-7);
    checkNear(camera.rayDir({0.0, 1.0}), glm::normalize(glm::dvec3(0.0, 1.0, 1.0)), 1e-7);
    checkNear(camera.rayDir({1.0, 0.0}), glm::normalize(glm::dvec3(2.0, 1.0, 0.0)), 1e-7);
}

TEST_CASE("The axes of a camera are orthonormal, also straight up and down") {
    for (const float elevation : {-90.0f, -45.0f, 0.0f, 45.0f, 90.0f}) {
        for (const float azimuth : {0.0f, 77.0f, 180.0f, 300.0f}) {
            CAPTURE(elevation);
            CAPTURE(azimuth);
            CameraPose pose;
            pose.elevationDeg = elevation;
            pose.azimuthDeg = azimuth;
            const Camera c = placeCamera(pose, kGrid, 1.0);
            CHECK(glm::length(c.forward) == doctest::Approx(1.0));
            CHECK(glm::length(c.right) == doctest::Approx(1.0));
            CHECK(glm::length(c.up) == doctest::Approx(1.0));
            CHECK(glm::dot(c.right, c.up) == doctest::Approx(0.0));
            CHECK(glm::dot(c.forward, c.up) == doctest::Approx(0.0));
            checkNear(glm::cross(c.right, c.up), -c.forward, 1e-9);
        }
    }
}

TEST_CASE("Orbiting goes round and stops short of the poles") {
    CameraPose pose = levelFromSouth();
    orbit(pose, 270.0f, 0.0f);
    CHECK(pose.azimuthDeg == doctest::Approx(90.0f));
    orbit(pose, -180.0f, 500.0f);
    CHECK(pose.azimuthDeg == doctest::Approx(270.0f));
    CHECK(pose.elevationDeg < 90.0f);
    CHECK(pose.elevationDeg > 89.0f);
}

TEST_CASE("Panning by half an image puts the old target on its edge") {
    CameraPose pose = levelFromSouth();
    const RegularGrid grid{{100, 100, 100}, {0.0, 0.0, 0.0}, {1000.0, 1000.0, 1000.0}};
    const glm::dvec3 target = grid.originM + grid.extentM() * glm::dvec3(pose.target);
    pose.distance = 0.5f;
    pan(pose, grid, {0.5f, 0.0f});  // a drag to the right by half a height
    const Camera camera = placeCamera(pose, grid, 1.0);
    checkNear(glm::normalize(target - camera.eyeWorld), camera.rayDir({1.0, 0.0}), 1e-6);
}

TEST_CASE("Panning keeps distance and direction") {
    CameraPose pose = levelFromSouth();
    const Camera before = placeCamera(pose, kGrid, 1.0);
    pan(pose, kGrid, {0.1f, -0.05f});
    const Camera after = placeCamera(pose, kGrid, 1.0);
    checkNear(after.forward, before.forward, 1e-9);
    CHECK(pose.distance == 1.0f);
}

TEST_CASE("The distance stays within its bounds") {
    CameraPose pose;
    dolly(pose, 0.0f);
    CHECK(pose.distance == kMinDistance);
    dolly(pose, 1e9f);
    CHECK(pose.distance == kMaxDistance);
}

TEST_CASE("The same view in another grid has its eye in the same place, or there is none") {
    const RegularGrid whole{{100, 80, 40}, {0.0, 0.0, 0.0}, {1000.0, 1000.0, 500.0}};
    const RegularGrid part{{30, 40, 20}, {20e3, 30e3, 0.0}, {1000.0, 1000.0, 500.0}};
    CameraPose pose;
    pose.target = {0.4f, 0.5f, 0.2f};
    const auto same = sameView(pose, whole, part);
    REQUIRE(same.has_value());
    const Camera a = placeCamera(pose, whole, 1.5), b = placeCamera(*same, part, 1.5);
    CHECK(glm::length(a.eyeWorld - b.eyeWorld) < 0.1);
    CHECK(glm::length(a.forward - b.forward) < 1e-9);
    const RegularGrid far{{1, 1, 20}, {99e3, 79e3, 0.0}, {1000.0, 1000.0, 500.0}};
    CHECK_FALSE(sameView(pose, whole, far).has_value());
}

TEST_CASE("A camera that is fixed to the ground stays there while the grid moves over it") {
    const glm::dvec2 movedM(22500.0, -5400.0);
    CameraPose pose = levelFromSouth();
    const Camera before = placeCamera(pose, kGrid, 1.0);
    keepOnGround(pose, kGrid, movedM);
    CHECK(pose == levelFromSouth());  // it follows the grid
    pose.fixedToGround = true;
    keepOnGround(pose, kGrid, movedM);
    const Camera after = placeCamera(pose, kGrid, 1.0);
    // World space has moved by as much.
    checkNear(after.eyeWorld + glm::dvec3(movedM, 0.0), before.eyeWorld, 0.02);
    checkNear(after.forward, before.forward, 1e-12);
    keepOnGround(pose, kGrid, -movedM);
    checkNear(placeCamera(pose, kGrid, 1.0).eyeWorld, before.eyeWorld, 0.02);
}

TEST_CASE("A grid may leave a fixed camera far behind, and a pan does not bring it back") {
    CameraPose pose = levelFromSouth();
    pose.fixedToGround = true;
    keepOnGround(pose, kGrid, {500e3, 0.0});
    const CameraPose before = pose;
    CHECK(pose.target.x == doctest::Approx(0.5 - 5.0));
    pan(pose, kGrid, {0.0f, 0.0f});
    CHECK(pose == before);
    keepOnGround(pose, kGrid, {50e6, 0.0});
    CHECK(pose.target.x == -kFarTarget);
}
