// sky_test.cpp: a cloud in the air of the Earth, in every engine.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "core/look/backdrop.h"
#include "core/look/exposure.h"
#include "core/look/sun.h"
#include "shaders/lib/glsl_cpp.h"
#include "tests/gpu/images.h"
#include "tests/gpu/scenes.h"

using namespace neph;
using namespace neph::test;

namespace {

Look airyLook(float sunElevationDeg) {
    Look look = lookOf(kModes[2]);
    look.transport = Transport::full;
    look.skyModel = SkyModel::atmosphere;
    look.sunElevationDeg = sunElevationDeg;
    return look;
}

render::FrameInputs seenBy(Engine engine, const SpeciesVolume& volume, const Look& look,
                           const CameraPose& pose, glm::ivec2 sizePx) {
    render::FrameInputs inputs = frame(volume, look, pose, sizePx, 0);
    inputs.look.engine = engine;
    return inputs;
}

double meanLightOf(const ImageF& image) {
    double sum = 0.0;
    for (const glm::vec4& p : image.pixels) {
        sum += glm::dot(glm::dvec3(p), glm::dvec3(0.2126, 0.7152, 0.0722));
    }
    return sum / static_cast<double>(image.pixels.size());
}

}  // namespace

TEST_CASE("The sun's disc is seen through air and cloud alike in every engine") {
    const SpeciesVolume clear = uniformVolume({4, 4, 4}, 500.0, 0.0f);
    const SpeciesVolume cloud = uniformVolume({4, 4, 4}, 500.0, 5e-6f);
    Look look = airyLook(35.0f);
    look.noise = false;
    CameraPose pose = views()[0].pose;  // towards the sun, through the middle
    pose.azimuthDeg = look.sunAzimuthDeg - 180.0f;
    pose.elevationDeg = -look.sunElevationDeg;
    pose.fovDeg = 1.5f;
    /// What the disc adds to an image, and the share of the light that passes its middle.
    const auto discOf = [&](Engine engine, const SpeciesVolume& volume) {
        render::FrameInputs inputs = seenBy(engine, volume, look, pose, {9, 9});
        const ImageF with = averageOn(volume, inputs, 1);
        inputs.look.sunDisc = false;
        const ImageF without = averageOn(volume, inputs, 1);
        return glm::dvec2(meanLightOf(with) - meanLightOf(without), 1.0f - without.pixels[40].a);
    };
    const double clearDisc = discOf(Engine::slicing, clear).x;
    const glm::dvec2 behindCloud = discOf(Engine::slicing, cloud);
    CHECK(behindCloud.y > 0.02);
    CHECK(behindCloud.y < 0.5);
    // All of the sun's irradiance, from 1.5 x 1.5 degrees.
    const double frame = 1.5 * 1.5 * std::pow(std::numbers::pi / 180.0, 2.0);
    CHECK(clearDisc == doctest::Approx(discIrradiance(look, 0.0).g / frame).epsilon(0.1));
    CHECK(behindCloud.x == doctest::Approx(clearDisc * behindCloud.y).epsilon(0.02));
    for (const Engine engine : {Engine::march, Engine::reference}) {
        CAPTURE(static_cast<int>(engine));
        CHECK(discOf(engine, clear).x == doctest::Approx(clearDisc).epsilon(1e-3));
        CHECK(discOf(engine, cloud).x == doctest::Approx(behindCloud.x).epsilon(0.03));
    }
}

TEST_CASE("Glare veils the screen by how much of the disc is seen, in every part of an image") {
    const SpeciesVolume clear = uniformVolume({4, 4, 4}, 500.0, 0.0f);
    const SpeciesVolume cloud = uniformVolume({4, 4, 4}, 500.0, 1e-3f);
    Look look = airyLook(35.0f);
    look.noise = false;
    look.toneMap = ToneMap::linear;
    look.exposureEv = -2.0f;
    CameraPose pose = views()[0].pose;  // 8 degrees beside the sun
    pose.azimuthDeg = look.sunAzimuthDeg - 188.0f;
    pose.elevationDeg = -look.sunElevationDeg;
    pose.fovDeg = 10.0f;
    /// Values on the screen, all channels; `part`: of the lower half alone.
    const auto shown = [&](Engine engine, const SpeciesVolume& volume, float glare, bool part) {
        look.glare = glare;
        render::FrameInputs inputs = seenBy(engine, volume, look, pose, {12, 12});
        if (part) {
            inputs.part = render::ImagePart{{12, 12}, {0, 0}};
            inputs.sizePx = {12, 6};
        }
        averageOn(volume, inputs, 1);
        const Image8 image = renderer().readDisplay();
        std::vector<int> values;
        for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
            for (std::size_t c = 0; c < 3; ++c) values.push_back(image.rgba[i + c]);
        }
        return values;
    };
    for (const Engine engine : {Engine::march, Engine::slicing, Engine::reference}) {
        CAPTURE(static_cast<int>(engine));
        const auto bare = shown(engine, clear, 0.0f, false);
        const auto veiled = shown(engine, clear, 0.1f, false);
        for (std::size_t i = 0; i < bare.size(); ++i) CHECK(veiled[i] > bare[i]);
        const auto lower = shown(engine, clear, 0.1f, true);
        REQUIRE(lower.size() == veiled.size() / 2);
        for (std::size_t i = 0; i < lower.size(); ++i) {
            // Dither is by the pixel of the whole.
            CHECK(std::abs(lower[i] - veiled[i + lower.size()]) <= 1);
        }
        CHECK(shown(engine, cloud, 0.1f, false) == shown(engine, cloud, 0.0f, false));
    }
}

