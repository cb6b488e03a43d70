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
        for (const Engine engine : {Engine::slicing, Engine::reference}) {
            const ImageF other = averageOn(nothing, seenBy(engine, nothing, look, pose, {5, 4}), 1);
            CHECK(meanLightOf(other) == doctest::Approx(meanLightOf(image)).epsilon(1e-4));
        }
    }
}

TEST_CASE("What stands in for an image has the sky and the ground of one without cloud") {
    const SpeciesVolume nothing = uniformVolume({4, 4, 4}, 500.0, 0.0f);
    Look look = airyLook(35.0f);
    look.groundColour = {0.3f, 0.36f, 0.17f};
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
            check(inputs.camera.eyeWorld.z, ray,
                  glsl::displayValue(glm::vec3(pixel), exposureGain(look),
                                     static_cast<int>(look.toneMap)));
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
    // Straight down, where little air is before the ground, whose pattern is mostly within so much
    // of its mean.
    look.sunElevationDeg = 35.0f;
    each(85.0f, [&](double eyeM, const glm::dvec3& ray, const glm::vec3& expected) {
        Look darker = look, brighter = look;
        darker.groundColour *= 0.7f;
        brighter.groundColour *= 1.3f;
        for (int c = 0; c < 3; ++c) {
            CHECK(expected[c] > Backdrop(darker, eyeM).ground(ray).value()[c]);
            CHECK(expected[c] < Backdrop(brighter, eyeM).ground(ray).value()[c]);
        }
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
