// camera_moves_test.cpp: what stays where when the eye moves, and what is in the image then.
#include "core/camera/camera_moves.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "core/camera/camera_path_edit.h"

using namespace neph;

namespace {

// 100 km x 50 km x 20 km, away from the origin.
const RegularGrid kGrid{{100, 50, 40}, {1000.0, 2000.0, 500.0}, {1000.0, 1000.0, 500.0}};
const BoxM kAll{{1000.0, 2000.0, 500.0}, {101e3, 52e3, 20500.0}};
const BoxM kClouds{{30e3, 10e3, 2000.0}, {60e3, 20e3, 14e3}};

/// Largest coordinates in the image that a corner of the box has, sideways and upwards.
glm::dvec2 reach(const Camera& camera, const BoxM& box) {
    glm::dvec2 most{0.0};
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p{(corner & 1) != 0 ? box.upperM.x : box.lowerM.x,
                           (corner & 2) != 0 ? box.upperM.y : box.lowerM.y,
                           (corner & 4) != 0 ? box.upperM.z : box.lowerM.z};
        const auto ndc = ndcOf(camera, p);
        REQUIRE(ndc.has_value());
        most = glm::max(most, glm::abs(*ndc));
    }
    return most;
}

}  // namespace

TEST_CASE("A zoom to the cursor leaves what is under it where it is") {
    for (const glm::dvec2 ndc : {glm::dvec2(0.0), glm::dvec2(0.8, -0.6), glm::dvec2(-1.0, 1.0)}) {
        for (const float factor : {0.5f, 0.9f, 1.1f}) {
            CAPTURE(ndc.x);
            CAPTURE(factor);
            CameraPose pose;
            const Camera before = placeCamera(pose, kGrid, 1.6);
            const double depthM = 1.1 * 100e3;
            const glm::dvec3 ray = before.rayDir(ndc);
            const glm::dvec3 point =
                before.eyeWorld + ray * (depthM / glm::dot(ray, before.forward));
            zoomTo(pose, kGrid, ndc, 1.6, factor);
            CHECK(pose.distance == doctest::Approx(1.1f * factor));
            const auto after = ndcOf(placeCamera(pose, kGrid, 1.6), point);
            REQUIRE(after.has_value());
            CHECK(glm::length(*after - ndc) < 1e-5);
        }
    }
}

TEST_CASE("A zoom to the cursor ends at the bounds of distance and target") {
    CameraPose pose;
    for (int i = 0; i < 500; ++i) zoomTo(pose, kGrid, {0.9, 0.9}, 1.6, 0.8f);
    CHECK(pose.distance == kMinDistance);
    for (int i = 0; i < 500; ++i) zoomTo(pose, kGrid, {-1.0, -1.0}, 1.6, 1.3f);
    CHECK(pose.distance == kMaxDistance);
    CHECK(pose.target == TargetLimits{}.nearest(pose.target));
}

TEST_CASE("Flying moves the eye by metres along its own axes, and up along the vertical") {
    CameraPose pose;
    pose.azimuthDeg = 180.0f;  // the eye looks north
    pose.elevationDeg = 0.0f;
    const glm::dvec3 eye = placeCamera(pose, kGrid, 1.0).eyeWorld;
    REQUIRE(fly(pose, kGrid, {1000.0, 200.0, 5000.0}));
    const Camera after = placeCamera(pose, kGrid, 1.0);
    CHECK(glm::length(after.eyeWorld - eye - glm::dvec3(1000.0, 5000.0, 200.0)) < 0.05);
    CHECK(after.forward.y == doctest::Approx(1.0));
    // Through the storm and out on the other side, as far as targets go: 100 domains.
    for (int i = 0; i < 400; ++i) fly(pose, kGrid, {0.0, 0.0, 50e3});
    CHECK(placeCamera(pose, kGrid, 1.0).eyeWorld.y > 90.0 * kGrid.extentM().y);
    CHECK(pose.target == TargetLimits{}.nearest(pose.target));
    const CameraPose end = pose;
    CHECK_FALSE(fly(pose, kGrid, {0.0, 0.0, 50e3}));
    CHECK(pose == end);
}

TEST_CASE("Looking around turns the view and leaves the eye") {
    CameraPose pose;
    pose.distance = 0.2f;
    const glm::dvec3 eye = placeCamera(pose, kGrid, 1.0).eyeWorld;
    REQUIRE(lookAround(pose, kGrid, 30.0f, 20.0f));
    const Camera after = placeCamera(pose, kGrid, 1.0);
    CHECK(glm::length(after.eyeWorld - eye) < 0.05);
    CHECK(pose.azimuthDeg == doctest::Approx(210.0f));   // the view: 30 degrees east of north
    CHECK(pose.elevationDeg == doctest::Approx(-8.0f));  // it was 12 above, now looks 8 up
    CHECK(after.forward.x == doctest::Approx(0.5 * std::cos(8.0 * 3.14159265 / 180.0)));
    for (int i = 0; i < 20; ++i) lookAround(pose, kGrid, 0.0f, 20.0f);
    CHECK(pose.elevationDeg == doctest::Approx(-89.9f));
}

