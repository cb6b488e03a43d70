// slicing_test.cpp: the slicing engine against closed forms and against a double-precision march on
// the CPU.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "tests/gpu/images.h"
#include "tests/gpu/scenes.h"
#include "tests/gpu/slicing/reference_march.h"

using namespace neph;
using namespace neph::test;

namespace {

render::FrameInputs slicedFrame(const SpeciesVolume& volume, const Look& look,
                                const CameraPose& pose, glm::ivec2 sizePx, int planes) {
    render::FrameInputs inputs = frame(volume, look, pose, sizePx, planes);
    inputs.look.engine = Engine::slicing;
    return inputs;
}

}  // namespace

TEST_CASE("The GPU agrees with a double-precision march to 1e-3 in every mode") {
    const SpeciesVolume volume = blobs();
    for (const Mode& mode : kModes) {
        CAPTURE(std::string(mode.name));
        const auto inputs = slicedFrame(volume, lookOf(mode), views()[0].pose, {40, 30}, 48);
        const float worst =
            worstDifference(renderOn(volume, inputs), referenceMarch(volume, inputs));
        CHECK(worst < 1e-3f);
    }
}

TEST_CASE("The GPU agrees with a double-precision march to 1e-3 from every side") {
    const SpeciesVolume volume = blobs();
    for (const View& view : views()) {
        CAPTURE(view.name);
        const auto inputs = slicedFrame(volume, lookOf(kModes[2]), view.pose, {40, 30}, 48);
        const ImageF seen = renderOn(volume, inputs);
        CHECK(worstDifference(seen, referenceMarch(volume, inputs)) < 1e-3f);
        const bool anyCloud = std::any_of(seen.pixels.begin(), seen.pixels.end(),
                                          [](glm::vec4 p) { return p.a > 0.05f; });
        CHECK(anyCloud);
    }
}

TEST_CASE("A species held as extinction is seen as one held as the mass that has it") {
    const SpeciesVolume mass = blobs();
    SpeciesVolume sized = mass;
    const auto ice = static_cast<std::size_t>(Species::ice);
    sized.extinctionPerM[ice] = Array3f();
    std::swap(sized.extinctionPerM[ice], sized.contentKgPerM3[ice]);
    for (float& value : sized.extinctionPerM[ice].values) value *= 1.5f / (917.0f * 1e-3f);
    auto inputs = slicedFrame(mass, lookOf(kModes[2]), views()[0].pose, {40, 30}, 48);
    inputs.look.of(Species::ice).mixingScale = 3.0f;
    const ImageF seen = renderOn(sized, inputs);
    CHECK(worstDifference(seen, referenceMarch(sized, inputs)) < 1e-3f);
    CHECK(worstDifference(seen, renderOn(mass, inputs)) < 1e-4f);
    inputs.look.of(Species::ice).effectiveRadiusM = 20e-6f;  // of the mass alone
    CHECK(worstDifference(seen, renderOn(sized, inputs)) < 1e-6f);
    CHECK(worstDifference(seen, renderOn(mass, inputs)) > 0.05f);
}

TEST_CASE("A homogeneous box dims what is behind it by Beer-Lambert, for any number of planes") {
    // 20 km of 1e-6 kg/m³ of 10 µm droplets: k = 150 m²/kg, τ = 3.0 straight through.
    const SpeciesVolume volume = uniformVolume({20, 20, 20}, 1000.0, 1e-6f);
    CameraPose pose{{0.5f, 0.5f, 0.5f}, 3.0f, 180.0f, 0.0f, 5.0f};
    for (const int planes : {16, 100, 333}) {
        Look look = plainLook();
        look.groundVisible = false;
        const ImageF seen = renderOn(volume, slicedFrame(volume, look, pose, {9, 9}, planes));
        CHECK(seen.pixels[40].a ==
              doctest::Approx(1.0 - std::exp(-3.0)).epsilon(2e-2 * 16 / planes));
    }
}

TEST_CASE("Single scattering of an isotropic layer has the closed form of a slab") {
    // From above with the sun overhead: I = F P / 2 [1 - e^-2τ]; radiance is in units of F / 4π.
    const SpeciesVolume volume =
        uniformVolume({40, 40, 10}, 1000.0, 2e-7f / 3.0f);  // τ = 0.1 vertically
    Look look = plainLook();
    look.transport = Transport::lowAlbedo;
    look.phaseDisplay = PhaseDisplay::physical;
    look.uniformPhase.kind = PhaseKind::isotropic;
    look.sunElevationDeg = 90.0f;
    look.sunColour = glm::vec3(1.0f);
    look.groundVisible = false;
    look.skyIntensity = 0.0f;
    const CameraPose pose{{0.5f, 0.5f, 0.5f}, 8.0f, 0.0f, 90.0f, 5.0f};
    const ImageF seen = renderOn(volume, slicedFrame(volume, look, pose, {9, 9}, 400));
    CHECK(seen.pixels[40].r == doctest::Approx((1.0 - std::exp(-0.2)) / 2.0).epsilon(5e-3));
}

