// slicing.cpp: running the passes batch by batch.
#include "app/render/engines/slicing/slicing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/render/frame/frame_block.h"
#include "core/look/sun.h"

namespace neph::render {

#include "shaders/shared/display_layout.glsl"
#include "shaders/shared/slicing_layout.glsl"

namespace {

// Bound on the light layers held at a time.
constexpr std::size_t kLightBytes = std::size_t{128} << 20;
// Between two questions to `progress`, a few milliseconds on the slowest machine. Rows are whole
// groups of the shader.
constexpr int kEyeBandRows = 4 * kSlicingEyeGroup;

std::vector<std::string> defines(const Look& look, const MediumTextures& medium) {
    std::vector<std::string> names =
        lightDefines(look, medium.plan, look.lightForm == LightForm::consistent);
    names.push_back(fmt::format("CLASS_TEXTURES {}", medium.textureCount()));
    names.push_back("PACKED 0");
    names.push_back("LIGHT_FORMAT r32f");
    return names;
}

/// Fetched, caches not considered: RGBA32F and RG16 from eight texels, light R32F from four.
double bytesPerSample(const MediumPlan& plan) {
    std::set<std::pair<float, NoiseCharacter>> noises;
    for (const MediumClass& c : plan.classes) {
        if (c.noiseAmount > 0.0f) noises.insert({c.noiseScaleM, c.noiseCharacter});
    }
    const double textures = plan.classes.size() > kClassesBesideSkylight ? 2.0 : 1.0;
    return 8.0 * (16.0 * textures + 4.0 * static_cast<double>(noises.size())) + 4.0 * 4.0;
}

int planesOf(const FrameInputs& inputs) {
    return inputs.planes > 0 ? inputs.planes : inputs.look.planes;
}

}  // namespace

void SlicingEngine::resize(glm::ivec2 sizePx) {
    const int most = layersThatFit(plan_.lightSizePx, sizeof(float), kLightBytes) - 1;
    batch_ = std::clamp(plan_.count, 1, most);
    light_.resize(plan_.lightSizePx, batch_ + 1, GL_R32F);
    if (eye_.size() != glm::ivec3(sizePx, 1)) {
        eye_ = gl::Texture::make2D(GL_RGBA32F, sizePx);
    }
}

void SlicingEngine::marchEye(const FrameInputs& inputs, const gl::Program& program,
                             const Progress& progress) {
    phases_.bind();
    eye_.bindImage(kSlicingEyeImage, GL_READ_WRITE);
    for (int row = 0; row < inputs.sizePx.y; row += kEyeBandRows) {
        if (!goOn(progress, static_cast<double>(row) / inputs.sizePx.y)) throw Cancelled{};
        program.setInt(kSlicingFirstRowLocation, row);
        program.dispatch({inputs.sizePx.x, std::min(kEyeBandRows, inputs.sizePx.y - row), 1});
    }
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

void SlicingEngine::prepare(const Look& look, RenderContext& context) {
    prepareClasses(look, context);
}

/// Once for each time that periodic sides are asked for.
void SlicingEngine::tellOpenSides(const Look& look, RenderContext& context) {
    const bool wanted = look.domainSides == DomainSides::periodic;
    if (wanted && !toldOpenSides_) {
        std::vector<std::string_view> others;
        for (const EngineTraits& engine : kEngines) {
            if (engine.periodicSides) others.push_back(engine.id);
        }
        context.messages.push_back(fmt::format(
            "domain.sides=periodic does not act with {}: it draws the domain once, and light comes "
            "in through open sides; choose view.engine={} for the endless field",
            traitsOf(look.engine).label, fmt::join(others, " or ")));
    }
    toldOpenSides_ = wanted;
}

void SlicingEngine::render(const FrameRequest& frame, RenderContext& context) {
    const FrameInputs& inputs = frame.inputs;
    tellOpenSides(inputs.look, context);
    const VolumeTextures& volume = context.volume;
    const MediumTextures& medium = context.medium.as<MediumTextures>();
    gl::ProgramCache& programs = context.programs;
    const RegularGrid& grid = volume.grid;
    const bool empty = medium.bricks.empty();
    const BoxM box = empty ? BoxM{glm::dvec3(0.0), grid.extentM()} : medium.bricks.occupied;
    const double voxelM = std::cbrt(grid.spacingM.x * grid.spacingM.y * grid.spacingM.z);
    plan_ = planSlices(inputs.camera, sunDirWorld(inputs.look), box, planesOf(inputs), voxelM);
    if (empty) plan_.count = 0;
    resize(inputs.sizePx);
    phases_.update(inputs.look, medium.plan);

    medium.first.bind(kMedium0Unit);
    if (medium.second) medium.second.bind(kMedium1Unit);
    medium.bricks.map.bind(kBricksUnit);
    if (const gl::Texture* noise = filteredNoise(medium.plan, context)) noise->bind(kNoiseUnit);
    light_.bind(kLightUnit);
    FrameBlock block = makeFrameBlock(inputs, grid, medium.bricks, medium.plan, plan_, context.sky);
    const auto upload = [&](int first, int slices) {
        block.slices.y = first;
        block.slices.z = slices;
        block_.write(&block, sizeof(block));
        block_.bind(GL_UNIFORM_BUFFER, block::kFrameBinding);
    };
    upload(0, 0);
    const auto names = defines(inputs.look, medium);
    measureSunShown(inputs, names, context);
    const glm::vec4 nothingYet{0.0f, 0.0f, 0.0f, 1.0f};
    glClearTexImage(eye_.name(), 0, GL_RGBA, GL_FLOAT, &nothingYet);

    // Of several batches only the last is held.
    const bool keepLight = frame.from > Stage::light && plan_.count <= batch_;
    context.stats.marchedLight = frame.from <= Stage::light;
    int lastLayer = -1;
    for (int first = 0; first < plan_.count; first += batch_) {
        const int slices = std::min(batch_, plan_.count - first);
        upload(first, slices);
        context.timer.pass("light");
        light_.open(lastLayer);
        if (!keepLight) {
            light_.march(
                programs.get("light/slice_light.comp", names),
                tilesOf(volume.blocks, volume.grid.spacingM * static_cast<double>(kBlockVoxels),
                        plan_, first, slices),
                context.progress);
        }
        context.timer.pass(kEyePass);
        marchEye(inputs, programs.get("slicing/eye.comp", names), context.progress);
        lastLayer = slices;
    }
    context.timer.pass("background");
    const gl::Program& background = programs.get("display/background.comp");
    background.setInt(kBackgroundLayerLocation, std::max(lastLayer, 0));
    eye_.bindImage(kBackgroundEyeImage, GL_READ_ONLY);
    frame.linear.bindImage(kBackgroundLinearImage, GL_WRITE_ONLY);
    background.dispatch({inputs.sizePx, 1});
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
}

void SlicingEngine::describe(const FrameInputs& inputs, RenderContext& context) {
    context.stats.planes = plan_.count;
    context.stats.lightSize = {plan_.lightSizePx, plan_.count};
    if (!inputs.profile) return;
    context.stats.bytesPerSample = bytesPerSample(context.medium.as<MediumTextures>().plan);
}

template <>
std::unique_ptr<Integrator> makeIntegrator<Engine::slicing>() {
    return std::make_unique<SlicingEngine>();
}

}  // namespace neph::render
