// march_test.cpp: the march against the slicing engine, a double-precision march on the CPU and
// closed forms.
#include <doctest/doctest.h>

#include <cmath>
#include <span>

#include "tests/gpu/images.h"
#include "tests/gpu/scenes.h"
#include "tests/gpu/slicing/reference_march.h"

using namespace neph;
using namespace neph::test;

namespace {

constexpr int kPlanes = 192;  // of the slicing engine and of the reference, and steps of the march
constexpr int kSamples = 8;   // of the march, in the mean
constexpr std::span kTable4 = std::span(kModes).first<4>();

render::FrameInputs marchFrame(const SpeciesVolume& volume, const Look& look,
                               const CameraPose& pose, glm::ivec2 sizePx, int planes) {
    render::FrameInputs inputs = frame(volume, look, pose, sizePx, planes);
    inputs.look.engine = Engine::march;
    return inputs;
}

/// The march knows the form of light that does not depend on the step alone.
Look consistent(const Mode& mode) {
    Look look = lookOf(mode);
    look.lightForm = LightForm::consistent;
    return look;
}

ImageF slicedAs(const SpeciesVolume& volume, render::FrameInputs inputs) {
    inputs.look.engine = Engine::slicing;
    return renderOn(volume, inputs);
}

/// The whole of a box of 20 km, optical depth 3 from side to side: 1e-6 kg/m³ of 10 µm droplets,
/// 150 m²/kg.
SpeciesVolume depthThree() {
    return uniformVolume({20, 20, 20}, 1000.0, 1e-6f);
}

Look withoutGround() {
    Look look = plainLook();
    look.groundVisible = false;
    return look;
}

/// The volume with so many empty cells on every side.
SpeciesVolume surrounded(const SpeciesVolume& volume, glm::ivec3 cells) {
    SpeciesVolume out;
    out.grid = volume.grid;
    out.grid.size += 2 * cells;
    out.grid.originM -= glm::dvec3(cells) * volume.grid.spacingM;
    for (std::size_t s = 0; s < 5; ++s) {
        const Array3f& from = volume.contentKgPerM3[s];
        Array3f& to = out.contentKgPerM3[s] = Array3f(out.grid.size);
        for (int z = 0; z < from.size.z; ++z)
            for (int y = 0; y < from.size.y; ++y)
                for (int x = 0; x < from.size.x; ++x)
                    to.at(x + cells.x, y + cells.y, z + cells.z) = from.at(x, y, z);
    }
    return out;
}

double rms(const ImageF& a, const ImageF& b) {
    REQUIRE(a.size == b.size);
    double sum = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const glm::dvec3 d(a.pixels[i] - b.pixels[i]);
        sum += glm::dot(d, d);
    }
    return std::sqrt(sum / static_cast<double>(a.pixels.size()));
}

}  // namespace

TEST_CASE("March and slicing differ by at most 2 % in every mode of table 4, from every side") {
    const SpeciesVolume volume = blobs();
    for (const Mode& mode : kTable4) {
        for (const View& view : views()) {
            CAPTURE(std::string(mode.name));
            CAPTURE(view.name);
            const auto inputs = marchFrame(volume, consistent(mode), view.pose, {80, 60}, kPlanes);
            const ImageF sliced = slicedAs(volume, inputs);
            CHECK(luminanceError(averageOn(volume, inputs, kSamples), sliced) <= 0.02);
        }
    }
}

TEST_CASE("The march differs from a double-precision march by at most 2 % in every mode") {
    const SpeciesVolume volume = blobs();
    const auto check = [&](const Mode& mode, const View& view) {
        CAPTURE(std::string(mode.name));
        CAPTURE(view.name);
        const auto inputs = marchFrame(volume, consistent(mode), view.pose, {20, 15}, kPlanes);
        const ImageF reference = referenceMarch(volume, inputs);
        CHECK(luminanceError(averageOn(volume, inputs, kSamples), reference) <= 0.02);
    };
    for (const Mode& mode : kTable4) check(mode, views()[0]);
    check(kTable4[3], views()[2]);
    check(kTable4[2], views()[6]);
    check(kModes[5], views()[4]);
    check(kModes[6], views()[1]);
}

