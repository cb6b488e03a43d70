// endless_field_test.cpp: what the eye sees of a domain that repeats: the same from every period,
// wherever its sides are, without a line on them, and as paths of light find it.
#include <doctest/doctest.h>

#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "tests/gpu/images.h"
#include "tests/gpu/periodic_scenes.h"
#include "tests/gpu/scenes.h"

using namespace neph;
using namespace neph::test;

namespace {

// Shares of the grid and of its width; all numbers are exact in binary.
const CameraPose kOverField{{0.5f, 0.5f, 0.5f}, 1.5f, 180.0f, 30.0f, 40.0f};
const CameraPose kLevelInField{{0.5f, 0.25f, 0.375f}, 0.25f, 250.0f, 2.0f, 50.0f};
const CameraPose kLevelOutside{{1.75f, 0.25f, 1.25f}, 0.5f, 200.0f, 1.0f, 40.0f};

render::FrameInputs fieldOf(const SpeciesVolume& volume, Transport transport,
                            const CameraPose& pose, SkyModel sky, glm::ivec2 sizePx = {20, 14}) {
    render::FrameInputs inputs =
        periodicFrame(volume, transport, DomainSides::periodic, pose, sizePx);
    inputs.look.skyModel = sky;
    inputs.look.visibilityM = 30e3f;
    inputs.look.groundSurface = GroundSurface::plain;
    inputs.look.sunDisc = false;
    inputs.sampling.lightVoxels = 1 << 20;
    return inputs;
}

/// So many widths further.
render::FrameInputs movedBy(render::FrameInputs inputs, const RegularGrid& grid,
                            glm::dvec2 widths) {
    inputs.camera.eyeWorld += glm::dvec3(widths * glm::dvec2(grid.extentM()), 0.0);
    return inputs;
}

/// One cloud in the middle of 6 x 6 x 3 km.
SpeciesVolume oneCloud() {
    SpeciesVolume volume = uniformVolume({24, 24, 10}, 250.0, 0.0f);
    Array3f& content = volume.contentKgPerM3[0];
    for (int z = 0; z < content.size.z; ++z)
        for (int y = 0; y < content.size.y; ++y)
            for (int x = 0; x < content.size.x; ++x) {
                const glm::dvec3 d = (glm::dvec3(x, y, z) - glm::dvec3(11.5, 11.5, 5.0)) / 3.5;
                const double bell = std::exp(-glm::dot(d, d));
                content.at(x, y, z) = bell > 0.02 ? static_cast<float>(4e-5 * bell) : 0.0f;
            }
    return volume;
}

double brightnessOf(const ImageF& image) {
    double sum = 0.0;
    for (const glm::vec4& p : image.pixels) {
        sum += glm::dot(glm::dvec3(p), glm::dvec3(0.2126, 0.7152, 0.0722));
    }
    return sum / static_cast<double>(image.pixels.size());
}

}  // namespace

TEST_CASE("From every period of a domain that repeats the march sees the same") {
    const SpeciesVolume volume = brokenClouds();
    for (const SkyModel sky : {SkyModel::gradient, SkyModel::atmosphere}) {
        for (const Transport transport : {Transport::translucent, Transport::full}) {
            for (const CameraPose& pose : {kOverField, kLevelOutside}) {
                CAPTURE(static_cast<int>(sky));
                CAPTURE(static_cast<int>(transport));
                const render::FrameInputs inputs = fieldOf(volume, transport, pose, sky);
                const ImageF here = renderOn(volume, inputs);
                CHECK(allFinite(here));
                for (const glm::dvec2 widths :
                     {glm::dvec2(1.0, 0.0), glm::dvec2(-1000.0, 1000.0)}) {
                    const ImageF there = renderOn(volume, movedBy(inputs, volume.grid, widths));
                    CHECK(worstDifference(here, there) < 1e-4f);
                }
                const ImageF between = renderOn(volume, movedBy(inputs, volume.grid, {0.5, 0.25}));
                CHECK(worstDifference(here, between) > 1e-2f);
            }
        }
    }
}

TEST_CASE("From every period of a domain that repeats paths find the same") {
    const SpeciesVolume volume = brokenClouds();
    for (const SkyModel sky : {SkyModel::gradient, SkyModel::atmosphere}) {
        CAPTURE(static_cast<int>(sky));
        render::FrameInputs inputs = fieldOf(volume, Transport::full, kLevelOutside, sky, {12, 8});
        inputs.look.engine = Engine::reference;
        const ImageF here = averageOn(volume, inputs, 4);
        CHECK(allFinite(here));
        for (const glm::dvec2 widths : {glm::dvec2(1.0, 0.0), glm::dvec2(-1000.0, 1000.0)}) {
            const ImageF there = averageOn(volume, movedBy(inputs, volume.grid, widths), 4);
            CHECK(worstDifference(here, there) < 1e-4f);
        }
    }
}

TEST_CASE("Where the sides of a domain that repeats lie cannot be seen") {
    const SpeciesVolume volume = brokenClouds(2);
    for (const SkyModel sky : {SkyModel::gradient, SkyModel::atmosphere}) {
        for (const Transport transport :
             {Transport::lowAlbedo, Transport::translucent, Transport::full}) {
            for (const CameraPose& pose : {kOverField, kLevelInField}) {
                CAPTURE(static_cast<int>(sky));
                CAPTURE(static_cast<int>(transport));
                const render::FrameInputs inputs = fieldOf(volume, transport, pose, sky);
                const ImageF here = averageOn(volume, inputs, 2);
                // Half a period, and what divides no brick.
                for (const glm::ivec2 voxels : {glm::ivec2(16, 14), glm::ivec2(5, 11)}) {
                    const glm::dvec2 widths =
                        glm::dvec2(voxels) / glm::dvec2(glm::ivec2(volume.grid.size));
                    const ImageF there =
                        averageOn(rolled(volume, voxels), movedBy(inputs, volume.grid, widths), 2);
                    CHECK(luminanceError(there, here) < 0.01);
                }
            }
        }
    }
}

