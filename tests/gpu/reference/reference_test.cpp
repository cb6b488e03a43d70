// reference_test.cpp: the engine of paths as the renderer drives it. That its light is right is the
// business of `nephoscope validate`.
#include <doctest/doctest.h>

#include <cmath>

#include "tests/gpu/images.h"
#include "tests/gpu/scenes.h"

using namespace neph;
using namespace neph::test;

namespace {

constexpr glm::ivec2 kSizePx{16, 12};

render::FrameInputs traced(const SpeciesVolume& volume, const Look& base,
                           glm::ivec2 sizePx = kSizePx) {
    render::FrameInputs inputs = frame(volume, base, views()[0].pose, sizePx, 0);
    inputs.look.engine = Engine::reference;
    return inputs;
}

/// An image of so many paths per pixel.
render::Accumulation trace(const render::FrameInputs& inputs, int paths) {
    render::Accumulation image;
    while (image.samples() < paths) renderer().render(inputs, image);
    return image;
}

ImageF tracedOn(const SpeciesVolume& volume, const render::FrameInputs& inputs, int paths) {
    renderer().setVolume(volume);
    trace(inputs, paths);
    return renderer().readLinear();
}

/// Every field, every kind of phase function that differs by wavelength, detail.
Look richLook() {
    return lookOf(kModes[3]);
}

double meanGreen(const ImageF& image) {
    double sum = 0.0;
    for (const glm::vec4& pixel : image.pixels) sum += static_cast<double>(pixel.g);
    return sum / static_cast<double>(image.pixels.size());
}

}  // namespace

TEST_CASE("The same seed gives the same image, another seed another") {
    const SpeciesVolume volume = blobs();
    render::FrameInputs inputs = traced(volume, richLook());
    const ImageF first = tracedOn(volume, inputs, 3);
    CHECK(worstDifference(first, tracedOn(volume, inputs, 3)) == 0.0f);
    inputs.sampling.seed = 1;
    CHECK(worstDifference(first, tracedOn(volume, inputs, 3)) > 0.0f);
}

TEST_CASE("A part of an image has the paths of the whole") {
    const SpeciesVolume volume = blobs();
    render::FrameInputs inputs = traced(volume, richLook());
    const ImageF whole = tracedOn(volume, inputs, 2);
    inputs.part = render::ImagePart{kSizePx, {4, 6}};
    inputs.sizePx = {8, 6};
    const ImageF part = tracedOn(volume, inputs, 2);
    for (int y = 0; y < 6; ++y) {
        for (int x = 0; x < 8; ++x) {
            const auto at = static_cast<std::size_t>(y * kSizePx.x + x + 4);
            CHECK(part.pixels[static_cast<std::size_t>(y * 8 + x)] == whole.pixels[at]);
        }
    }
}

TEST_CASE("A pass that yielded goes on where it was") {
    const SpeciesVolume volume = blobs();
    const render::FrameInputs inputs = traced(volume, richLook());
    const ImageF wanted = tracedOn(volume, inputs, 4);
    renderer().setVolume(volume);
    render::Accumulation image;
    int yielded = 0;
    while (image.samples() < 4) {
        int asked = 0;
        try {
            renderer().render(inputs, image, [&asked](double) { return ++asked < 2; });
        } catch (const Cancelled&) {
            ++yielded;
        }
    }
    CHECK(yielded > 0);
    CHECK(renderer().retone(inputs.look).reference.samples == 4);
    CHECK(worstDifference(renderer().readLinear(), wanted) == 0.0f);
}

TEST_CASE("Exposure leaves the paths alone") {
    const SpeciesVolume volume = blobs();
    render::FrameInputs inputs = traced(volume, richLook());
    const ImageF linear = tracedOn(volume, inputs, 2);
    inputs.look.exposureEv += 1.0f;
    const render::FrameStats stats = renderer().retone(inputs.look);
    CHECK(static_cast<int>(stats.redone) == static_cast<int>(Stage::resolve));
    CHECK(worstDifference(renderer().readLinear(), linear) == 0.0f);
}

