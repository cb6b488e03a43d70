// beside_test.cpp: a renderer beside another draws the same volume and disturbs nothing.
#include <doctest/doctest.h>

#include <algorithm>
#include <memory>

#include "app/render/renderer.h"
#include "tests/gpu/context.h"
#include "tests/gpu/images.h"
#include "tests/gpu/scenes.h"

using namespace neph;

namespace {

constexpr glm::ivec2 kBesidePx{24, 18};

const std::string kBesideShaders = std::string(NEPH_TEST_SOURCE_DIR) + "/shaders";

render::FrameInputs besideInputs(const SpeciesVolume& volume, Engine engine, glm::ivec2 sizePx) {
    Look look;
    look.engine = engine;
    look.transport = Transport::translucent;
    return test::frame(volume, look, test::views()[0].pose, sizePx, 0);
}

ImageF tracedTwice(render::Renderer& renderer, const SpeciesVolume& volume) {
    const render::FrameInputs inputs = besideInputs(volume, groundTruth(), {8, 6});
    render::Accumulation image;
    renderer.render(inputs, image);
    renderer.render(inputs, image);
    return renderer.readLinear();
}

/// Noise is made once for both.
std::size_t bytesButNoise(const render::Renderer& renderer) {
    std::size_t sum = 0;
    for (const render::MemoryUse& part : renderer.memory()) {
        if (part.name != "noise") sum += part.bytes;
    }
    return sum;
}

}  // namespace

TEST_CASE(
    "A renderer beside another draws what one of its own would, and the other shows what it "
    "did") {
    test::needContext();
    const SpeciesVolume volume = test::blobs();
    render::Renderer first(kBesideShaders);
    first.setVolume(volume);
    const render::FrameInputs inputs = besideInputs(volume, Engine::march, kBesidePx);
    first.render(inputs);
    const ImageF before = first.readLinear();
    const std::size_t bytes = bytesButNoise(first);

    const std::unique_ptr<render::Renderer> beside = first.beside();
    CHECK(beside->gpuBytes() == 0);
    const ImageF reference = tracedTwice(*beside, volume);
    CHECK(beside->gpuBytes() > 0);
    CHECK(test::worstDifference(first.readLinear(), before) == 0.0f);
    CHECK_FALSE(first.render(inputs).marchedEye);
    CHECK(bytesButNoise(first) == bytes);
    CHECK(test::worstDifference(tracedTwice(first, volume), reference) == 0.0f);
}

TEST_CASE("A renderer beside another keeps its volume when the other is given one, or ends") {
    test::needContext();
    const SpeciesVolume volume = test::blobs();
    auto first = std::make_unique<render::Renderer>(kBesideShaders);
    first->setVolume(volume);
    const std::unique_ptr<render::Renderer> beside = first->beside();
    const ImageF before = tracedTwice(*beside, volume);
    SpeciesVolume sky;
    sky.grid.size = glm::ivec3(1);
    first->setVolume(sky);
    CHECK(test::worstDifference(tracedTwice(*beside, volume), before) == 0.0f);
    first.reset();
    CHECK(test::worstDifference(tracedTwice(*beside, volume), before) == 0.0f);
}
