// cloudy_air_test.cpp: air in the shadow of clouds and in their light, against paths that meet
// molecules and haze.
#include <doctest/doctest.h>

#include <cmath>

#include "tests/gpu/images.h"
#include "tests/gpu/scenes.h"

using namespace neph;
using namespace neph::test;

namespace {

/// A sheet of cloud over 30 x 30 km.
SpeciesVolume sheet(float cloudKgPerM3) {
    SpeciesVolume volume = uniformVolume({15, 15, 10}, 2000.0, 0.0f);
    for (int y = 0; y < 15; ++y) {
        for (int x = 0; x < 15; ++x) volume.contentKgPerM3[0].at(x, y, 4) = cloudKgPerM3;
    }
    return volume;
}

/// Mean light of an image.
double lightOf(const SpeciesVolume& volume, Engine engine, ReferenceAir air,
               const CameraPose& pose) {
    Look look = lookOf(kModes[1]);
    look.transport = Transport::full;
    look.phaseDisplay = PhaseDisplay::physical;
    look.skyModel = SkyModel::atmosphere;
    look.sunElevationDeg = 40.0f;
    look.visibilityM = 30e3f;
    look.referenceAir = air;
    render::FrameInputs inputs = frame(volume, look, pose, {16, 9}, 0);
    inputs.look.engine = engine;
    const ImageF image = averageOn(volume, inputs, engine == Engine::reference ? 96 : 4);
    double sum = 0.0;
    for (const glm::vec4& p : image.pixels)
        sum += glm::dot(glm::dvec3(p), {0.2126, 0.7152, 0.0722});
    return sum / static_cast<double>(image.pixels.size());
}

}  // namespace

TEST_CASE("Air under a sheet of cloud lies in its shadow, and in what light comes through") {
    // From the ground, level, where all but the horizon is air.
    const CameraPose pose{{0.5f, 0.9f, 0.02f}, 0.6f, 180.0f, 3.0f, 10.0f};
    struct Sheet {
        float kgPerM3;
        double within;  ///< of the traced light
    };
    // A thin sheet sends light from around the sun, of which moments of l = 2 know little.
    for (const Sheet& cloud : {Sheet{1e-5f, 0.3}, Sheet{1e-3f, 0.1}}) {
        CAPTURE(cloud.kgPerM3);
        const SpeciesVolume volume = sheet(cloud.kgPerM3);
        const double march = lightOf(volume, Engine::march, ReferenceAir::traced, pose);
        const double traced = lightOf(volume, Engine::reference, ReferenceAir::traced, pose);
        const double tables = lightOf(volume, Engine::reference, ReferenceAir::tables, pose);
        CAPTURE(march);
        CAPTURE(traced);
        CAPTURE(tables);
        CHECK(std::abs(march - traced) < cloud.within * traced);
        CHECK(std::abs(march - traced) < 0.6 * std::abs(tables - traced));
    }
}
