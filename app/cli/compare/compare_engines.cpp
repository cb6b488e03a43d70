// compare_engines.cpp: one scene, one renderer, several looks that differ in how they are drawn.
#include "app/cli/compare/compare_engines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/cli/render/bands.h"
#include "app/cli/render/reference_channels.h"
#include "app/cli/render/render_sides.h"
#include "app/cli/render/render_view.h"
#include "app/gl/context.h"
#include "app/image_io/exr.h"
#include "app/image_io/png.h"
#include "core/base/resources.h"
#include "core/look/exposure.h"
#include "core/look/haze.h"
#include "shaders/lib/glsl_cpp.h"

namespace neph {
namespace {

constexpr double kMsPerS = 1000.0;

/// As the resolve pass shows it, without dither.
Image8 displayOf(const ImageF& linear, const Look& look) {
    Image8 image;
    image.size = linear.size;
    const DisplayTones tones = displayTones(look);
    for (const glm::vec4& pixel : linear.pixels) {
        const glm::vec3 shown = glsl::displayValue(tones.exposure * glm::vec3(pixel), tones.curve);
        for (int c = 0; c < 3; ++c) {
            image.rgba.push_back(static_cast<std::uint8_t>(std::lround(shown[c] * 255.0f)));
        }
        image.rgba.push_back(255);
    }
    return image;
}

ParameterSet parametersOf(const ComparedEngine& engine, ParameterSet values) {
    for (const Setting& setting : engine.settings) setValue(values, *setting.row, setting.value);
    return values;
}

/// Draws one scene, seen from one place, with any engine.
class Drawer {
  public:
    Drawer(const CompareRequest& request, const Progress& progress)
        : request_(request), progress_(progress) {
        const RenderRequest& render = request.render;
        std::vector<SideScene> scenes = sideScenes(render, {});
        checkEngines(scenes.front().scene.document);
        std::vector<std::string> warnings = scenes.front().scene.warnings;
        MemoryBudget budget =
            chooseBudget(render.scene.memory, rendererBytes(gl::deviceMemory()), warnings);
        budget.gpu /= scenes.size();
        budget.machine /= scenes.size();
        for (const std::string& warning : warnings) fmt::print(stderr, "warning: {}\n", warning);
        for (SideScene& scene : scenes) {
            sides_.push_back(std::make_unique<Side>(std::move(scene), budget, progress));
            side_ = sides_.back().get();
            side_->show(side_->times().front(), progress);
            for (const std::string& note : side_->newNotes()) {
                fmt::print(stderr, "note: {}\n", note);
            }
        }
        side_ = sides_.front().get();
        sizePx_ = render.sizePx;
        const double aspect = static_cast<double>(sizePx_.x) / sizePx_.y;
        pose_ = side_->what().scene.document.camera;
        const RenderView from = firstView(render.from, side_->what().scene);
        pose_ = poseOf(from, pose_, side_->shown(), side_->parameters().look, aspect);
        camera_ = placeCamera(pose_, side_->shown().grid, aspect);
    }

    ComparedImage draw(const ComparedEngine& engine);
    /// Draws each side, called by its member.
    std::vector<ComparedImage> drawMembers() {
        std::vector<ComparedImage> images;
        for (const auto& side : sides_) {
            side_ = side.get();
            images.push_back(draw({side->memberName(), {}}));
        }
        return images;
    }

  private:
    /// Options must act with one of the engines at least. Of the march the window's samples are
    /// drawn.
    void checkEngines(const ParameterSet& values) const {
        unsigned engines = 0;
        for (const ComparedEngine& engine : request_.engines) {
            engines |= bitOf(parametersOf(engine, values).look.engine);
        }
        if (request_.engines.empty()) engines = bitOf(values.look.engine);
        checkActing(request_.render, engines,
                    enginesWith(&EngineTraits::refinement, Refinement::converges));
    }
    void keep(const ComparedEngine& engine, const LayeredImage& image, const DrawnSide& drawn,
              const std::string& made) const;

