// traced_air_test.cpp: paths that meet molecules and haze, against closed forms and the tables of
// clear air.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "app/render/engines/reference/trace_meter.h"
#include "tests/gpu/images.h"
#include "tests/gpu/scenes.h"

using namespace neph;
using namespace neph::test;
using render::Detector;
using render::DetectorKind;
using render::MeterScene;

namespace {

/// Air of 20 km around a cloud of optical depth 2, under a sky as bright everywhere.
MeterScene airyScene() {
    MeterScene scene;
    scene.size = {10, 10, 20};
    scene.spacingM = glm::dvec3(1000.0);
    scene.periodic = false;
    scene.sunIrradiance = 0.0;
    scene.skyRadiance = 1.0;
    render::MeterField cloud{Array3f(scene.size, 0.0f), 1.0, {.kind = PhaseKind::rayleigh}};
    for (int y = 3; y < 7; ++y) {
        for (int x = 3; x < 7; ++x) cloud.extinctionPerM.at(x, y, 4) = 2e-3f;
    }
    scene.fields.push_back(cloud);
    scene.air = AirBands{.moleculesPerM = {6e-6, 12e-6, 28e-6},
                         .hazePerM = {2.3e-4, 2.8e-4, 3.7e-4},
                         .moleculesHeightM = 8400.0,
                         .hazeHeightM = 1200.0,
                         .hazeAlbedo = 1.0};
    return scene;
}

Detector radianceAt(glm::dvec3 atM, glm::dvec3 towards) {
    return {DetectorKind::radiance, {atM, atM}, towards};
}

render::TraceMeter& meter() {
    needContext();
    static render::TraceMeter instance{NEPH_TEST_SOURCE_DIR "/shaders"};
    return instance;
}

double meanLight(const ImageF& image) {
    double sum = 0.0;
    for (const glm::vec4& p : image.pixels)
        sum += glm::dot(glm::dvec3(p), {0.2126, 0.7152, 0.0722});
    return sum / static_cast<double>(image.pixels.size());
}

/// Mean light of an image of paths.
double lightIn(const SpeciesVolume& volume, const Look& base, const CameraPose& pose, int paths) {
    render::FrameInputs inputs = frame(volume, base, pose, {12, 9}, 0);
    inputs.look.engine = Engine::reference;
    return meanLight(averageOn(volume, inputs, paths));
}

Look lookInAir(ReferenceAir air, float sunElevationDeg) {
    Look look = plainLook();
    look.skyModel = SkyModel::atmosphere;
    look.sunElevationDeg = sunElevationDeg;
    look.referenceAir = air;
    return look;
}

}  // namespace

TEST_CASE("Air and cloud that absorb nothing are invisible under a sky as bright everywhere") {
    const std::vector<Detector> detectors{
        radianceAt({5000.0, 5000.0, 10.0}, {1.0, 0.0, 0.01}),
        radianceAt({1000.0, 5000.0, 3000.0}, {0.6, 0.1, 0.3}),
        radianceAt({5000.0, 5000.0, 19000.0}, {0.0, 0.1, -1.0}),
        {DetectorKind::flux, {{4000.0, 4000.0, 100.0}, {6000.0, 6000.0, 100.0}}, {0.0, 0.0, 1.0}}};
    const auto measured = meter().measure(airyScene(), detectors, {.samples = 60000});
    for (std::size_t i = 0; i < detectors.size(); ++i) {
        CAPTURE(i);
        const double expected = detectors[i].kind == DetectorKind::flux ? std::numbers::pi : 1.0;
        CHECK(measured[i].sigma < 0.01 * expected);
        CHECK(std::abs(measured[i].mean - expected) < 4.0 * measured[i].sigma);
    }
}

