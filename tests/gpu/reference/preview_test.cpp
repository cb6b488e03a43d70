// preview_test.cpp: an image that stands in for that of the renderer, on the screen alone.
#include <doctest/doctest.h>

#include <array>

#include "tests/gpu/images.h"
#include "tests/gpu/scenes.h"

using namespace neph;
using namespace neph::test;

namespace {

constexpr glm::ivec2 kTracedPx{8, 6};

render::FrameInputs tracedInputs(const SpeciesVolume& volume, int view = 0) {
    render::FrameInputs inputs = frame(volume, lookOf(kModes[0]),
                                       views()[static_cast<std::size_t>(view)].pose, kTracedPx, 0);
    inputs.look.engine = groundTruth();
    return inputs;
}

/// Nothing that is ever rendered.
ImageF stripes(glm::ivec2 sizePx) {
    ImageF image{sizePx, {}};
    for (int i = 0; i < sizePx.x * sizePx.y; ++i) {
        image.pixels.emplace_back(i % 2 == 0 ? 0.05f : 0.4f, 0.1f, 0.2f, 1.0f);
    }
    return image;
}

struct Traced {
    SpeciesVolume volume = blobs();
    render::FrameInputs inputs = tracedInputs(volume);
    render::Accumulation image;

    Traced() {
        renderer().setVolume(volume);
        add();
        add();
    }
    void add() { renderer().render(inputs, image); }
};

}  // namespace

TEST_CASE("A preview is on the screen alone, and what is read to be measured is as it was traced") {
    Traced traced;
    const ImageF linear = renderer().readLinear();
    const std::array<ImageF, 2> halves = renderer().readHalves();
    const Image8 display = renderer().readDisplay();
    const unsigned texture = renderer().displayTexture();
    renderer().showPreview(stripes({7, 5}), traced.inputs);
    CHECK(renderer().showsPreview());
    CHECK(renderer().displayTexture() != texture);
    CHECK(renderer().displaySizePx() == glm::ivec2(7, 5));
    CHECK(renderer().readDisplay().size == glm::ivec2(7, 5));
    CHECK(worstDifference(renderer().readLinear(), linear) == 0.0f);
    for (std::size_t i = 0; i < 2; ++i) {
        CHECK(worstDifference(renderer().readHalves()[i], halves[i]) == 0.0f);
    }
    CHECK(worstDifference(renderer().readLayers().value().halfA, halves[0]) == 0.0f);
    renderer().hidePreview();
    CHECK_FALSE(renderer().showsPreview());
    CHECK(renderer().displayTexture() == texture);
    CHECK((renderer().readDisplay().rgba == display.rgba));
}

TEST_CASE("A preview stays while paths of the same scene are added, in whatever size") {
    Traced traced;
    renderer().showPreview(stripes(kTracedPx), traced.inputs);
    const Image8 preview = renderer().readDisplay();
    traced.add();
    CHECK((renderer().readDisplay().rgba == preview.rgba));
    render::FrameInputs finer = traced.inputs;
    finer.sizePx *= 2;
    renderer().render(finer);
    CHECK(renderer().displaySizePx() == kTracedPx);
    CHECK((renderer().readDisplay().rgba == preview.rgba));
    CHECK(renderer().readLinear().size == finer.sizePx);
}

TEST_CASE("A preview has the tones of the look, and goes with the first image of something else") {
    for (const bool otherView : {true, false}) {
        Traced traced;
        renderer().showPreview(stripes(kTracedPx), traced.inputs);
        const Image8 preview = renderer().readDisplay();
        traced.inputs.look.exposureEv += 1.0f;
        renderer().retone(traced.inputs.look);
        CHECK(renderer().showsPreview());
        CHECK(renderer().readDisplay().rgba[4] > preview.rgba[4]);
        CAPTURE(otherView);
        render::FrameInputs other = tracedInputs(traced.volume, otherView ? 1 : 0);
        other.look.exposureEv = traced.inputs.look.exposureEv;
        if (!otherView) other.look.sunElevationDeg += 1.0f;
        renderer().render(other);
        CHECK_FALSE(renderer().showsPreview());
    }
}

TEST_CASE("A preview of other data is not shown") {
    const Traced traced;
    renderer().showPreview(stripes(kTracedPx), traced.inputs);
    renderer().setVolume(traced.volume);
    renderer().render(traced.inputs);
    CHECK_FALSE(renderer().showsPreview());
}

TEST_CASE("A preview that comes while a frame is drawn leaves the frame as it would have been") {
    const SpeciesVolume volume = blobs();
    needContext();
    render::Renderer other{NEPH_TEST_SOURCE_DIR "/shaders"};
    for (const EngineTraits& engine : kEngines) {
        CAPTURE(engine.id);
        render::FrameInputs inputs = tracedInputs(volume);
        inputs.look.engine = engine.engine;
        inputs.look.transport = Transport::translucent;
        if (!engine.groundTruth) inputs.sizePx = {24, 60};  // in several bands
        const ImageF wanted = renderOn(volume, inputs);
        renderer().setVolume(volume);
        int asked = 0;
        renderer().render(inputs, [&](double) {
            ++asked;
            other.showPreview(stripes({5 + asked, 4}), inputs);
            return true;
        });
        CHECK(asked > 0);
        CHECK(worstDifference(renderer().readLinear(), wanted) == 0.0f);
    }
}
