// camera_path_test.cpp: where the camera is between its keys, and paths as files.
#include "core/camera/camera_path.h"

#include <doctest/doctest.h>

#include <fmt/format.h>
#include <cmath>

#include "core/base/error.h"
#include "core/camera/camera_format.h"
#include "tests/temporary_folder.h"
#include "tests/text.h"

using namespace neph;

namespace {

// 100 km x 50 km x 20 km, away from the origin.
const RegularGrid kGrid{{100, 50, 40}, {1000.0, 2000.0, 500.0}, {1000.0, 1000.0, 500.0}};

CameraPose poseOf(float azimuthDeg, float distance = 1.0f) {
    CameraPose pose;
    pose.azimuthDeg = azimuthDeg;
    pose.distance = distance;
    return pose;
}

glm::dvec3 eyeAt(const CameraPath& path, double atS) {
    return placeCamera(poseAt(path, kGrid, atS), kGrid, 1.0).eyeWorld;
}

/// Two seconds round the storm, then two along with it, then two looking about.
CameraPath threeWays() {
    CameraPath path;
    CameraPose pose = poseOf(150.0f);
    path.keys.push_back({0.0, pose});
    pose.azimuthDeg = 210.0f;
    path.keys.push_back({2.0, pose});
    pose.target += glm::vec3(0.1f, 0.2f, 0.0f);
    path.keys.push_back({4.0, pose});
    // The eye stays and turns right by 40 degrees.
    const glm::dvec3 eye = placeCamera(pose, kGrid, 1.0).eyeWorld;
    pose.azimuthDeg = 250.0f;
    const glm::dvec3 away = compassDirWorld(pose.azimuthDeg, pose.elevationDeg);
    pose.target = glm::vec3((eye - away * 100e3 - kGrid.originM) / kGrid.extentM());
    path.keys.push_back({6.0, pose});
    return path;
}

std::string refusal(const std::string& text) {
    std::vector<std::string> warnings;
    try {
        parseCameraPath(text, "my.json", warnings);
    } catch (const Error& error) {
        return error.message();
    }
    return {};
}

std::string withKeys(const std::string& keys) {
    return R"({"type": "nephoscope-camera-path", "version": 1, "keys": )" + keys + "}";
}

}  // namespace

TEST_CASE("A path passes exactly through its keys and rests before and after them") {
    const CameraPath path = threeWays();
    for (const PathKey& key : path.keys) CHECK(poseAt(path, kGrid, key.atS) == key.pose);
    CHECK(poseAt(path, kGrid, -5.0) == path.keys.front().pose);
    CHECK(poseAt(path, kGrid, 99.0) == path.keys.back().pose);
    CHECK(durationS(path) == 6.0);
    const CameraPath one{{{3.0, poseOf(77.0f)}}, true};
    for (const double atS : {0.0, 3.0, 9.0}) CHECK(poseAt(one, kGrid, atS) == poseOf(77.0f));
    CHECK(poseAt({}, kGrid, 1.0) == CameraPose{});
    CHECK(durationS({}) == 0.0);
}

TEST_CASE("Half way between two keys every number is half way, the azimuth the short way round") {
    CameraPath path{{{1.0, poseOf(350.0f, 0.5f)}, {3.0, poseOf(30.0f, 1.5f)}}, true};
    path.keys[1].pose.fovDeg = 20.0f;
    path.keys[1].pose.elevationDeg = 32.0f;
    const CameraPose half = poseAt(path, kGrid, 2.0);
    CHECK(half.azimuthDeg == doctest::Approx(10.0f));
    CHECK(half.distance == doctest::Approx(1.0f));
    CHECK(half.fovDeg == doctest::Approx(30.0f));
    CHECK(half.elevationDeg == doctest::Approx(22.0f));
    // A path of two keys starts and ends at rest: u²(3 - 2u) is 5/32 after a quarter.
    CHECK(poseAt(path, kGrid, 1.5).azimuthDeg == doctest::Approx(350.0f + 40.0f * 5.0f / 32.0f));
}