TEST_CASE("Six species, each with a phase function, an albedo and a detail of its own, are drawn") {
    SpeciesVolume volume = blobs();
    volume.contentKgPerM3[5] = volume.contentKgPerM3[3];
    Look look = consistent(kModes[6]);
    const PhaseKind phases[] = {PhaseKind::waterDroplets, PhaseKind::roughAggregate,
                                PhaseKind::rayleigh,      PhaseKind::solidColumn,
                                PhaseKind::isotropic,     PhaseKind::doubleHenyeyGreenstein};
    for (std::size_t s = 0; s < 6; ++s) {
        SpeciesLook& field = look.species[s];
        const auto share = static_cast<float>(s) / 6.0f;
        field.phase.kind = phases[s];
        field.albedo = 1.0f - 0.3f * share;
        field.noiseScaleCells = 2.0f + 2.0f * share;
        field.noiseAmount = 0.4f + share;
    }
    for (const ColourMode colour : {ColourMode::natural, ColourMode::fields}) {
        look.colour = colour;
        const auto inputs = marchFrame(volume, look, views()[0].pose, {40, 30}, kPlanes);
        const ImageF sliced = slicedAs(volume, inputs);
        CHECK(luminanceError(averageOn(volume, inputs, kSamples), sliced) <= 0.02);
    }
}

TEST_CASE("The march dims what is behind a homogeneous box by Beer-Lambert, for any step") {
    const SpeciesVolume volume = depthThree();
    const CameraPose pose{{0.5f, 0.5f, 0.5f}, 3.0f, 180.0f, 0.0f, 5.0f};
    for (const int planes : {0, 16, 100, 333}) {
        CAPTURE(planes);
        const ImageF seen =
            renderOn(volume, marchFrame(volume, withoutGround(), pose, {9, 9}, planes));
        // A half of the extinction's float is 5e-4, times 3 in the exponent.
        CHECK(1.0f - seen.pixels[40].a == doctest::Approx(std::exp(-3.0)).epsilon(2e-3));
    }
}

TEST_CASE("From within a homogeneous box only what lies before the eye is seen") {
    const SpeciesVolume volume = depthThree();
    // The target is the middle, the eye a quarter of the box to the south of it: τ = 3/4 · 3.
    const CameraPose pose{{0.5f, 0.5f, 0.5f}, 0.25f, 180.0f, 0.0f, 5.0f};
    const ImageF seen = renderOn(volume, marchFrame(volume, withoutGround(), pose, {9, 9}, 0));
    CHECK(1.0f - seen.pixels[40].a == doctest::Approx(std::exp(-2.25)).epsilon(2e-3));
}

TEST_CASE("Single scattering of an isotropic layer has a slab's closed form in the march") {
    // From above with the sun overhead: I = F P / 2 [1 - e^-2τ]; radiance is in units of F / 4π.
    const SpeciesVolume volume =
        uniformVolume({40, 40, 10}, 1000.0, 2e-7f / 3.0f);  // τ = 0.1 vertically
    Look look = withoutGround();
    look.transport = Transport::lowAlbedo;
    look.phaseDisplay = PhaseDisplay::physical;
    look.uniformPhase.kind = PhaseKind::isotropic;
    look.sunElevationDeg = 90.0f;
    look.sunColour = glm::vec3(1.0f);
    look.skyIntensity = 0.0f;
    const CameraPose pose{{0.5f, 0.5f, 0.5f}, 8.0f, 0.0f, 90.0f, 5.0f};
    const ImageF seen = renderOn(volume, marchFrame(volume, look, pose, {9, 9}, 400));
    CHECK(seen.pixels[40].r == doctest::Approx((1.0 - std::exp(-0.2)) / 2.0).epsilon(5e-3));
}

TEST_CASE("The ground under a wide layer gets the sunlight that forward scattering leaves") {
    // E = e^-(1-f)τ with f = CP(10°), here CS with g = 0.85; the layer hangs 1 km above the ground.
    SpeciesVolume volume = uniformVolume({40, 40, 4}, 1000.0, 5.0f / 150.0f / 4000.0f);  // τ = 5
    volume.grid.originM.z = 1000.0;
    Look look = plainLook();
    look.forwardG = 0.85f;
    look.sunElevationDeg = 90.0f;
    look.sunColour = look.groundColour = glm::vec3(1.0f);
    look.skyIntensity = 0.0f;
    look.of(Species::cloud).albedo = 1.0f;
    const CameraPose below{{0.5f, 0.5f, -0.2f}, 1e-3f, 0.0f, 90.0f, 5.0f};
    const auto inputs = marchFrame(volume, look, below, {9, 9}, 100);
    REQUIRE(inputs.camera.eyeWorld.z < 1000.0);
    const double haze = std::exp(-inputs.camera.eyeWorld.z / 90e3);  // docs/physics.md §5
    CHECK(renderOn(volume, inputs).pixels[40].r ==
          doctest::Approx(haze * std::exp(-(1.0 - 0.37859480) * 5.0)).epsilon(5e-3));
}