TEST_CASE("The sky of every engine is what air sends along each ray") {
    const SpeciesVolume nothing = uniformVolume({4, 4, 4}, 500.0, 0.0f);
    for (const float elevationDeg : {35.0f, 2.0f, -4.0f}) {
        CAPTURE(elevationDeg);
        const Look look = airyLook(elevationDeg);
        // Level, from the ground, to the north.
        CameraPose pose = views()[0].pose;
        pose.elevationDeg = -20.0f;
        const render::FrameInputs march = seenBy(Engine::march, nothing, look, pose, {5, 4});
        const ImageF image = averageOn(nothing, march, 1);
        const auto air = atmosphereOf(look);
        const glm::dvec3 towardsSun = sunDirWorld(look);
        for (int y = 0; y < image.size.y; ++y) {
            for (int x = 0; x < image.size.x; ++x) {
                const glm::dvec2 ndc =
                    (2.0 * glm::dvec2(x, y) + 1.0) / glm::dvec2(image.size) - 1.0;
                const Camera& camera = march.camera;
                const glm::dvec3 dir = glm::normalize(
                    camera.forward + ndc.x * camera.tanHalfFovY * camera.aspect * camera.right -
                    ndc.y * camera.tanHalfFovY * camera.up);
                if (dir.z < 0.05) continue;
                const double azimuth =
                    std::atan2(dir.y, dir.x) - std::atan2(towardsSun.y, towardsSun.x);
                const glm::dvec3 expected =
                    4.0 * std::numbers::pi *
                    rgbOfSunlight(
                        air->along({camera.eyeWorld.z, dir.z, azimuth, towardsSun.z}).radiance);
                const glm::vec4& pixel =
                    image.pixels[static_cast<std::size_t>(y * image.size.x + x)];
                for (int c = 0; c < 3; ++c) {
                    CHECK(pixel[c] == doctest::Approx(expected[c]).epsilon(0.05));
                }
            }
        }
        const ImageF sliced =
            averageOn(nothing, seenBy(Engine::slicing, nothing, look, pose, {5, 4}), 1);
        CHECK(meanLightOf(sliced) == doctest::Approx(meanLightOf(image)).epsilon(1e-4));
        // Its paths choose between sky and ground in the pixels of the horizon.
        const ImageF traced =
            averageOn(nothing, seenBy(Engine::reference, nothing, look, pose, {5, 4}), 512);
        CHECK(meanLightOf(traced) == doctest::Approx(meanLightOf(image)).epsilon(0.01));
    }
}

TEST_CASE("What stands in for an image has the sky and the ground of one without cloud") {
    const SpeciesVolume nothing = uniformVolume({4, 4, 4}, 500.0, 0.0f);
    Look look = airyLook(35.0f);
    look.groundColour = {0.3f, 0.36f, 0.17f};
    look.groundSurface = GroundSurface::plain;
    /// What an image has in its middle column, and which ray that is.
    const auto each = [&](float poseElevationDeg, const auto& check) {
        CameraPose pose = views()[0].pose;
        pose.elevationDeg = poseElevationDeg;
        const render::FrameInputs inputs = seenBy(Engine::march, nothing, look, pose, {5, 8});
        const ImageF image = averageOn(nothing, inputs, 1);
        for (int y = 0; y < image.size.y; ++y) {
            const glm::dvec3 ray =
                inputs.camera.rayDir({0.0, 1.0 - (2.0 * y + 1.0) / image.size.y});
            CAPTURE(ray.z);
            const glm::vec4& pixel = image.pixels[static_cast<std::size_t>(y * image.size.x + 2)];
            const DisplayTones tones = displayTones(look);
            check(inputs.camera.eyeWorld.z, ray,
                  glsl::displayValue(tones.exposure * glm::vec3(pixel), tones.curve));
        }
    };
    for (const float elevationDeg : {35.0f, 3.0f}) {
        CAPTURE(elevationDeg);
        look.sunElevationDeg = elevationDeg;
        each(-20.0f, [&](double eyeM, const glm::dvec3& ray, const glm::vec3& expected) {
            if (ray.z > 0.05) {
                CHECK(glm::length(Backdrop(look, eyeM).sky(ray) - expected) < 0.02f);
            }
        });
    }
    // Straight down, where little air is before the ground.
    look.sunElevationDeg = 35.0f;
    each(85.0f, [&](double eyeM, const glm::dvec3& ray, const glm::vec3& expected) {
        CHECK(glm::length(Backdrop(look, eyeM).ground(ray).value() - expected) < 0.02f);
    });
}