TEST_CASE("Light that comes through absorbing haze is what its column leaves") {
    MeterScene scene = airyScene();
    scene.fields[0].extinctionPerM = Array3f(scene.size, 0.0f);
    scene.air->moleculesPerM = glm::dvec3(0.0);
    scene.air->hazeAlbedo = 0.0;
    const double perM = scene.air->hazePerM.g, heightM = scene.air->hazeHeightM;
    // Level, up to the top and down to the bottom.
    const std::vector<Detector> detectors{
        radianceAt({2000.0, 5000.0, 500.0}, {1.0, 0.0, 0.0}),
        radianceAt({5000.0, 5000.0, 100.0}, {0.1, 0.0, std::sqrt(0.99)}),
        radianceAt({5000.0, 5000.0, 3000.0}, {0.0, 0.6, -0.8})};
    const double sine = std::sqrt(0.99);
    const double depths[3] = {
        perM * 8000.0 * std::exp(-500.0 / heightM),
        perM * heightM / sine * (std::exp(-100.0 / heightM) - std::exp(-20000.0 / heightM)),
        perM * heightM / 0.8 * (1.0 - std::exp(-3000.0 / heightM))};
    const auto measured = meter().measure(scene, detectors, {.samples = 60000});
    for (std::size_t i = 0; i < detectors.size(); ++i) {
        CAPTURE(i);
        CHECK(std::abs(measured[i].mean - std::exp(-depths[i])) < 4.0 * measured[i].sigma);
        CHECK(measured[i].sigma < 0.01);
    }
}

/// In the tables light that is scattered twice and more comes from all directions alike, and part
/// of what haze scatters forwards counts as not scattered. They are up to a tenth too dark, most
/// from above with a low sun. docs/sky.md
constexpr double kWithin = 0.12;

TEST_CASE("Without clouds traced air sends what the tables of air have") {
    const SpeciesVolume nothing = uniformVolume({15, 15, 10}, 2000.0, 0.0f);
    struct Scene {
        const char* name;
        float sunElevationDeg;
        CameraPose pose;
    };
    const CameraPose across{{0.5f, 0.5f, 0.3f}, 1.5f, 180.0f, 2.0f, 40.0f};
    const CameraPose up{{0.5f, 0.5f, 0.2f}, 0.1f, 180.0f, -50.0f, 40.0f};
    const CameraPose down{{0.5f, 0.5f, 0.0f}, 1.5f, 180.0f, 60.0f, 40.0f};
    for (const Scene& scene :
         {Scene{"across", 35.0f, across}, Scene{"up", 35.0f, up}, Scene{"down", 35.0f, down},
          Scene{"across", 5.0f, across}, Scene{"up", 5.0f, up}, Scene{"down", 5.0f, down}}) {
        CAPTURE(scene.name);
        CAPTURE(scene.sunElevationDeg);
        const double tables =
            lightIn(nothing, lookInAir(ReferenceAir::tables, scene.sunElevationDeg), scene.pose, 1);
        const double traced = lightIn(
            nothing, lookInAir(ReferenceAir::traced, scene.sunElevationDeg), scene.pose, 64);
        const double off = traced / tables - 1.0;
        CAPTURE(off);
        CHECK(std::abs(off) < kWithin);
        CHECK(traced != tables);
    }
}

TEST_CASE("Under a cloud traced air lies in its shadow") {
    SpeciesVolume volume = uniformVolume({15, 15, 10}, 2000.0, 0.0f);
    for (int y = 0; y < 15; ++y) {
        for (int x = 0; x < 15; ++x) volume.contentKgPerM3[0].at(x, y, 4) = 1e-3f;
    }
    // From the ground, level.
    const CameraPose pose{{0.5f, 0.9f, 0.02f}, 0.6f, 180.0f, 1.0f, 10.0f};
    const double tables = lightIn(volume, lookInAir(ReferenceAir::tables, 40.0f), pose, 64);
    const double traced = lightIn(volume, lookInAir(ReferenceAir::traced, 40.0f), pose, 64);
    CHECK(traced < 0.85 * tables);
    CHECK(traced > 0.1 * tables);
}
