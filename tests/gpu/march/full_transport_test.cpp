// full_transport_test.cpp: light scattered any number of times, against the path tracer and closed
// forms.
#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "tests/gpu/images.h"
#include "tests/gpu/scenes.h"

using namespace neph;
using namespace neph::test;

namespace {

constexpr int kFullSamples = 4;  // of the march, in the mean

Look fullLook() {
    Look look = lookOf(kModes[2]);
    look.transport = Transport::full;
    return look;
}

render::FrameInputs marched(const SpeciesVolume& volume, const Look& look, const View& view,
                            glm::ivec2 sizePx) {
    render::FrameInputs inputs = frame(volume, look, view.pose, sizePx, 0);
    inputs.look.engine = Engine::march;
    return inputs;
}

double meanLuminance(const ImageF& image) {
    double sum = 0.0;
    for (const glm::vec4& p : image.pixels) {
        sum += glm::dot(glm::dvec3(p), glm::dvec3(0.2126, 0.7152, 0.0722));
    }
    return sum / static_cast<double>(image.pixels.size());
}

/// The relative error of the march's mean, where the noise of the reference's is about 1 %.
double biasOn(const SpeciesVolume& volume, const render::FrameInputs& inputs) {
    const double seen = meanLuminance(averageOn(volume, inputs, kFullSamples));
    render::FrameInputs traced = inputs;
    traced.look.engine = Engine::reference;
    return seen / meanLuminance(averageOn(volume, traced, 128)) - 1.0;
}

}  // namespace

TEST_CASE("In a white furnace nothing can be told from the sky, from outside and inside") {
    const SpeciesVolume volume = blobs();
    Look look = fullLook();
    look.of(Species::graupel).albedo = 1.0f;
    look.sunIntensity = 0.0f;
    look.skyZenith = look.skyHorizon = glm::vec3(1.0f);
    look.groundVisible = false;
    for (const View& view : views()) {
        CAPTURE(view.name);
        const ImageF seen = averageOn(volume, marched(volume, look, view, {24, 18}), kFullSamples);
        for (const glm::vec4& pixel : seen.pixels) {
            CHECK(pixel.r == doctest::Approx(1.0).epsilon(0.02));
        }
    }
}

TEST_CASE("Full transport has the light of the path tracer, whatever the view") {
    const SpeciesVolume volume = blobs();
    for (const std::size_t view : {0U, 1U, 4U, 7U}) {
        CAPTURE(views()[view].name);
        const render::FrameInputs inputs = marched(volume, fullLook(), views()[view], {24, 18});
        CHECK(std::abs(biasOn(volume, inputs)) < 0.05);
    }
}

TEST_CASE("Full transport has the light of the path tracer with a low and with a set sun") {
    const SpeciesVolume volume = blobs();
    for (const float elevationDeg : {8.0f, -2.0f}) {
        CAPTURE(elevationDeg);
        Look look = fullLook();
        look.sunElevationDeg = elevationDeg;
        CHECK(std::abs(biasOn(volume, marched(volume, look, views()[0], {24, 18}))) < 0.05);
    }
}

TEST_CASE("Full transport has the light of the path tracer where particles absorb") {
    const SpeciesVolume volume = blobs();
    Look look = fullLook();
    for (SpeciesLook& field : look.species) field.albedo = 0.9f;
    const render::FrameInputs inputs = marched(volume, look, views()[0], {24, 18});
    CHECK(std::abs(biasOn(volume, inputs)) < 0.05);
}

TEST_CASE("Through a thick layer of droplets the sun is as bright as the path tracer has it") {
    const SpeciesVolume volume = uniformVolume({20, 20, 4}, 200.0, 3e-5f);
    Look look = fullLook();
    look.sunElevationDeg = 75.0f;
    look.of(Species::cloud).phase.kind = PhaseKind::waterDroplets;
    look.of(Species::cloud).mixingScale = 1.0f;
    // From the ground towards the sun, with 2 degrees across.
    const View view{"aureole",
                    {{0.5f, 0.5f, 1.0f}, 0.2f, look.sunAzimuthDeg + 180.0f, -75.0f, 5.0f}};
    const render::FrameInputs inputs = marched(volume, look, view, {8, 8});
    CHECK(std::abs(biasOn(volume, inputs)) < 0.12);
}

