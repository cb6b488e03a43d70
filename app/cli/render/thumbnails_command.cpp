// thumbnails_command.cpp: one storm, one renderer, many looks.
#include "app/cli/render/thumbnails_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/cli/common/interrupt.h"
#include "app/cli/common/progress_lines.h"
#include "app/cli/common/scene.h"
#include "app/gl/context.h"
#include "app/image_io/png.h"
#include "app/render/renderer.h"
#include "core/base/resources.h"
#include "core/dataset/file_list.h"
#include "core/look/haze.h"
#include "core/plugin/plugin_host.h"
#include "core/preset/preset_files.h"
#include "core/session/session.h"
#include "core/session/thumbnail.h"
#include "core/volume/held_volume.h"

namespace neph {
namespace {

// More do not show at this size, or take too long.
constexpr int kLightVoxels = 20000;  // enough for an image as small
constexpr int kSamples = 4;

struct Wanted {
    PresetEntry preset;
    std::filesystem::path file;
};

std::vector<PresetEntry> presetsOf(const ThumbnailRequest& request) {
    if (request.presets.empty()) return listPresets();
    std::vector<PresetEntry> entries;
    for (const std::string& name : request.presets) {
        const std::filesystem::path file = findPreset(name);
        entries.push_back({file.stem().string(), file, true});
    }
    return entries;
}

/// Those that are not there yet.
std::vector<Wanted> wantedBy(const ThumbnailRequest& request) {
    std::vector<Wanted> wanted;
    for (const PresetEntry& preset : presetsOf(request)) {
        if (!request.out.empty()) {
            wanted.push_back({preset, std::filesystem::path(request.out) / (preset.name + ".png")});
        } else if (const auto file = thumbnailFile(preset); file && !exists(*file)) {
            wanted.push_back({preset, *file});
        }
    }
    if (!wanted.empty()) create_directories(wanted.front().file.parent_path());
    return wanted;
}

/// The bundled storm, with the radii that a look asks for.
class Storm {
  public:
    explicit Storm(const Progress& goesOn)
        : goesOn_(goesOn),
          dataset_(Dataset::open(listFiles({}), PluginHost::standard({}), goesOn)),
          renderer_(resourcePath("shaders")) {}

    Image8 imageOf(const Preset& preset, glm::ivec2 sizePx);

  private:
    Progress goesOn_;
    std::shared_ptr<Dataset> dataset_;
    render::Renderer renderer_;
    std::optional<VolumeRequest> held_;
    RegularGrid grid_;
    Whereabouts where_;
};

Image8 Storm::imageOf(const Preset& preset, glm::ivec2 sizePx) {
    std::vector<std::string> warnings;  // told by whoever chose the setting
    const VolumeRequest request{
        {},
        chooseBudget({}, held_ ? held_->budget.gpu : rendererBytes(gl::deviceMemory()), warnings),
        planRadii(preset.look, dataset_->info()),
        asksHumidity(preset.look)};
    if (!held_ || held_->radii != request.radii || held_->humidity != request.humidity) {
        const HeldVolume held =
            readVolume(*dataset_, defaultTime(dataset_->info()), request, goesOn_);
        renderer_.setVolume(*held.volume);
        grid_ = held.summary.grid;
        where_ = held.summary.where;
        held_ = request;
    }
    render::FrameInputs inputs;
    inputs.look = lookAsDrawn(preset.look, where_);
    inputs.sampling.lightVoxels = kLightVoxels;
    inputs.sizePx = sizePx;
    inputs.camera = placeCamera(preset.camera.value_or(CameraPose{}), grid_,
                                static_cast<double>(sizePx.x) / sizePx.y);
    const int samples = traitsOf(preset.look.engine).refinement == Refinement::once ? 1 : kSamples;
    render::Accumulation image;
    while (image.samples() < samples) renderer_.render(inputs, image, goesOn_);
    return renderer_.readDisplay();
}

int makeAll(const std::vector<Wanted>& wanted, glm::ivec2 sizePx, ProgressLines& progress) {
    int status = 0;
    const gl::HeadlessContext context;
    Storm storm(untilInterrupted());
    for (const Wanted& each : wanted) {
        try {
            const Preset preset = loadPreset(each.preset.file).preset;
            writePng(each.file, storm.imageOf(preset, sizePx),
                     {{"Software", fmt::format("Nephoscope {}", versionText())},
                      {"nephoscope.preset", each.preset.name}});
            fmt::print(stderr, "wrote {}\n", each.file.string());
        } catch (const Error& error) {
            fmt::print(stderr, "error: {}\n", error.message());
            status = 1;
        }
        progress.done(each.file);
    }
    return status;
}

}  // namespace

int runThumbnails(const ThumbnailRequest& request) {
    const std::vector<Wanted> wanted = wantedBy(request);
    ProgressLines progress(request.progress, wanted.size());
    if (wanted.empty()) return 0;
    noteInterrupts();
    try {
        return makeAll(wanted, request.sizePx, progress);
    } catch (const Cancelled&) {
        return 128 + interruptSignal();
    }
}

}  // namespace neph