TEST_CASE(
    "Round a target that stays, the eye keeps its distance from it; an eye that stays, stays") {
    const CameraPath path = threeWays();
    const glm::dvec3 target{51e3, 27e3, 7500.0};  // the middle, at 0.35 of 20 km above 500 m
    for (const double atS : {0.3, 1.0, 1.5}) {
        CAPTURE(atS);
        const CameraPose pose = poseAt(path, kGrid, atS);
        // Near the next key the way bends into the straight one: within a part in twenty.
        CHECK(glm::length(eyeAt(path, atS) - target) == doctest::Approx(100e3).epsilon(0.05));
        CHECK(pose.distance == doctest::Approx(1.0f));
    }
    const CameraPath round{{{0.0, poseOf(0.0f)}, {1.0, poseOf(90.0f)}, {2.0, poseOf(180.0f)}},
                           true};
    for (const double atS : {0.2, 0.7, 1.0, 1.6}) {
        CAPTURE(atS);
        CHECK(glm::length(eyeAt(round, atS) - target) == doctest::Approx(100e3).epsilon(1e-6));
        CHECK(glm::length(poseAt(round, kGrid, atS).target - CameraPose{}.target) < 1e-5f);
    }
    const glm::dvec3 eye = eyeAt(path, 4.0);
    for (const double atS : {4.5, 5.0, 5.9}) {
        CAPTURE(atS);
        CHECK(glm::length(eyeAt(path, atS) - eye) < 0.1);
    }
}

TEST_CASE("Eye and direction change without a jerk: no jump in place or velocity anywhere") {
    const CameraPath path = threeWays();
    constexpr double kStepS = 1e-2;
    double fastest = 0.0, jump = 0.0;
    for (double atS = -0.5; atS < 6.5; atS += kStepS) {
        const glm::dvec3 a = eyeAt(path, atS - kStepS), b = eyeAt(path, atS);
        const glm::dvec3 c = eyeAt(path, atS + kStepS);
        fastest = std::max(fastest, glm::length(c - b) / kStepS);
        jump = std::max(jump, glm::length(c - 2.0 * b + a) / kStepS);
    }
    // A velocity that jumped would do so by a good part of the fastest, whatever the step.
    CHECK(fastest > 10e3);
    CHECK(jump < 0.05 * fastest);
}

TEST_CASE("No number overshoots the keys on either side of it") {
    CameraPath path;
    const std::array<float, 6> elevations{0.0f, 89.0f, 89.5f, 89.9f, 10.0f, -85.0f};
    const std::array<float, 6> fovs{75.0f, 5.0f, 5.0f, 40.0f, 75.0f, 74.0f};
    for (std::size_t i = 0; i < elevations.size(); ++i) {
        CameraPose pose;
        pose.elevationDeg = elevations[i];
        pose.fovDeg = fovs[i];
        path.keys.push_back({static_cast<double>(i * i), pose});
    }
    for (double atS = 0.0; atS < 25.0; atS += 0.05) {
        const auto i = static_cast<std::size_t>(std::sqrt(atS));
        const CameraPose pose = poseAt(path, kGrid, atS);
        CAPTURE(atS);
        CHECK(pose.elevationDeg >= std::min(elevations[i], elevations[i + 1]) - 1e-4f);
        CHECK(pose.elevationDeg <= std::max(elevations[i], elevations[i + 1]) + 1e-4f);
        CHECK(pose.fovDeg >= std::min(fovs[i], fovs[i + 1]) - 1e-4f);
        CHECK(pose.fovDeg <= std::max(fovs[i], fovs[i + 1]) + 1e-4f);
    }
}

