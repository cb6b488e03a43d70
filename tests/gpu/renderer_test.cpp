// renderer_test.cpp: what a change redoes, that it leaves the image that a fresh renderer gives,
// and what is held for it.
#include "app/render/renderer.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <initializer_list>
#include <vector>

#include "app/gl/objects.h"
#include "tests/gpu/images.h"
#include "tests/gpu/scenes.h"

using namespace neph;
using namespace neph::test;

namespace {

constexpr glm::ivec2 kSizePx{30, 40};  // two bands of rows, between which an image may yield

/// Everything on, at steps that show detail finer than a voxel.
render::FrameInputs marchFrame(const SpeciesVolume& volume) {
    render::FrameInputs inputs = frame(volume, lookOf(kModes[3]), views()[0].pose, kSizePx, 0);
    inputs.look.engine = Engine::march;
    return inputs;
}

struct Redone {
    Stage first;
    bool medium, light, eye;
};

/// Renders, checks what that redid and that the image is that of a renderer without a past.
void checkRedone(const SpeciesVolume& volume, const render::FrameInputs& inputs,
                 const Redone& expected) {
    const render::FrameStats stats = renderer().render(inputs);
    CHECK(static_cast<int>(stats.redone) == static_cast<int>(expected.first));
    CHECK(stats.bakedMedium == expected.medium);
    CHECK(stats.marchedLight == expected.light);
    CHECK(stats.marchedEye == expected.eye);
    CHECK(worstDifference(renderer().readLinear(), renderAfresh(volume, inputs)) == 0.0f);
}

constexpr Redone kResolve{Stage::resolve, false, false, false};
constexpr Redone kEye{Stage::eye, false, false, true};
// Steps say what detail the medium holds: where that changes, it is baked again.
constexpr Redone kLight{Stage::light, false, true, true};
constexpr Redone kEyeAndDetail{Stage::eye, true, false, true};
constexpr Redone kLightAndDetail{Stage::light, true, true, true};
constexpr Redone kMedium{Stage::medium, true, true, true};

/// What the window would show.
std::vector<std::uint8_t> shown(glm::ivec2 sizePx) {
    std::vector<std::uint8_t> rgba(static_cast<std::size_t>(4 * sizePx.x * sizePx.y));
    glGetTextureImage(renderer().displayTexture(), 0, GL_RGBA, GL_UNSIGNED_BYTE,
                      static_cast<GLsizei>(rgba.size()), rgba.data());
    return rgba;
}

}  // namespace

TEST_CASE("A change redoes in the march what its stage says, and the image is as if it were new") {
    const SpeciesVolume volume = blobs();
    renderer().setVolume(volume);
    auto inputs = marchFrame(volume);
    checkRedone(volume, inputs, kMedium);
    CHECK_FALSE(renderer().render(inputs).marchedEye);
    inputs.look.exposureEv += 1.0f;
    checkRedone(volume, inputs, kResolve);
    inputs.camera = placeCamera(views()[4].pose, volume.grid, 0.75);
    checkRedone(volume, inputs, kEye);
    inputs.sampling.quality = 0.5f;  // steps too long for detail below the voxel
    checkRedone(volume, inputs, kEyeAndDetail);
    inputs.look.sunIntensity = 0.5f;
    checkRedone(volume, inputs, kEye);
    inputs.planes = 64;
    checkRedone(volume, inputs, kEyeAndDetail);
    inputs.sizePx = {15, 20};
    checkRedone(volume, inputs, kEye);
    inputs.look.sunElevationDeg = 60.0f;
    checkRedone(volume, inputs, kLightAndDetail);
    inputs.planes = 20;
    checkRedone(volume, inputs, kEyeAndDetail);
    inputs.look.sunAzimuthDeg = 100.0f;
    checkRedone(volume, inputs, kLight);
    inputs.look.of(Species::ice).mixingScale = 2.0f;
    checkRedone(volume, inputs, kMedium);
    inputs.look.noise = false;
    checkRedone(volume, inputs, kMedium);
    inputs.look.of(Species::cloud).visible = false;
    checkRedone(volume, inputs, kMedium);
}

TEST_CASE("A setting of the other engine redoes nothing but the copy") {
    const SpeciesVolume volume = blobs();
    renderer().setVolume(volume);
    auto inputs = marchFrame(volume);
    renderer().render(inputs);
    const ImageF before = renderer().readLinear();
    inputs.look.planes = 17;
    renderer().render(inputs);
    CHECK(worstDifference(renderer().readLinear(), before) == 0.0f);
}