TEST_CASE("In a furnace nothing can be seen") {
    const SpeciesVolume volume = blobs();
    Look look = richLook();
    look.of(Species::graupel).albedo = 1.0f;
    look.sunIntensity = 0.0f;
    look.skyZenith = look.skyHorizon = glm::vec3(0.5f, 0.25f, 1.0f);
    look.groundVisible = false;
    const ImageF seen = tracedOn(volume, traced(volume, look), 64);
    const auto count = static_cast<double>(seen.pixels.size());
    for (int channel = 0; channel < 3; ++channel) {
        double sum = 0.0;
        for (const glm::vec4& pixel : seen.pixels) sum += static_cast<double>(pixel[channel]);
        // Wavelengths are drawn by chance: the spread of the ratio is about 1 / sqrt(12288 paths).
        CHECK(sum / count ==
              doctest::Approx(static_cast<double>(look.skyZenith[channel])).epsilon(0.02));
    }
}

TEST_CASE("In a furnace of one phase function every pixel is the sky to a thousandth") {
    const SpeciesVolume volume = blobs();
    Look look = plainLook();
    look.noise = true;
    look.uniformPhase = {.kind = PhaseKind::doubleHenyeyGreenstein};
    look.sunIntensity = 0.0f;
    look.skyZenith = look.skyHorizon = glm::vec3(0.5f);
    look.groundVisible = false;
    const ImageF seen = tracedOn(volume, traced(volume, look), 64);
    CHECK(meanGreen(seen) == doctest::Approx(0.5).epsilon(1e-3));
}

TEST_CASE("A thin cloud, and the ground below, look alike to the march and to the reference") {
    // Optical depth of about 0.02: light is scattered once or not at all.
    const SpeciesVolume volume = uniformVolume({12, 12, 8}, 500.0, 3e-8f);
    Look look = plainLook();
    look.uniformPhase = {.kind = PhaseKind::henyeyGreenstein, .g = 0.3f};
    look.phaseDisplay = PhaseDisplay::physical;
    look.transport = Transport::lowAlbedo;
    look.skyIntensity = 0.0f;
    render::FrameInputs inputs = traced(volume, look);
    const ImageF paths = tracedOn(volume, inputs, 400);
    inputs.look.engine = Engine::march;
    inputs.planes = 200;
    const ImageF march = averageOn(volume, inputs, 4);
    REQUIRE(meanGreen(march) > 0.0);
    CHECK(meanGreen(paths) == doctest::Approx(meanGreen(march)).epsilon(0.03));
}

TEST_CASE("Layers: halves that make up the mean, and depths that follow from the medium") {
    const SpeciesVolume volume = uniformVolume({8, 8, 8}, 500.0, 1e-6f);
    Look look = plainLook();
    render::FrameInputs inputs = traced(volume, look);
    const ImageF mean = tracedOn(volume, inputs, 9);
    const render::FrameLayers layers = renderer().readLayers().value();
    REQUIRE(layers.samples == 9);
    REQUIRE(layers.size == kSizePx);
    double met = 0.0, expected = 0.0;
    for (std::size_t i = 0; i < mean.pixels.size(); ++i) {
        const glm::vec4 both =
            (5.0f * layers.halfA.pixels[i] + 4.0f * layers.halfB.pixels[i]) / 9.0f;
        CHECK(glm::length(both - mean.pixels[i]) <= 1e-5f * glm::length(mean.pixels[i]));
        const float depth = layers.opticalDepth[0][i];
        CHECK(layers.transmittance[i] == doctest::Approx(std::exp(-depth)).epsilon(1e-5));
        CHECK(layers.opticalDepth[1][i] == 0.0f);
        CHECK((depth > 0.0f || std::isinf(layers.firstScatterM[i])));
        met += static_cast<double>(mean.pixels[i].a);
        expected += 1.0 - std::exp(-static_cast<double>(depth));
    }
    // A path meets a particle or not: four standard errors of 9 x 192 tries.
    const auto count = static_cast<double>(mean.pixels.size());
    const double share = expected / count;
    CHECK(std::abs(met / count - share) < 4.0 * std::sqrt(share * (1.0 - share) / (9.0 * count)));
    REQUIRE(share > 0.05);
    REQUIRE(share < 0.95);
    // 1 mg/m³ of droplets of 10 µm over the straight way through, 4 km: 150 m²/kg.
    float deepest = 0.0f;
    for (const float depth : layers.opticalDepth[0]) deepest = std::max(deepest, depth);
    CHECK(deepest > 0.5f);
    CHECK(deepest < 0.75f);
}