TEST_CASE("Each time of the data is shown for the same share of the path") {
    CameraPath path = threeWays();
    CHECK(timeAt(path, 0.0, 3) == 0);
    CHECK(timeAt(path, 1.99, 3) == 0);
    CHECK(timeAt(path, 2.01, 3) == 1);
    CHECK(timeAt(path, 6.0, 3) == 2);
    CHECK(timeAt(path, 1e9, 3) == 2);
    CHECK(timeAt(path, -1.0, 3) == 0);
    CHECK_FALSE(timeAt(path, 1.0, 0).has_value());
    path.withTime = false;
    CHECK_FALSE(timeAt(path, 1.0, 3).has_value());
}

TEST_CASE("A path is written and read back bit for bit, and nothing is left beside it") {
    const TemporaryFolder folder;
    CameraPath path = threeWays();
    path.keys[1].atS = 0.1 + 0.2;
    path.keys[1].pose.fovDeg = 33.333332f;
    path.withTime = false;
    saveCameraPath(folder / "path.json", path);
    std::vector<std::string> warnings;
    CHECK(loadCameraPath(folder / "path.json", warnings) == path);
    CHECK(warnings.empty());
    CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
    CHECK(parseCameraPath(formatCameraPath({}), "", warnings) == CameraPath{});
    CHECK(formatCamera(CameraPose{}) == R"({"target": [0.5, 0.5, 0.35], "distance": 1.1, )"
                                        R"("azimuth_deg": 180, "elevation_deg": 12, )"
                                        R"("fov_deg": 40})");
    CameraPose fixed;
    fixed.fixedToGround = true;
    CHECK(contains(formatCamera(fixed), R"("fixed_to_ground": true})"));
    CHECK(parseCamera(formatCamera(fixed), "", warnings) == fixed);
    CHECK(warnings.empty());
    fixed.target.x = -7.5f;  // the grid has moved on
    CHECK(parseCamera(formatCamera(fixed), "", warnings) == fixed);
    CHECK_THROWS_AS(parseCamera(R"({"target": [-107.5, 0, 0]})", "", warnings), Error);
    CHECK_THROWS_AS(parseCamera(R"({"fixed_to_ground": 1})", "", warnings), Error);
}

TEST_CASE("What is no path is refused with its name, its key and what was expected") {
    CHECK(contains(refusal("{}"), "no \"type\""));
    CHECK(contains(refusal(R"({"type": "nephoscope-look", "version": 1})"), "nephoscope-camera"));
    CHECK(contains(refusal(R"({"type": "nephoscope-camera-path", "version": 2})"), "version"));
    CHECK(contains(refusal(withKeys("1")), "\"keys\""));
    CHECK(contains(refusal(withKeys("[1]")), "my.json: key 1"));
    CHECK(contains(refusal(withKeys(R"([{"at_s": -1, "camera": {}}])")), "\"at_s\""));
    CHECK(contains(refusal(withKeys(R"([{"at_s": 90000, "camera": {}}])")), "86400"));
    CHECK(contains(refusal(withKeys(R"([{"at_s": 1, "camera": {}}, {"at_s": 1, "camera": {}}])")),
                   "key 2"));
    CHECK(contains(refusal(withKeys(R"([{"at_s": 1, "camera": {"fov_deg": 99}}])")), "fov_deg"));
    CHECK(contains(refusal(withKeys(R"([{"at_s": 1, "camera": {"fov_deg": 1e999}}])")), "JSON"));
    std::string many = "[";
    for (int i = 0; i <= 1000; ++i) {
        many += fmt::format(R"({}{{"at_s": {}, "camera": {{}}}})", i == 0 ? "" : ",", i);
    }
    CHECK(contains(refusal(withKeys(many + "]")), "at most 1000"));
    std::vector<std::string> warnings;
    parseCameraPath(withKeys(R"([{"at_s": 0, "camera": {}, "camra": 1}])"), "my.json", warnings);
    REQUIRE(warnings.size() == 1);
    CHECK(contains(warnings[0], "did you mean \"camera\"?"));
}
