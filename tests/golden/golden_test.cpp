// golden_test.cpp: every bundled preset on the bundled storm, held to an image that was looked at.
//
// Presets of full transport are shown in the light of three suns, solved in few voxels.
// With NEPHOSCOPE_UPDATE_GOLDEN set the images are written again: look at them before they are
// committed. An image that differs is kept beside the test program as <preset>-candidate.png.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/gl/context.h"
#include "app/image_io/png.h"
#include "app/render/renderer.h"
#include "core/dataset/dataset.h"
#include "core/preset/preset.h"
#include "core/volume/resample.h"

using namespace neph;
namespace fs = std::filesystem;

namespace {

const fs::path kSource = NEPH_TEST_SOURCE_DIR;
constexpr glm::ivec2 kSizePx{160, 100};
constexpr int kPlanes = 96;  // of slicing
constexpr int kSamples = 4;  // of the march
constexpr int kLightVoxels = 20000;

std::shared_ptr<Dataset> sample(const char* name) {
    const std::array places{fs::path(NEPH_TEST_READER_DIR)};
    static const PluginHost host(places);
    const std::array files{kSource / "samples" / name};
    return Dataset::open(files, host);
}

/// Keeps one volume, since most presets take the same.
class Volumes {
  public:
    Volumes(std::shared_ptr<Dataset> dataset, int time)
        : dataset_(std::move(dataset)), time_(time) {}

    /// The volume for `look`; true when it is another than the last.
    bool load(const Look& look) {
        RadiusPlan wanted = planRadii(look, dataset_->info());
        if (volume_.grid.size.x > 0 && wanted == radii_) return false;
        radii_ = std::move(wanted);
        volume_ = resample(*dataset_, time_, {.radii = radii_});
        return true;
    }
    const SpeciesVolume& volume() const { return volume_; }

  private:
    std::shared_ptr<Dataset> dataset_;
    int time_;
    RadiusPlan radii_;
    SpeciesVolume volume_;
};

struct Difference {
    double mean = 0.0;   ///< of the absolute difference, in steps of 8 bits
    double share = 0.0;  ///< of channels that differ by more than 8 steps
};

Difference compare(const Image8& a, const Image8& b) {
    REQUIRE(a.size == b.size);
    Difference d;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) {
        const int steps = std::abs(int{a.rgba[i]} - int{b.rgba[i]});
        d.mean += steps;
        if (steps > 8) d.share += 1.0;
    }
    d.mean /= static_cast<double>(a.rgba.size());
    d.share /= static_cast<double>(a.rgba.size());
    return d;
}

struct Shown {
    std::string name;  ///< of the golden image
    Look look;
};

/// A look as it is; where it is not about one light, with all scatterings followed, also with the
/// sun high, and low in front of the camera; and the default low behind it and after sunset.
std::vector<Shown> lightsOf(const std::string& name, const Preset& preset) {
    std::vector<Shown> shown{{name, preset.look}};
    constexpr std::array<std::string_view, 3> kOfAnyLight{"default", "cumulus", "model-radii"};
    if (std::ranges::find(kOfAnyLight, name) == kOfAnyLight.end()) return shown;
    Look look = preset.look;
    look.sunElevationDeg = 70.0f;
    shown.push_back({name + "-noon", look});
    look.sunElevationDeg = 8.0f;
    look.sunAzimuthDeg = std::fmod(preset.camera->azimuthDeg + 180.0f + 20.0f, 360.0f);
    shown.push_back({name + "-low-sun", look});
    if (name != kOfAnyLight.front()) return shown;
    look.sunElevationDeg = 4.0f;
    look.sunAzimuthDeg = std::fmod(preset.camera->azimuthDeg + 340.0f, 360.0f);
    shown.push_back({name + "-evening", look});
    look.sunElevationDeg = -3.0f;
    shown.push_back({name + "-dusk", look});
    return shown;
}

Image8 draw(render::Renderer& renderer, const Shown& shown, const CameraPose& pose,
            const SpeciesVolume& volume) {
    render::FrameInputs inputs;
    inputs.look = shown.look;
    inputs.sampling.lightVoxels = kLightVoxels;
    inputs.sizePx = kSizePx;
    const bool slices = inputs.look.engine == Engine::slicing;
    if (slices) inputs.planes = kPlanes;
    inputs.camera = placeCamera(pose, volume.grid, static_cast<double>(kSizePx.x) / kSizePx.y);
    render::Accumulation drawn;
    while (drawn.samples() < (slices ? 1 : kSamples)) renderer.render(inputs, drawn);
    return renderer.readDisplay();
}

void check(const std::string& name, const Image8& image) {
    CAPTURE(name);
    const fs::path golden = kSource / "tests/golden" / (name + ".png");
    if (std::getenv("NEPHOSCOPE_UPDATE_GOLDEN")) {
        writePng(golden, image, {});
        return;
    }
    const Difference d = compare(image, readPng(golden));
    CHECK(d.mean < 0.5);
    CHECK(d.share < 0.005);
    if (d.mean >= 0.5 || d.share >= 0.005) writePng(name + "-candidate.png", image, {});
}

}  // namespace

TEST_CASE("Every bundled preset shows its bundled sample as it did when it was looked at") {
    const gl::HeadlessContext context;
    render::Renderer renderer(kSource / "shaders");
    Volumes storm(sample("supercell/wrfout_d01_0001-01-01_01:00:00"), 0);
    Volumes cumulus(sample("cumulus/cumulus.json"), 1);
    const Volumes* shown = nullptr;
    int seen = 0;
    for (const auto& entry : fs::directory_iterator(kSource / "presets")) {
        const std::string name = entry.path().stem().string();
        CAPTURE(name);
        const LoadedPreset loaded = loadPreset(entry.path());
        CHECK(loaded.warnings.empty());
        // Its paths are drawn by chance: few of them are no image, and rounding that differs from
        // machine to machine makes others of them. tests/gpu/reference/reference_test.cpp is about
        // it.
        if (loaded.preset.look.engine == Engine::reference) continue;
        REQUIRE(loaded.preset.camera.has_value());
        Volumes& volumes =
            name.ends_with("cumulus") || name.ends_with("congestus") ? cumulus : storm;
        const bool fresh = volumes.load(loaded.preset.look);
        if (fresh || shown != &volumes) renderer.setVolume(volumes.volume());
        shown = &volumes;
        for (const Shown& each : lightsOf(name, loaded.preset)) {
            check(each.name, draw(renderer, each, *loaded.preset.camera, volumes.volume()));
            ++seen;
        }
    }
    CHECK(seen >= 10);
}