TEST_CASE("A cloud across a corner of a domain that repeats is one cloud") {
    const SpeciesVolume volume = oneCloud();
    const glm::ivec2 half(volume.grid.size / 2);
    const SpeciesVolume corner = rolled(volume, half);
    CameraPose pose{{0.5f, 0.5f, 0.5f}, 1.0f, 200.0f, 35.0f, 30.0f};
    for (const Engine engine : {Engine::march, Engine::reference}) {
        CAPTURE(static_cast<int>(engine));
        render::FrameInputs inputs =
            fieldOf(volume, Transport::full, pose, SkyModel::gradient, {16, 12});
        inputs.look.engine = engine;
        const int samples = engine == Engine::march ? 2 : 64;
        const ImageF whole = averageOn(volume, inputs, samples);
        const ImageF cut = averageOn(corner, movedBy(inputs, volume.grid, {0.5, 0.5}), samples);
        CHECK(luminanceError(cut, whole) < (engine == Engine::march ? 0.01 : 0.1));
        CHECK(brightnessOf(cut) == doctest::Approx(brightnessOf(whole)).epsilon(0.02));
        inputs.look.domainSides = DomainSides::open;
        const ImageF open = averageOn(corner, movedBy(inputs, volume.grid, {0.5, 0.5}), samples);
        CHECK(luminanceError(open, whole) > 0.1);
    }
}

TEST_CASE("Of a domain that repeats the eye sees what stands there where repeats really do") {
    const SpeciesVolume volume = brokenClouds(), nine = nineOf(volume);
    const CameraPose above{{0.5f, 0.5f, 0.5f}, 1.5f, 180.0f, 90.0f, 60.0f};
    render::FrameInputs inputs =
        fieldOf(volume, Transport::lowAlbedo, above, SkyModel::gradient, {28, 24});
    inputs.look.sunElevationDeg = 89.0f;  // no shadow reaches from without
    const ImageF repeated = averageOn(volume, inputs, 2);
    inputs.look.domainSides = DomainSides::open;
    // Haze takes a tenth of what is 9 km away.
    CHECK(luminanceError(repeated, averageOn(nine, inputs, 2)) < 0.12);
    CHECK(luminanceError(repeated, averageOn(volume, inputs, 2)) > 0.2);
}

TEST_CASE("Detail goes on across the sides of a domain that repeats") {
    const SpeciesVolume volume = uniformVolume({20, 20, 6}, 200.0, 6e-6f);
    const CameraPose overCorner{{0.0f, 0.0f, 0.5f}, 6.0f, 180.0f, 90.0f, 5.0f};
    constexpr int kSide = 64;
    for (const Engine engine : {Engine::march, Engine::reference}) {
        for (const float cells : {2.3f, 3.7f}) {  // neither divides the domain
            CAPTURE(static_cast<int>(engine));
            CAPTURE(cells);
            render::FrameInputs inputs = fieldOf(volume, Transport::lowAlbedo, overCorner,
                                                 SkyModel::gradient, {kSide, kSide});
            inputs.look.engine = engine;
            inputs.look.noise = true;
            inputs.look.of(Species::cloud).noiseAmount = 1.0f;
            inputs.look.of(Species::cloud).noiseScaleCells = cells;
            inputs.sampling.quality = 2.0f;
            inputs.backdrop = false;
            const ImageF image = averageOn(volume, inputs, engine == Engine::march ? 4 : 64);
            // From column to column, how much opacity changes.
            std::vector<double> change(kSide - 1, 0.0);
            for (int y = 0; y < kSide; ++y)
                for (int x = 0; x + 1 < kSide; ++x) {
                    const auto i = static_cast<std::size_t>(y * kSide + x);
                    change[static_cast<std::size_t>(x)] +=
                        std::abs(static_cast<double>(image.pixels[i + 1].a - image.pixels[i].a));
                }
            const double mean = std::accumulate(change.begin(), change.end(), 0.0) / (kSide - 1);
            CHECK(change[kSide / 2 - 1] < 1.6 * mean);
        }
    }
}

TEST_CASE("The march has the light of paths in a field that repeats, from inside and outside") {
    const SpeciesVolume volume = brokenClouds();
    for (const SkyModel sky : {SkyModel::gradient, SkyModel::atmosphere}) {
        std::vector<double> bias;
        for (const CameraPose& pose : {kOverField, kLevelInField, kLevelOutside}) {
            render::FrameInputs inputs = fieldOf(volume, Transport::full, pose, sky, {16, 12});
            inputs.look.visibilityM = 300e3f;
            const double seen = brightnessOf(averageOn(volume, inputs, 4));
            inputs.look.engine = Engine::reference;
            bias.push_back(seen / brightnessOf(averageOn(volume, inputs, 128)) - 1.0);
        }
        CAPTURE(static_cast<int>(sky));
        CAPTURE(bias[0]);
        CAPTURE(bias[1]);
        CAPTURE(bias[2]);
        // Through air the march is 5 % too bright between periodic sides, seen from wherever:
        // docs/transport.md
        const double known = sky == SkyModel::atmosphere ? 0.05 : 0.0;
        for (const double each : bias) CHECK(std::abs(each - known) < 0.03);
    }
}
