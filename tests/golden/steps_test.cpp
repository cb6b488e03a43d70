// steps_test.cpp: what the length of the march's steps does to images of the bundled samples.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "app/gl/context.h"
#include "app/render/renderer.h"
#include "core/dataset/dataset.h"
#include "core/preset/preset.h"
#include "core/volume/framing.h"
#include "core/volume/resample.h"

using namespace neph;
namespace fs = std::filesystem;

namespace {

const fs::path kTree = NEPH_TEST_SOURCE_DIR;
constexpr glm::ivec2 kStepsPx{96, 72};
// In the mean, at quality 1 and 4: what is left of the chance of where a sample lies is well below
// what is measured, without detail. Detail is rougher.
constexpr std::array kImages{16, 8}, kDetailedImages{48, 24};

std::vector<float> displayed(render::Renderer& renderer, const render::FrameInputs& inputs,
                             int images) {
    render::Accumulation drawn;
    while (drawn.samples() < images) renderer.render(inputs, drawn);
    std::vector<float> values;
    for (const std::uint8_t value : renderer.readDisplay().rgba) {
        values.push_back(static_cast<float>(value) / 255.0f);
    }
    return values;
}

/// Of a pixel's largest difference in a channel, what one pixel in a thousand exceeds.
float nearlyWorst(const std::vector<float>& a, const std::vector<float>& b) {
    REQUIRE(a.size() == b.size());
    std::vector<float> largest(a.size() / 4, 0.0f);
    for (std::size_t i = 0; i < a.size(); ++i) {
        largest[i / 4] = std::max(largest[i / 4], std::abs(a[i] - b[i]));
    }
    std::sort(largest.begin(), largest.end());
    return largest[largest.size() * 999 / 1000];
}

void checkViews(render::Renderer& renderer, const SpeciesVolume& volume, const Look& look,
                const CameraPose& pose, const std::array<int, 2>& images) {
    const double aspect = static_cast<double>(kStepsPx.x) / kStepsPx.y;
    for (const View view : {View::fit, View::plan, View::south, View::west, View::below}) {
        CAPTURE(static_cast<int>(view));
        render::FrameInputs inputs;
        inputs.look = look;
        inputs.sampling.lightVoxels = 10000;
        inputs.sizePx = kStepsPx;
        inputs.camera =
            placeCamera(framed(view, pose, summarise(volume), look, aspect), volume.grid, aspect);
        const std::vector<float> coarse = displayed(renderer, inputs, images[0]);
        inputs.sampling.quality = 4.0f;
        const float difference = nearlyWorst(coarse, displayed(renderer, inputs, images[1]));
        CHECK(difference <= 0.03f);
    }
}

}  // namespace

TEST_CASE(
    "Images at quality 1 and 4 differ by at most 0.03 in all but a thousandth of the pixels") {
    const gl::HeadlessContext context;
    render::Renderer renderer(kTree / "shaders");
    const std::array places{fs::path(NEPH_TEST_READER_DIR)};
    const PluginHost host(places);
    struct Sample {
        const char* file;
        int time;
    };
    for (const Sample& bundled : {Sample{"supercell/wrfout_d01_0001-01-01_01:00:00", 0},
                                  Sample{"cumulus/cumulus.json", 1}}) {
        CAPTURE(std::string(bundled.file));
        const std::array files{kTree / "samples" / bundled.file};
        const auto dataset = Dataset::open(files, host);
        for (const char* name : {"default", "model-radii"}) {
            CAPTURE(std::string(name));
            LoadedPreset loaded = loadPreset(kTree / "presets" / (std::string(name) + ".json"));
            const RadiusPlan radii = planRadii(loaded.preset.look, dataset->info());
            const SpeciesVolume volume = resample(*dataset, bundled.time, {.radii = radii});
            renderer.setVolume(volume);
            for (const bool noise : {false, true}) {
                loaded.preset.look.noise = noise;
                checkViews(renderer, volume, loaded.preset.look, *loaded.preset.camera,
                           noise ? kDetailedImages : kImages);
            }
        }
    }
}