TEST_CASE("Clouds far beyond any optical depth are as bright as the path tracer has them") {
    const SpeciesVolume volume = blobs();  // of which one field absorbs
    for (const float scale : {30.0f, 100.0f}) {
        CAPTURE(scale);
        Look look = fullLook();
        for (SpeciesLook& field : look.species) field.mixingScale = scale;
        CHECK(std::abs(biasOn(volume, marched(volume, look, views()[0], {24, 18}))) < 0.05);
    }
}

TEST_CASE("Before a low sun the edges of thick clouds are as bright as the path tracer has them") {
    const SpeciesVolume volume = blobs();
    Look look = fullLook();
    look.sunElevationDeg = 8.0f;
    look.of(Species::cloud).phase.kind = PhaseKind::waterDroplets;
    for (SpeciesLook& field : look.species) field.mixingScale = 30.0f;
    const View view{"into the sun",
                    {{0.5f, 0.5f, 0.4f}, 1.3f, look.sunAzimuthDeg + 180.0f, 5.0f, 40.0f}};
    CHECK(std::abs(biasOn(volume, marched(volume, look, view, {24, 18}))) < 0.02);
}

TEST_CASE("Ground and sky have the radiance of the path tracer where nothing is") {
    const SpeciesVolume volume = uniformVolume({8, 8, 8}, 1000.0, 0.0f);
    for (const bool ground : {true, false}) {
        CAPTURE(ground);
        Look look = fullLook();
        look.groundVisible = ground;
        const render::FrameInputs inputs = marched(volume, look, views()[0], {24, 18});
        CHECK(std::abs(biasOn(volume, inputs)) < 0.01);
    }
}

TEST_CASE("Colours and intensities of sun and sky need no new light") {
    const SpeciesVolume volume = blobs();
    render::FrameInputs inputs = marched(volume, fullLook(), views()[0], {24, 18});
    renderOn(volume, inputs);
    inputs.look.sunColour = {1.0f, 0.5f, 0.2f};
    inputs.look.skyIntensity = 2.0f;
    const render::FrameStats stats = renderer().render(inputs);
    CHECK_FALSE(stats.marchedLight);
    REQUIRE(stats.light.has_value());
    CHECK(stats.light->settled);
    CHECK(worstDifference(renderer().readLinear(), renderAfresh(volume, inputs)) == 0.0f);
}

TEST_CASE("A frame that does not wait for settled light gets better by itself") {
    needContext();
    render::Renderer window{NEPH_TEST_SOURCE_DIR "/shaders"};
    const SpeciesVolume volume = blobs();
    window.setVolume(volume);
    render::FrameInputs inputs = marched(volume, fullLook(), views()[0], {24, 18});
    inputs.settledLight = false;
    render::FrameStats stats = window.render(inputs);
    const auto start = std::chrono::steady_clock::now();
    while (!stats.light->settled) {
        REQUIRE(std::chrono::steady_clock::now() - start < std::chrono::minutes(2));
        while (!window.hasNewerLight()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        stats = window.render(inputs);
        CHECK(stats.marchedEye);
        CHECK_FALSE(stats.marchedLight);
    }
    CHECK_FALSE(window.hasNewerLight());
    inputs.settledLight = true;
    CHECK(luminanceError(window.readLinear(), renderAfresh(volume, inputs)) < 0.02);
}

TEST_CASE("Half-angle slicing draws translucent light where full transport is asked for") {
    const SpeciesVolume volume = blobs();
    render::FrameInputs inputs = marched(volume, fullLook(), views()[0], {24, 18});
    inputs.look.engine = Engine::slicing;
    const ImageF full = renderOn(volume, inputs);
    inputs.look.transport = Transport::translucent;
    CHECK(worstDifference(full, renderOn(volume, inputs)) == 0.0f);
}