TEST_CASE("Grids of any size are drawn: one cell, a few, and sizes that no brick divides") {
    for (const glm::ivec3 size : {glm::ivec3(1), glm::ivec3(5, 3, 2), glm::ivec3(129, 65, 33)}) {
        CAPTURE(size.x);
        const SpeciesVolume volume =  // τ = 2 from south to north
            uniformVolume(size, 100.0, 2.0f / 150.0f / (100.0f * static_cast<float>(size.y)));
        const CameraPose pose{{0.5f, 0.5f, 0.5f}, 3.0f, 180.0f, 0.0f, 5.0f};
        for (const bool noise : {false, true}) {
            Look look = withoutGround();
            look.noise = noise;
            const auto inputs = marchFrame(volume, look, pose, {9, 9}, 0);
            const ImageF seen = renderOn(volume, inputs);
            CHECK(allFinite(seen));
            if (noise) continue;
            CHECK(1.0f - seen.pixels[40].a == doctest::Approx(std::exp(-2.0)).epsilon(2e-3));
        }
    }
}

TEST_CASE("An image of one pixel is that of the ray through its middle") {
    const SpeciesVolume volume = depthThree();
    const CameraPose pose{{0.5f, 0.5f, 0.5f}, 3.0f, 180.0f, 0.0f, 5.0f};
    const ImageF seen = renderOn(volume, marchFrame(volume, withoutGround(), pose, {1, 1}, 0));
    REQUIRE(seen.pixels.size() == 1);
    CHECK(1.0f - seen.pixels[0].a == doctest::Approx(std::exp(-3.0)).epsilon(2e-3));
}

TEST_CASE("Empty cells around a volume change nothing") {
    // Nothing touches the outermost cells, and blocks begin at the same places.
    const SpeciesVolume volume = surrounded(blobs(), {3, 5, 7});
    const SpeciesVolume padded = surrounded(volume, glm::ivec3(16));
    for (const std::size_t view : {0u, 1u, 5u}) {
        CAPTURE(view);
        auto inputs = marchFrame(volume, consistent(kTable4[2]), views()[view].pose, {40, 30}, 0);
        const ImageF seen = renderOn(volume, inputs);
        CHECK(worstDifference(renderOn(padded, inputs), seen) < 1e-3f);
    }
}

TEST_CASE("The mean of sixteen samples is nearer to that of many than one sample is") {
    const SpeciesVolume volume = blobs();
    for (const Mode& mode : {kTable4[2], kTable4[3]}) {
        CAPTURE(std::string(mode.name));
        const auto inputs = marchFrame(volume, consistent(mode), views()[0].pose, {60, 45}, 96);
        const ImageF one = averageOn(volume, inputs, 1);
        const ImageF mean = averageOn(volume, inputs, 16);
        const ImageF many = averageOn(volume, inputs, 96);
        CHECK(rms(mean, many) < 0.5 * rms(one, many));
        CHECK(rms(one, many) > 0.0);
    }
}

TEST_CASE("Nothing visible and nothing there leave sky and ground to the march") {
    SpeciesVolume volume = blobs();
    Look look;
    look.transport = Transport::translucent;
    const Look seeing = look;
    for (SpeciesLook& field : look.species) field.visible = false;
    const auto hidden = marchFrame(volume, look, views()[0].pose, {40, 30}, 48);
    const ImageF clear = referenceMarch(volume, hidden);
    const auto checkClear = [&](const ImageF& seen) {
        CHECK(worstDifference(seen, clear) < 1e-4f);
        for (const glm::vec4& pixel : seen.pixels) REQUIRE(pixel.a == 0.0f);
    };
    checkClear(renderOn(volume, hidden));
    for (const bool zeros : {true, false}) {
        for (Array3f& content : volume.contentKgPerM3) {
            content = zeros && !content.empty() ? Array3f(volume.grid.size) : Array3f();
        }
        for (const int planes : {0, 48}) {
            checkClear(
                renderOn(volume, marchFrame(volume, seeing, views()[0].pose, {40, 30}, planes)));
        }
    }
}
