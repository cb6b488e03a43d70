// yield_test.cpp: what an image of the march that yields to the user leaves behind.
#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>

#include "app/render/renderer.h"
#include "tests/gpu/context.h"
#include "tests/gpu/scenes.h"

using namespace neph;

namespace {

constexpr glm::ivec2 kSizePx{64, 96};

render::FrameInputs marchFrame(const SpeciesVolume& volume) {
    Look look;
    look.engine = Engine::march;
    look.transport = Transport::translucent;
    return test::frame(volume, look, test::views()[0].pose, kSizePx, 0);
}

/// Gives way once the eye has drawn its first band of rows.
Progress afterTheFirstBand() {
    return [](double done) { return done == 0.0; };
}

double meanDifference(const ImageF& a, const ImageF& b) {
    REQUIRE(a.pixels.size() == b.pixels.size());
    double sum = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        sum += static_cast<double>(std::abs(a.pixels[i].g - b.pixels[i].g));
    }
    return sum / static_cast<double>(a.pixels.size());
}

}  // namespace

TEST_CASE("After an image of the march that yielded the next one needs no new light") {
    test::needContext();
    render::Renderer renderer(std::string(NEPH_TEST_SOURCE_DIR) + "/shaders");
    const SpeciesVolume volume = test::blobs();
    renderer.setVolume(volume);
    render::FrameInputs inputs = marchFrame(volume);
    CHECK(renderer.render(inputs).marchedLight);
    inputs.sizePx = {128, 192};
    CHECK_THROWS_AS(renderer.render(inputs, afterTheFirstBand()), Cancelled);
    inputs.camera = placeCamera(test::views()[4].pose, volume.grid, 64.0 / 96.0);
    const render::FrameStats moved = renderer.render(inputs);
    CHECK(moved.marchedEye);
    CHECK_FALSE(moved.marchedLight);
    CHECK_THROWS_AS(renderer.render(marchFrame(volume), afterTheFirstBand()), Cancelled);
    inputs.look.sunElevationDeg += 10.0f;
    CHECK(renderer.render(inputs).marchedLight);
    const ImageF after = renderer.readLinear();
    render::Renderer fresh(std::string(NEPH_TEST_SOURCE_DIR) + "/shaders");
    fresh.setVolume(volume);
    fresh.render(inputs);
    CHECK(meanDifference(after, fresh.readLinear()) == 0.0);
}

TEST_CASE("A further sample that yielded can be asked for again, and the image is no worse") {
    test::needContext();
    render::Renderer renderer(std::string(NEPH_TEST_SOURCE_DIR) + "/shaders");
    const SpeciesVolume volume = test::blobs();
    renderer.setVolume(volume);
    render::FrameInputs inputs = marchFrame(volume);
    inputs.sampling.quality = 0.25f;  // so that samples differ
    const auto average = [&](bool givesWay) {
        render::Accumulation image;
        while (image.samples() < 8) {
            if (givesWay && image.samples() == 5) {
                CHECK_THROWS_AS(renderer.render(inputs, image, afterTheFirstBand()), Cancelled);
                CHECK(image.samples() == 5);
            }
            CHECK(renderer.render(inputs, image).marchedLight == false);
        }
        return renderer.readLinear();
    };
    render::Accumulation before;
    renderer.render(inputs, before);
    renderer.render(inputs, before);  // so that the first of the samples below is drawn again
    const ImageF through = average(false), given = average(true);
    renderer.render(inputs);
    const double ofOne = meanDifference(renderer.readLinear(), through);
    CHECK(ofOne > 0.0);
    CHECK(meanDifference(given, through) < 0.25 * ofOne);
}

TEST_CASE("Light of a first image is computed in full for the next one") {
    test::needContext();
    render::Renderer renderer(std::string(NEPH_TEST_SOURCE_DIR) + "/shaders");
    const SpeciesVolume volume = test::blobs();
    renderer.setVolume(volume);
    render::FrameInputs inputs = marchFrame(volume);
    renderer.render(inputs);
    const ImageF full = renderer.readLinear();
    inputs.draftLight = true;
    CHECK_FALSE(renderer.render(inputs).marchedLight);  // what is finer stays
    inputs.look.sunElevationDeg += 10.0f;
    CHECK(renderer.render(inputs).marchedLight);
    inputs = marchFrame(volume);
    inputs.draftLight = true;
    CHECK(renderer.render(inputs).marchedLight);
    CHECK(meanDifference(renderer.readLinear(), full) > 0.0);
    inputs.draftLight = false;
    CHECK(renderer.render(inputs).marchedLight);
    CHECK(meanDifference(renderer.readLinear(), full) == 0.0);
}