TEST_CASE("In the air of the Earth full transport has the light of the path tracer") {
    const SpeciesVolume volume = blobs();
    struct Scene {
        float sunElevationDeg;
        std::size_t view;
    };
    for (const Scene& scene :
         {Scene{40.0f, 0}, Scene{5.0f, 0}, Scene{-1.0f, 0}, Scene{40.0f, 7}, Scene{40.0f, 6}}) {
        const float sun = scene.sunElevationDeg;
        const std::size_t view = scene.view;
        CAPTURE(sun);
        CAPTURE(views()[view].name);
        const Look look = airyLook(sun);
        const CameraPose pose = views()[view].pose;
        const double march =
            meanLightOf(averageOn(volume, seenBy(Engine::march, volume, look, pose, {24, 18}), 4));
        const double traced = meanLightOf(
            averageOn(volume, seenBy(Engine::reference, volume, look, pose, {24, 18}), 128));
        CHECK(march == doctest::Approx(traced).epsilon(0.05));
    }
}

TEST_CASE("Of a black cloud, haze shows the more the farther it is") {
    SpeciesVolume volume = blobs();
    Look look = airyLook(40.0f);
    look.visibilityM = 30e3f;
    for (SpeciesLook& field : look.species) {
        field.albedo = 0.0f;
        field.mixingScale = 1.0f;
    }
    // Of the pixel in the middle: what is left of the difference between the cloud and a sky that
    // is as bright as air that never ends.
    const auto middleAt = [&](float distance) {
        CameraPose pose = views()[0].pose;
        pose.elevationDeg = 0.0f;
        pose.distance = distance;
        const ImageF image =
            averageOn(volume, seenBy(Engine::march, volume, look, pose, {9, 9}), 1);
        return image.pixels[40].b;
    };
    const float near = middleAt(1.0f), far = middleAt(6.0f), farther = middleAt(20.0f);
    CHECK(near < 0.5f * far);
    CHECK(far < 0.9f * farther);
}

TEST_CASE("A sun in another azimuth is lit as by a renderer that saw no other") {
    const SpeciesVolume volume = blobs();
    Look look = airyLook(20.0f);
    const CameraPose pose = views()[0].pose;
    renderOn(volume, seenBy(Engine::march, volume, look, pose, {12, 9}));
    look.sunAzimuthDeg = 100.0f;
    const render::FrameInputs turned = seenBy(Engine::march, volume, look, pose, {12, 9});
    CHECK(worstDifference(renderOn(volume, turned), renderAfresh(volume, turned)) < 1e-4f);
}

TEST_CASE("An eye below the ground has the horizon of one that stands on it") {
    const SpeciesVolume nothing = uniformVolume({4, 4, 4}, 500.0, 0.0f);
    render::FrameInputs inputs =
        seenBy(Engine::march, nothing, airyLook(35.0f), views()[0].pose, {6, 6});
    inputs.camera.forward = {0.0, 1.0, 0.0};
    inputs.camera.right = {1.0, 0.0, 0.0};
    inputs.camera.up = {0.0, 0.0, 1.0};
    inputs.camera.eyeWorld.z = 2.0;
    const ImageF standing = averageOn(nothing, inputs, 1);
    inputs.camera.eyeWorld.z = -1500.0;
    for (const Engine engine : {Engine::march, Engine::slicing}) {
        inputs.look.engine = engine;
        CHECK(worstDifference(averageOn(nothing, inputs, 1), standing) < 0.01f);
    }
    inputs.camera.eyeWorld.z = 2.0;
    inputs.look.groundVisible = false;
    CHECK(worstDifference(averageOn(nothing, inputs, 1), standing) > 0.02f);
}
