// moving_grid_test.cpp: while a grid moves, the ground's pattern and the detail noise stay on the
// ground.
#include <doctest/doctest.h>

#include "tests/gpu/images.h"
#include "tests/gpu/scenes.h"

using namespace neph;
using namespace neph::test;

namespace {

SpeciesVolume movedBy(SpeciesVolume volume, glm::dvec2 movedM) {
    volume.grid.movedM = movedM;
    return volume;
}

}  // namespace

TEST_CASE("The ground is seen where it is, whatever grid has moved over it") {
    const SpeciesVolume nothing = uniformVolume({4, 4, 4}, 500.0, 0.0f);
    Look look = lookOf(kModes[2]);
    look.skyModel = SkyModel::atmosphere;
    look.groundSurface = GroundSurface::fields;
    CameraPose pose = views()[0].pose;
    pose.elevationDeg = 60.0f;
    const glm::dvec2 movedM(700.0, -450.0);
    for (const Engine engine : {Engine::march, Engine::slicing}) {
        look.engine = engine;
        render::FrameInputs inputs = frame(nothing, look, pose, {16, 12}, 0);
        const ImageF before = averageOn(nothing, inputs, 1);
        const SpeciesVolume moved = movedBy(nothing, movedM);
        CHECK(worstDifference(averageOn(moved, inputs, 1), before) > 0.01f);
        inputs.camera.eyeWorld -= glm::dvec3(movedM, 0.0);  // of a camera that stayed
        CHECK(worstDifference(averageOn(moved, inputs, 1), before) < 1e-3f);
    }
}

TEST_CASE("Detail noise stays on the ground in every engine") {
    Look look = lookOf(kModes[3]);
    for (SpeciesLook& field : look.species) field.noiseAmount = 1.0f;
    // A tile of noise is four features of 3 cells of 500 m: it repeats every 6 km.
    const SpeciesVolume still = blobs();
    const SpeciesVolume repeated = movedBy(still, {12000.0, -6000.0});
    const SpeciesVolume moved = movedBy(still, {1500.0, 0.0});
    for (const Engine engine : {Engine::march, Engine::slicing, Engine::reference}) {
        CAPTURE(static_cast<int>(engine));
        look.engine = engine;
        const render::FrameInputs inputs = frame(still, look, views()[0].pose, {16, 12}, 0);
        const ImageF before = averageOn(still, inputs, 2);
        CHECK(luminanceError(averageOn(repeated, inputs, 2), before) < 2e-3);
        CHECK(luminanceError(averageOn(moved, inputs, 2), before) > 2e-2);
    }
}