TEST_CASE("An observer becomes a pose and the same observer again, within centimetres") {
    for (const Observer& observer : {Observer{40e3, 12e3, 2.0, 45.0, 15.0, 50.0},
                                     Observer{90e3, 50e3, 1500.0, 271.5, -3.25, 60.0},
                                     Observer{-20e3, -30e3, 2.0, 10.0, 1.0, 40.0},
                                     Observer{51e3, 27e3, 30e3, 0.0, -80.0, 30.0}}) {
        CAPTURE(observer.eastM);
        const auto pose = poseOf(observer, kGrid);
        REQUIRE(pose.has_value());
        const Observer again = observerOf(*pose, kGrid);
        CHECK(std::abs(again.eastM - observer.eastM) < 0.03);
        CHECK(std::abs(again.northM - observer.northM) < 0.03);
        CHECK(std::abs(again.heightM - observer.heightM) < 0.03);
        CHECK(std::abs(again.azimuthDeg - observer.azimuthDeg) < 1e-4);
        CHECK(std::abs(again.elevationDeg - observer.elevationDeg) < 1e-4);
        CHECK(again.fovDeg == observer.fovDeg);
        const Camera camera = placeCamera(*pose, kGrid, 1.0);
        CHECK(camera.forward.z ==
              doctest::Approx(std::sin(observer.elevationDeg * 3.14159265 / 180.0)).epsilon(1e-5));
    }
    // Further away than targets go, and looking away.
    CHECK_FALSE(poseOf({-20000e3, 0.0, 2.0, 270.0, 0.0, 40.0}, kGrid).has_value());
}

TEST_CASE("From every side all of the box is in the image, and fills it but for the margin") {
    for (const double aspect : {0.3, 1.0, 16.0 / 9.0, 4.0}) {
        for (const BoxM& box : {kAll, kClouds}) {
            for (std::size_t i = 0; i < kViewNames.size(); ++i) {
                CAPTURE(aspect);
                CAPTURE(kViewNames[i]);
                const CameraPose pose =
                    viewOf(static_cast<View>(i), CameraPose{}, kGrid, {&box, 1}, aspect);
                const glm::dvec2 most = reach(placeCamera(pose, kGrid, aspect), box);
                CHECK(std::max(most.x, most.y) == doctest::Approx(0.95).epsilon(1e-4));
                CHECK(pose.fovDeg == 40.0f);
            }
        }
    }
}

TEST_CASE("Views look where their names say") {
    const auto forward = [](View view) {
        return placeCamera(viewOf(view, CameraPose{}, kGrid, {&kAll, 1}, 1.5), kGrid, 1.5).forward;
    };
    CHECK(glm::length(forward(View::north) - glm::dvec3(0.0, -1.0, 0.0)) < 1e-6);
    CHECK(glm::length(forward(View::east) - glm::dvec3(-1.0, 0.0, 0.0)) < 1e-6);
    CHECK(glm::length(forward(View::south) - glm::dvec3(0.0, 1.0, 0.0)) < 1e-6);
    CHECK(glm::length(forward(View::west) - glm::dvec3(1.0, 0.0, 0.0)) < 1e-6);
    CHECK(forward(View::plan).z < -0.99999);
    CHECK(forward(View::below).z > 0.99999);
    const Camera plan =
        placeCamera(viewOf(View::plan, CameraPose{}, kGrid, {&kAll, 1}, 1.5), kGrid, 1.5);
    CHECK(plan.up.y > 0.99999);  // north is on top, and east to the right
    CHECK(plan.right.x > 0.99999);
    const CameraPose fitted = viewOf(View::fit, CameraPose{}, kGrid, {&kAll, 1}, 1.5);
    CHECK(fitted.azimuthDeg == 180.0f);
    CHECK(fitted.elevationDeg == 12.0f);
}

TEST_CASE("A point behind the eye is nowhere in the image") {
    const Camera camera = placeCamera(CameraPose{}, kGrid, 1.5);
    CHECK_FALSE(ndcOf(camera, camera.eyeWorld - camera.forward).has_value());
    const auto edge = ndcOf(camera, camera.eyeWorld + camera.rayDir({1.0, -0.5}) * 7e3);
    REQUIRE(edge.has_value());
    CHECK(glm::length(*edge - glm::dvec2(1.0, -0.5)) < 1e-9);
}

TEST_CASE("Keys of a path stay in order however they are put in and moved") {
    CameraPath path;
    CameraPose near, far;
    near.distance = 0.2f;
    far.distance = 2.0f;
    CHECK(insertKey(path, 4.0, far) == 0);
    CHECK(insertKey(path, 0.0, near) == 0);
    CHECK(insertKey(path, 2.0, CameraPose{}) == 1);
    CHECK(insertKey(path, 2.05, near) == 1);  // in the place of the one at 2 s
    REQUIRE(path.keys.size() == 3);
    CHECK(path.keys[1].atS == 2.0);
    CHECK(path.keys[1].pose == near);
    setKeyTime(path, 1, 99.0);
    CHECK(path.keys[1].atS == doctest::Approx(3.9));
    setKeyTime(path, 0, -1.0);
    CHECK(path.keys[0].atS == 0.0);
    swapWithNext(path, 1);
    CHECK(path.keys[1].pose == far);
    CHECK(path.keys[2].pose == near);
    CHECK(path.keys[2].atS == 4.0);
    setDuration(path, 40.0);
    CHECK(path.keys[1].atS == doctest::Approx(39.0));
    CHECK(path.keys[2].atS == doctest::Approx(40.0));
    setDuration(path, 1.0);  // the last two, a second apart, come no closer than 0.1 s
    CHECK(path.keys[2].atS == doctest::Approx(4.0));
    CameraPath full;
    for (int i = 0; i < 1000; ++i) REQUIRE(insertKey(full, i, near).has_value());
    CHECK_FALSE(insertKey(full, 2000.0, near).has_value());
}