TEST_CASE("Switching engines back and forth gives the images of fresh renderers") {
    const SpeciesVolume volume = blobs();
    auto marched = marchFrame(volume), sliced = marched;
    sliced.look.engine = Engine::slicing;
    sliced.planes = 64;
    const ImageF ofMarch = renderAfresh(volume, marched), ofSlicing = renderAfresh(volume, sliced);
    CHECK(worstDifference(ofMarch, ofSlicing) > 0.0f);
    renderer().setVolume(volume);
    for (int turn = 0; turn < 2; ++turn) {
        renderer().render(marched);
        CHECK(worstDifference(renderer().readLinear(), ofMarch) == 0.0f);
        renderer().render(sliced);
        CHECK(worstDifference(renderer().readLinear(), ofSlicing) == 0.0f);
    }
}

TEST_CASE("Another volume leaves nothing of the one before, larger or smaller") {
    const SpeciesVolume volume = blobs();
    SpeciesVolume part = volume;  // the same grid, less in it
    for (const std::size_t s : {1u, 3u}) part.contentKgPerM3[s] = Array3f(volume.grid.size);
    const SpeciesVolume small = uniformVolume({5, 3, 2}, 1000.0, 1e-6f);
    for (const SpeciesVolume* each :
         std::initializer_list<const SpeciesVolume*>{&volume, &part, &small, &volume}) {
        const auto inputs = marchFrame(*each);
        CHECK(worstDifference(renderOn(*each, inputs), renderAfresh(*each, inputs)) == 0.0f);
    }
}

TEST_CASE("Draft light is redone in full for the next image without, wherever the camera is") {
    const SpeciesVolume volume = blobs();
    renderer().setVolume(volume);
    auto inputs = marchFrame(volume);
    inputs.draftLight = true;
    const render::FrameStats draft = renderer().render(inputs);
    inputs.camera = placeCamera(views()[4].pose, volume.grid, 0.75);
    CHECK_FALSE(renderer().render(inputs).marchedLight);  // in motion the draft will do
    inputs.draftLight = false;
    const render::FrameStats full = renderer().render(inputs);
    CHECK(full.marchedLight);
    CHECK(full.lightSize.z > draft.lightSize.z);
    CHECK(worstDifference(renderer().readLinear(), renderAfresh(volume, inputs)) == 0.0f);
}

TEST_CASE("An image of the march that is cancelled leaves the last one, and the next is right") {
    const SpeciesVolume volume = blobs();
    auto inputs = marchFrame(volume);
    const ImageF whole = renderOn(volume, inputs);
    const std::vector<std::uint8_t> before = shown(kSizePx);
    auto turned = inputs, relit = inputs, thicker = inputs;
    turned.camera = placeCamera(views()[4].pose, volume.grid, 0.75);
    relit.look.sunAzimuthDeg = 90.0f;
    thicker.look.of(Species::ice).mixingScale = 3.0f;
    for (const render::FrameInputs& other : {turned, relit, thicker}) {
        int asked = 0;
        CHECK_THROWS_AS(renderer().render(other, [](double) { return false; }), Cancelled);
        CHECK((shown(kSizePx) == before));
        const Progress atTheSecond = [&asked](double) { return ++asked < 2; };
        CHECK_THROWS_AS(renderer().render(other, atTheSecond), Cancelled);
        CHECK((shown(kSizePx) == before));
        renderer().render(inputs);
        CHECK(worstDifference(renderer().readLinear(), whole) == 0.0f);
        renderer().render(other);
        CHECK(worstDifference(renderer().readLinear(), renderAfresh(volume, other)) == 0.0f);
        renderer().render(inputs);
    }
}

TEST_CASE("Five species with detail take at most sixteen bytes per voxel on the GPU") {
    SpeciesVolume volume = uniformVolume({128, 128, 64}, 500.0, 1e-6f);
    for (std::size_t s = 1; s < 5; ++s) volume.contentKgPerM3[s] = volume.contentKgPerM3[0];
    auto inputs = frame(volume, lookOf(kModes[3]), views()[0].pose, {8, 6}, 0);
    inputs.look.engine = Engine::march;
    renderer().setVolume(volume);
    renderer().render(inputs);
    double bytes = 0.0;
    for (const render::MemoryUse& part : renderer().memory()) {
        INFO(std::string(part.name), " ", part.bytes);
        if (part.ofVoxels) bytes += static_cast<double>(part.bytes);
    }
    CHECK(bytes / static_cast<double>(volume.grid.cellCount()) <= 16.0);
    CHECK(bytes / static_cast<double>(volume.grid.cellCount()) > 10.0);  // the species alone
}
