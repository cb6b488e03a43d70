// engines_test.cpp: whatever engines there are, each does at the renderer's seam what its row of
// the table says.
#include <doctest/doctest.h>

#include "core/look/engines.h"
#include "tests/gpu/images.h"
#include "tests/gpu/scenes.h"

using namespace neph;
using namespace neph::test;

namespace {

constexpr glm::ivec2 kSizePx{24, 40};

render::FrameInputs frameOf(const SpeciesVolume& volume, const EngineTraits& engine) {
    render::FrameInputs inputs = frame(volume, lookOf(kModes[3]), views()[0].pose, kSizePx, 0);
    inputs.look.engine = engine.engine;
    return inputs;
}

Stage redoneFor(const render::FrameInputs& inputs) {
    return renderer().render(inputs).redone;
}

}  // namespace

TEST_CASE("A change redoes with every engine what its traits say, and tones nothing but the copy") {
    const SpeciesVolume volume = blobs();
    for (const EngineTraits& engine : kEngines) {
        CAPTURE(std::string(engine.id));
        renderer().setVolume(volume);
        render::FrameInputs inputs = frameOf(volume, engine);
        CHECK(redoneFor(inputs) == Stage::medium);
        CHECK(allFinite(renderer().readLinear()));
        CHECK(redoneFor(inputs) == Stage::resolve);
        inputs.camera = placeCamera(views()[4].pose, volume.grid, 0.6);
        CHECK(redoneFor(inputs) == (engine.lightFollowsCamera ? Stage::light : Stage::eye));
        CHECK(worstDifference(renderer().readLinear(), renderAfresh(volume, inputs)) == 0.0f);
        const ImageF before = renderer().readLinear();
        inputs.look.exposureEv += 1.0f;
        CHECK(renderer().retone(inputs.look).redone == Stage::resolve);
        CHECK(redoneFor(inputs) == Stage::resolve);
        CHECK(worstDifference(renderer().readLinear(), before) == 0.0f);
        CHECK(renderer().readLayers().has_value() == engine.layers);
        CHECK(renderer().gpuBytes() > 0);
    }
}

TEST_CASE("Further frames of an image bring what the sampling of its engine says") {
    const SpeciesVolume volume = blobs();
    for (const EngineTraits& engine : kEngines) {
        CAPTURE(std::string(engine.id));
        const render::FrameInputs inputs = frameOf(volume, engine);
        const ImageF one = renderOn(volume, inputs);
        const float change = worstDifference(averageOn(volume, inputs, 3), one);
        CHECK((change > 0.0f) == (engine.refinement != Refinement::once));
        CHECK(worstDifference(renderOn(volume, inputs), one) == 0.0f);
    }
}

TEST_CASE(
    "A cancelled frame does not count, and an accumulation that begins has nothing of others") {
    const SpeciesVolume volume = blobs();
    for (const EngineTraits& engine : kEngines) {
        CAPTURE(std::string(engine.id));
        const render::FrameInputs inputs = frameOf(volume, engine);
        const ImageF one = renderOn(volume, inputs);
        render::FrameInputs other = inputs;
        other.look.sunElevationDeg += 20.0f;
        render::Accumulation image;
        const Progress cancel = [](double) { return false; };
        CHECK_THROWS_AS(renderer().render(other, image, cancel), Cancelled);
        CHECK(image.samples() == 0);
        renderer().render(inputs, image);
        CHECK(image.samples() == 1);
        CHECK(worstDifference(renderer().readLinear(), one) == 0.0f);
        // Paths run ahead: a further frame may be complete before anybody can cancel it.
        bool cancelled = false;
        try {
            renderer().render(inputs, image, cancel);
        } catch (const Cancelled&) {
            cancelled = true;
        }
        CHECK(image.samples() == (cancelled ? 1 : 2));
        renderer().render(inputs, image);
        CHECK(image.samples() == (cancelled ? 2 : 3));
    }
}