    const CompareRequest& request_;
    Progress progress_;
    gl::HeadlessContext context_;
    std::vector<std::unique_ptr<Side>> sides_;
    Side* side_ = nullptr;  // that is drawn
    glm::ivec2 sizePx_{0};
    CameraPose pose_;
    Camera camera_;
};

ComparedImage Drawer::draw(const ComparedEngine& engine) {
    DrawnSide drawn;
    drawn.renderer = &side_->renderer();
    const ParameterSet values = parametersOf(engine, side_->parameters());
    drawn.inputs.look = lookAsDrawn(values.look, side_->shown().where);
    drawn.inputs.look.sunDisc = false;  // it would outshine every error
    drawn.inputs.sampling = values.sampling;
    drawn.inputs.sizePx = sizePx_;
    drawn.inputs.camera = camera_;
    const SamplePlan plan = planSamples(request_, values);
    drawn.samples = plan.samples;
    drawn.targetError = plan.targetError;
    drawn.toPx = sizePx_.x;
    Bands bands({drawn}, progress_);
    LayeredImage layered = bands.nextLayered();
    while (layered.colours.size.y < sizePx_.y) append(layered, bands.nextLayered());
    ComparedImage image;
    image.name = engine.name;
    image.device = side_->renderer().deviceName();
    image.scale = side_->scaleOf(values.look);
    image.made = fmt::format("{}, {}", workText(drawn, bands.stats()), image.device);
    const bool converges = traitsOf(drawn.inputs.look.engine).refinement == Refinement::converges;
    image.samples = converges ? bands.stats().reference.samples : drawn.samples;
    image.seconds = bands.stats().milliseconds / kMsPerS;
    if (!layered.layers.empty()) {
        std::vector<std::vector<float>> channels;
        for (std::size_t i = 0; i < halfChannels().size(); ++i) {
            channels.push_back(layered.layers[i].values);
        }
        image.halves = halvesFrom(channels, sizePx_);
    }
    for (const std::string& message : side_->renderer().takeMessages()) {
        fmt::print(stderr, "warning: {}\n", message);
    }
    fmt::print(stderr, "drew {} ({}, {:.1f} s)\n", engine.name, image.made, *image.seconds);
    if (!request_.out.empty()) keep(engine, layered, drawn, image.made);
    image.image = std::move(layered.colours);
    return image;
}

void Drawer::keep(const ComparedEngine& engine, const LayeredImage& image, const DrawnSide& drawn,
                  const std::string& made) const {
    Metadata metadata{{"Software", fmt::format("Nephoscope {}", versionText())}};
    const ParameterSet values = parametersOf(engine, side_->parameters());
    for (auto& [key, text] : side_->describe(values, pose_, made)) {
        metadata.emplace_back("nephoscope." + key, text);
    }
    std::vector<std::string> names;
    for (const ImageLayer& layer : image.layers) names.push_back(layer.name);
    writeExr(fileOf(request_, engine.name, ".exr"), sizePx_, metadata,
             {ExrPixels::full, showsRadiance(drawn.inputs.look)}, names, [&] { return image; });
    writePng(fileOf(request_, engine.name, ".png"), displayOf(image.colours, drawn.inputs.look),
             metadata);
}

}  // namespace

std::vector<ComparedImage> drawEngines(const CompareRequest& request, const Progress& progress) {
    if (!request.out.empty()) std::filesystem::create_directories(request.out);
    Drawer drawer(request, progress);
    if (request.engines.empty()) return drawer.drawMembers();
    std::vector<ComparedImage> images;
    for (const ComparedEngine& engine : request.engines) {
        images.push_back(drawer.draw(engine));
    }
    return images;
}

std::filesystem::path fileOf(const CompareRequest& request, const std::string& engine,
                             const std::string& ending) {
    std::string name = engine;
    std::ranges::replace_if(
        name, [](char c) { return c == ':' || c == '='; }, '-');
    return request.out / (name + ending);
}

}  // namespace neph