TEST_CASE("Step-consistent light does not depend on the number of planes, the printed form does") {
    // The ground under a wide layer sees the sun through all of it: E = e^-(1-f)τ with f = CP(10°),
    // here CS with g = 0.85.
    const SpeciesVolume volume =
        uniformVolume({40, 40, 4}, 1000.0, 5.0f / 150.0f / 4000.0f);  // τ = 5
    const auto sunOnGround = [&](LightForm form, int planes) {
        Look look = plainLook();
        look.lightForm = form;
        look.forwardG = 0.85f;
        look.sunElevationDeg = 90.0f;
        look.sunColour = look.groundColour = glm::vec3(1.0f);
        look.skyIntensity = 0.0f;
        look.of(Species::cloud).albedo = 1.0f;
        const CameraPose below{{0.5f, 0.5f, 0.0f}, 1e-3f, 0.0f, 90.0f, 5.0f};
        const auto inputs = slicedFrame(volume, look, below, {9, 9}, planes);
        return static_cast<double>(renderOn(volume, inputs).pixels[40].r);
    };
    const double expected = std::exp(-(1.0 - 0.37859480) * 5.0);
    for (const int planes : {16, 50, 200}) {
        CHECK(sunOnGround(LightForm::consistent, planes) ==
              doctest::Approx(expected).epsilon(5e-3));
    }
    CHECK(sunOnGround(LightForm::printed, 16) > 1.05 * sunOnGround(LightForm::printed, 200));
}

TEST_CASE("Nothing visible leaves sky and ground") {
    const SpeciesVolume volume = blobs();
    Look look;
    for (SpeciesLook& field : look.species) field.visible = false;
    const auto inputs = slicedFrame(volume, look, views()[0].pose, {40, 30}, 48);
    const ImageF seen = renderOn(volume, inputs);
    CHECK(worstDifference(seen, referenceMarch(volume, inputs)) < 1e-4f);
    for (const glm::vec4& pixel : seen.pixels) CHECK(pixel.a == 0.0f);
}

TEST_CASE("A change redoes no more than it touches") {
    const SpeciesVolume volume = blobs();
    auto inputs = slicedFrame(volume, Look(), views()[0].pose, {40, 30}, 48);
    renderer().setVolume(volume);
    CHECK(renderer().render(inputs).bakedMedium);
    CHECK_FALSE(renderer().render(inputs).marchedEye);
    inputs.look.exposureEv = 1.0f;
    CHECK_FALSE(renderer().render(inputs).marchedEye);
    inputs.look.sunIntensity = 0.5f;
    render::FrameStats stats = renderer().render(inputs);
    CHECK(stats.marchedEye);
    CHECK_FALSE(stats.marchedLight);
    CHECK(worstDifference(renderer().readLinear(), referenceMarch(volume, inputs)) < 1e-3f);
    inputs.look.sunElevationDeg = 60.0f;
    stats = renderer().render(inputs);
    CHECK(stats.marchedLight);
    CHECK_FALSE(stats.bakedMedium);
    inputs.look.of(Species::ice).mixingScale = 2.0f;
    CHECK(renderer().render(inputs).bakedMedium);
}

TEST_CASE("More slices than light layers fit are marched in batches, in either order") {
    const SpeciesVolume volume = blobs();
    for (const View& view : {views()[0], views()[1]}) {
        CAPTURE(view.name);
        // Software drivers hold 2048 layers.
        const auto inputs = slicedFrame(volume, lookOf(kModes[2]), view.pose, {8, 6}, 2300);
        CHECK(worstDifference(renderOn(volume, inputs), referenceMarch(volume, inputs)) < 1e-3f);
    }
}

TEST_CASE("An image larger than the GPU takes is an error that names the limit") {
    const SpeciesVolume volume = blobs();
    renderer().setVolume(volume);
    const auto tooLarge = slicedFrame(volume, Look(), views()[0].pose, {1 << 20, 4}, 16);
    CHECK_THROWS_WITH_AS(renderer().render(tooLarge), doctest::Contains("1048576 x 4 px"), Error);
}

TEST_CASE("A cancelled frame leaves the last whole image, and the next frame is right") {
    const SpeciesVolume volume = blobs();
    const auto before = slicedFrame(volume, Look(), views()[0].pose, {40, 30}, 48);
    const ImageF whole = renderOn(volume, before);
    const Image8 shown = renderer().readDisplay();
    auto turned = slicedFrame(volume, Look(), views()[4].pose, {40, 30}, 48);
    CHECK_THROWS_AS(renderer().render(turned, [](double) { return false; }), Cancelled);
    renderer().render(before);
    CHECK(worstDifference(renderer().readLinear(), whole) == 0.0f);
    CHECK((renderer().readDisplay().rgba == shown.rgba));
}
