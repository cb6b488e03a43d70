// tiles_test.cpp: parts of an image, several rays per pixel, and images without a backdrop.
#include <doctest/doctest.h>

#include "app/render/frame/tiles.h"
#include "tests/gpu/images.h"
#include "tests/gpu/scenes.h"

using namespace neph;
using namespace neph::test;

namespace {

constexpr glm::ivec2 kWholePx{50, 38};

render::FrameInputs inputsOf(const SpeciesVolume& volume, Engine engine, glm::ivec2 sizePx) {
    Look look = lookOf(kModes[3]);  // per-field phase and noise
    look.engine = engine;
    return frame(volume, look, views().front().pose, sizePx, 48);
}

/// Put together from parts that do not divide it.
ImageF drawTiled(const SpeciesVolume& volume, render::FrameInputs inputs, int samples) {
    constexpr glm::ivec2 kTilePx{17, 13};
    renderer().setVolume(volume);
    ImageF whole{inputs.sizePx, std::vector<glm::vec4>(
                                    static_cast<std::size_t>(inputs.sizePx.x * inputs.sizePx.y))};
    inputs.part = render::ImagePart{inputs.sizePx, {0, 0}};
    for (glm::ivec2& at = inputs.part->lowerPx; at.y < whole.size.y; at.y += kTilePx.y) {
        for (at.x = 0; at.x < whole.size.x; at.x += kTilePx.x) {
            inputs.sizePx = glm::min(kTilePx, whole.size - at);
            render::Accumulation image;
            while (image.samples() < samples) renderer().render(inputs, image);
            const ImageF tile = renderer().readLinear();
            REQUIRE(tile.size == inputs.sizePx);
            for (int y = 0; y < tile.size.y; ++y) {
                const int row = whole.size.y - at.y - tile.size.y + y;  // row 0 is on top
                std::copy_n(tile.pixels.begin() + y * tile.size.x, tile.size.x,
                            whole.pixels.begin() + row * whole.size.x + at.x);
            }
        }
    }
    return whole;
}

glm::dvec3 meanOf(const ImageF& image) {
    glm::dvec3 sum(0.0);
    for (const glm::vec4& pixel : image.pixels) sum += glm::dvec3(pixel);
    return sum / static_cast<double>(image.pixels.size());
}

double linearOf(std::uint8_t encoded) {  // IEC 61966-2-1
    const double x = encoded / 255.0;
    return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

}  // namespace

TEST_CASE("An image in tiles is the image in one, with either engine and all its samples") {
    const SpeciesVolume volume = blobs();
    for (const Engine engine : {Engine::march, Engine::slicing}) {
        CAPTURE(engine);
        const render::FrameInputs inputs = inputsOf(volume, engine, kWholePx);
        const int samples = engine == Engine::march ? 3 : 1;
        const ImageF whole = averageOn(volume, inputs, samples);
        CHECK(worstDifference(whole, drawTiled(volume, inputs, samples)) < 1e-6f);
    }
}

TEST_CASE("A tile's light is that of the tiles before: the march carries it once") {
    const SpeciesVolume volume = blobs();
    render::FrameInputs inputs = inputsOf(volume, Engine::march, {16, 16});
    inputs.part = render::ImagePart{kWholePx, {0, 0}};
    renderer().setVolume(volume);
    CHECK(renderer().render(inputs).marchedLight);
    inputs.part->lowerPx = {16, 0};
    const render::FrameStats second = renderer().render(inputs);
    CHECK_FALSE(second.marchedLight);
    CHECK(second.marchedEye);
}

TEST_CASE("A pixel of several rays is their mean, in light") {
    const SpeciesVolume volume = blobs();
    render::FrameInputs inputs = inputsOf(volume, Engine::march, 3 * kWholePx);
    const ImageF rays = renderOn(volume, inputs);
    inputs.sizePx = kWholePx;
    inputs.supersample = 3;
    const ImageF pixels = renderOn(volume, inputs);
    REQUIRE(pixels.size == kWholePx);
    for (const glm::ivec2 at : {glm::ivec2(0, 0), glm::ivec2(25, 17), glm::ivec2(49, 37)}) {
        glm::vec4 sum(0.0f);
        for (int i = 0; i < 9; ++i) {
            const glm::ivec2 ray = 3 * at + glm::ivec2(i % 3, i / 3);
            sum += rays.pixels[static_cast<std::size_t>(ray.y * rays.size.x + ray.x)];
        }
        const glm::vec4 seen = pixels.pixels[static_cast<std::size_t>(at.y * kWholePx.x + at.x)];
        CHECK(glm::length(seen - sum / 9.0f) < 1e-5f);
    }
    CHECK(worstDifference(pixels, drawTiled(volume, inputs, 1)) < 1e-6f);
}

TEST_CASE(
    "Without a backdrop there is the cloud's own light, and nothing where there is no cloud") {
    const SpeciesVolume volume = blobs();
    for (const Engine engine : {Engine::march, Engine::slicing}) {
        CAPTURE(engine);
        render::FrameInputs inputs = inputsOf(volume, engine, kWholePx);
        inputs.look.toneMap = ToneMap::linear;
        inputs.look.skyIntensity = 0.0f;  // and so a black sky
        inputs.look.groundVisible = false;
        const ImageF overBlack = renderOn(volume, inputs);
        inputs.backdrop = false;
        const ImageF alone = renderOn(volume, inputs);
        CHECK(worstDifference(overBlack, alone) < 1e-6f);
        CHECK(alone.pixels.front() == glm::vec4(0.0f));
        inputs.look.skyIntensity = 5.0f;
        inputs.look.skylight = 0.0f;
        inputs.backdrop = true;
        const ImageF overSky = renderOn(volume, inputs);
        inputs.backdrop = false;
        const ImageF unlitBySky = renderOn(volume, inputs);
        CHECK(unlitBySky.pixels.front() == glm::vec4(0.0f));
        CHECK(meanOf(overSky).b > meanOf(unlitBySky).b + 0.1);
    }
}

TEST_CASE("A transparent image put over black in linear light is the cloud before black") {
    const SpeciesVolume volume = blobs();
    for (const ToneMap toneMap : {ToneMap::linear, ToneMap::filmic}) {
        render::FrameInputs inputs = inputsOf(volume, Engine::march, kWholePx);
        inputs.look.toneMap = toneMap;
        inputs.look.exposureEv = -2.0f;  // no colour above white, which would be clipped
        inputs.look.skyIntensity = 0.0f;
        inputs.look.groundVisible = false;
        renderOn(volume, inputs);
        const Image8 before = renderer().readDisplay();
        inputs.backdrop = false;
        renderer().render(inputs);
        const Image8 cut = renderer().readDisplay();
        double worst = 0.0;
        for (std::size_t i = 0; i < cut.rgba.size(); ++i) {
            const double opacity = cut.rgba[i / 4 * 4 + 3] / 255.0;
            CHECK(before.rgba[i / 4 * 4 + 3] == 255);
            if (i % 4 == 3) continue;
            worst = std::max(worst,
                             std::abs(opacity * linearOf(cut.rgba[i]) - linearOf(before.rgba[i])));
        }
        // A step of colour and half a step of opacity, where a step of 255 is largest: at white.
        CHECK(worst < 2.0 * (linearOf(255) - linearOf(254)));
        CHECK(cut.rgba[3] == 0);
    }
}

TEST_CASE("Tiles are few, fit the GPU, and leave no more on the host than is allowed") {
    constexpr std::size_t kMost = render::kMostTileRays;
    CHECK(render::tileSize({3840, 2160}, 1, 16384, kMost) == glm::ivec2(3840, 2160));
    CHECK(render::tileSize({20000, 10}, 1, 16384, kMost).x == 16384);
    CHECK(render::tileSize({1000, 1000}, 4, 2048, kMost) == glm::ivec2(512, 512));
    for (const glm::ivec2 size :
         {glm::ivec2(65535, 65535), glm::ivec2(1, 65535), glm::ivec2(65535, 1), glm::ivec2(7, 5)}) {
        for (const int n : {1, 4}) {
            const glm::ivec2 tile = render::tileSize(size, n, 16384, kMost);
            CHECK(tile.x >= 1);
            CHECK(tile.y >= 1);
            CHECK(n * tile.x <= 16384);
            CHECK(n * tile.y <= 16384);
            CHECK(static_cast<std::size_t>(tile.x) * static_cast<std::size_t>(tile.y * n * n) <=
                  kMost);
            CHECK(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(tile.y) <= kMost);
        }
    }
}
