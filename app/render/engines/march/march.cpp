// march.cpp: choosing the light's slices and the eye's step, and running the passes.
#include "app/render/engines/march/march.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "app/render/engines/march/block_order.h"
#include "app/render/engines/march/march_defines.h"
#include "app/render/frame/frame_block.h"
#include "app/render/medium/noise_texture.h"
#include "core/look/sun.h"

namespace neph::render {

#include "shaders/shared/march_layout.glsl"

namespace block {
#include "shaders/shared/march_blocks.glsl"
}

namespace {

// Between two questions to `progress`; whole groups of the shader.
constexpr int kBandRows = 4 * kMarchEyeGroup;
// Size of a light texel in voxels, and in a draft.
constexpr double kLightTexelVoxels = 1.0, kDraftLightTexelVoxels = 2.0;
// Steps shorter than this many voxels can show detail finer than a voxel.
constexpr double kFineSteps = 1.05;
// Where their number is not fixed, steps are twice these, in voxels, at quality 1. Those that dim
// the image by more than this share are halved; detail has more that a step may miss.
constexpr double kShortestStep = 0.5, kShortestStepDetailed = 0.2;
constexpr float kMostDimming = 0.15f, kMostDimmingDetailed = 0.01f;
// Layers of light held at a time; fewer where they would take more than three quarters of a byte a
// voxel, as in flat domains, and more than what is little on any machine.
constexpr int kLightBatch = 16;
constexpr std::size_t kLittleBytes = std::size_t{512} << 10;
// Of a trilinear fetch of RG16F; of the mixture, one in four samples.
constexpr double kTrilinearBytes = 8.0 * 4.0, kNoiseBytes = 4.0;

double voxelM(const RegularGrid& grid) {
    return std::cbrt(grid.spacingM.x * grid.spacingM.y * grid.spacingM.z);
}

BoxM boxOf(const PackedMedium& medium, const RegularGrid& grid) {
    return medium.bricks.empty() ? BoxM{glm::dvec3(0.0), grid.extentM()} : medium.bricks.occupied;
}

SlicePlan lightPlan(const FrameInputs& inputs, const RegularGrid& grid,
                    const PackedMedium& medium) {
    const glm::dvec3 towardsSun = sunDirWorld(inputs.look);
    const BoxM box = boxOf(medium, grid);
    const double stepM =
        (inputs.draftLight ? kDraftLightTexelVoxels : kLightTexelVoxels) * voxelM(grid);
    return sidesRepeat(inputs.look) ? planRepeatedSlices(towardsSun, box, grid.extentM(), stepM)
                                    : planSunSlices(towardsSun, box, stepM);
}

/// Slices that are marched before their light goes to the medium.
int batchOf(const SlicePlan& plan, const RegularGrid& grid) {
    const std::size_t mostBytes = std::max(kLittleBytes, grid.cellCount() / 4 * 3);
    const int layers = layersThatFit(plan.lightSizePx, sizeof(std::uint16_t), mostBytes);
    return std::min({kLightBatch, plan.count, layers - 1});
}

/// Full transport shows radiance: its phase functions are physical.
Look shownLook(Look look) {
    if (scattersOften(look)) look.phaseDisplay = PhaseDisplay::physical;
    return look;
}

double diagonalOf(const BoxM& box) {
    return glm::length(box.sizeM());
}

double baseStepM(const FrameInputs& inputs, const RegularGrid& grid, const PackedMedium& medium) {
    return inputs.planes > 0 ? diagonalOf(boxOf(medium, grid)) / inputs.planes
                             : voxelM(grid) / static_cast<double>(inputs.sampling.quality);
}

/// Shortest steps per metre along each axis: a ray has as many as this vector, scaled by its
/// direction, is long.
///
/// Where the number of steps is not fixed, steps are one over the quality and less, in units of
/// the mean of a voxel's extent in the ray's direction and in all: layers are thinner than columns
/// are wide, and differ less.
glm::dvec3 stepsPerM(const FrameInputs& inputs, const RegularGrid& grid,
                     const PackedMedium& medium) {
    if (inputs.planes > 0) return glm::dvec3(inputs.planes / diagonalOf(boxOf(medium, grid)));
    const double voxels = isNoisy(medium.plan) ? kShortestStepDetailed : kShortestStep;
    return static_cast<double>(inputs.sampling.quality) / voxels /
           glm::sqrt(grid.spacingM * voxelM(grid));
}

/// How much of the detail the medium should hold for an image: steps that are too long to show
/// more than the voxels' need none of their own.
PackedDetail detailFor(const FrameInputs& inputs, const RegularGrid& grid,
                       const PackedMedium& medium) {
    const bool fine = baseStepM(inputs, grid, medium) < kFineSteps * voxelM(grid);
    return fine && isNoisy(medium.look) ? PackedDetail::none : PackedDetail::voxels;
}

/// Null where there is no detail.
const gl::Texture* stackedNoise(const MediumPlan& plan, RenderContext& context) {
    return isNoisy(plan) ? &context.noise.stacked(context.programs, context.timer) : nullptr;
}

/// Has the medium hold the detail that is wanted.
void repack(const Look& look, PackedDetail wanted, PackedMedium& medium, RenderContext& context) {
    if (medium.detail == wanted) return;
    context.timer.pass("bake detail");
    repackMedium(context.volume, look, wanted, stackedNoise(medium.look, context), context.programs,
                 medium);
    context.stats.bakedMedium = true;
}

}  // namespace

Stage MarchEngine::stageFor(const FrameInputs& inputs, std::optional<Stage> changed) const {
    const bool finer = lightIsDraft_ && !inputs.draftLight;
    if (changed && hasNewerLight()) *changed = std::min(Stage::eye, *changed);
    if (changed) return finer ? std::min(Stage::light, *changed) : *changed;
    if (!lit_) return Stage::medium;
    return std::min(finer ? Stage::light : Stage::eye,
                    firstDifference(*lit_, inputs.look).value_or(Stage::eye));
}

bool MarchEngine::hasNewerLight() const {
    return full_ && diffuse_->hasNewer();
}

void MarchEngine::prepare(const Look& look, RenderContext& context) {
    const MediumPlan plan = planMedium(look, context.volume);
    const gl::Texture* noise = stackedNoise(plan, context);
    context.medium.update<PackedMedium>(plan, [&](PackedMedium& medium) {
        context.timer.pass("bake medium");
        lit_.reset();
        packMedium(context.volume, look, noise, context.programs, medium);
        context.stats.bakedMedium = true;
    });
}

void MarchEngine::render(const FrameRequest& frame, RenderContext& context) {
    const FrameInputs& inputs = frame.inputs;
    PackedMedium& medium = context.medium.as<PackedMedium>();
    if (frame.from <= Stage::light) {
        lit_.reset();
        repack(inputs.look, PackedDetail::voxels, medium, context);
        takeLightNodes(frame, medium, context);
        carryLight(frame, medium, context);
        lit_ = inputs.look;
        lightIsDraft_ = inputs.draftLight;
        context.stats.marchedLight = true;
    }
    if (full_ && frame.sample == 0) {  // else it belongs to an image that has its light
        context.timer.pass("light solved");
        diffuse_->update(inputs.look, context.sky, inputs.settledLight, context.progress);
    }
    repack(inputs.look, detailFor(inputs, context.volume.grid, medium), medium, context);
    phases_.update(shownLook(inputs.look), medium.plan);
    bind(frame, medium, context, {0, lastLayer_});
    if (frame.sample == 0) measureSunShown(inputs, marchDefines(inputs.look, medium), context);
    if (full_) {
        context.timer.pass("light to eye");
        if (frame.sample == 0) {
            diffuse_->lookFrom(
                bound_, context.sky,
                context.programs.get("march/source_to_eye.comp",
                                     {fmt::format("BALANCED {}", diffuse_->isBalanced() ? 1 : 0),
                                      fmt::format("PERIODIC {}", plan_.repeats ? 1 : 0)}));
        }
        diffuse_->bind();
    }
    if (bound_.cloudyAir.w > 0.0f) lookThroughAir(frame, context);
    context.timer.pass(kEyePass);
    if (inputs.profile) openCounts(inputs.sizePx);
    march(frame, context.programs.get("march/eye.comp", eyeNames(inputs, medium, false)),
          context.progress);
}

std::vector<std::string> MarchEngine::eyeNames(const FrameInputs& inputs,
                                               const PackedMedium& medium, bool floor) const {
    return eyeDefines(inputs, medium, full_ && diffuse_->isBalanced(), floor);
}

/// What clouds change of the light that air sends to the eye.
void MarchEngine::lookThroughAir(const FrameRequest& frame, RenderContext& context) {
    context.timer.pass("air among clouds");
    const std::string periodic = fmt::format("PERIODIC {}", plan_.repeats ? 1 : 0);
    const gl::Program& program = context.programs.get(
        "march/cloudy_air.comp", {fmt::format("FULL {}", full_ ? 1 : 0), periodic});
    if (full_) {
        if (frame.sample == 0) {
            diffuse_->lookAround(context.programs.get("march/light_around.comp", {periodic}));
        }
        diffuse_->placeAround(program);
    }
    cloudyAir_.look(bound_, program);
}

void MarchEngine::bind(const FrameRequest& frame, const PackedMedium& medium,
                       RenderContext& context, glm::ivec2 batch) {
    const FrameInputs& inputs = frame.inputs;
    const RegularGrid& grid = context.volume.grid;
    const bool fixed = inputs.planes > 0;
    const glm::dvec3 perM = stepsPerM(inputs, grid, medium);
    const double shortest = glm::length(boxOf(medium, grid).sizeM() * perM);
    steps_ = static_cast<int>(std::lround(fixed ? shortest : 0.5 * shortest));
    FrameBlock block = makeFrameBlock(inputs, grid, medium.bricks, medium.plan, plan_, context.sky);
    block.slices.y = batch.x;
    block.slices.z = batch.y;
    block.sampling.x = frame.sample;
    const float mostDimming = isNoisy(medium.plan) ? kMostDimmingDetailed : kMostDimming;
    block.march = glm::vec4(glm::vec3(perM), mostDimming / inputs.sampling.quality);
    if (full_) diffuse_->fill(block, inputs.look, medium.plan.classes, context.sky);
    if (context.sky.hasAir() && plan_.count > 0) CloudyAir::fill(block, plan_.repeats);
    bound_ = block;
    block_.write(&block, sizeof(block));
    block_.bind(GL_UNIFORM_BUFFER, block::kFrameBinding);
    medium.extinction.bind(kMarchExtinctionUnit);
    medium.first.bind(kMarchMixture0Unit);
    medium.bricks.map.bind(kBricksUnit);
    if (const gl::Texture* noise = stackedNoise(medium.plan, context)) noise->bind(kNoiseUnit);
    light_.bind(kLightUnit);
    if (medium.second) medium.second.bind(kMarchMixture1Unit);
}

/// Has the voxels of light hold the medium, where the look asks for them.
void MarchEngine::takeLightNodes(const FrameRequest& frame, const PackedMedium& medium,
                                 RenderContext& context) {
    const Look& look = frame.inputs.look;
    full_ = scattersOften(look);
    if (!full_) return;  // what is known of the medium stays, for when it is wanted again
    const std::tuple nodesOf{context.medium.version(), frame.inputs.sampling.lightVoxels,
                             sidesRepeat(look)};
    if (diffuse_ && diffuseOf_ == nodesOf) return;
    context.timer.pass("light voxels");
    if (!diffuse_) diffuse_.emplace(context.wake);
    bind(frame, medium, context, {0, 0});
    diffuse_->takeMedium(
        frame.inputs, context.volume.grid, medium,
        context.programs.get("march/light_nodes.comp", marchDefines(look, medium)));
    diffuseOf_ = nodesOf;
}

/// Carries sunlight through the medium and leaves it there, at every voxel. The medium holds the
/// voxels' detail.
void MarchEngine::carryLight(const FrameRequest& frame, const PackedMedium& medium,
                             RenderContext& context) {
    context.timer.pass("light");
    const FrameInputs& inputs = frame.inputs;
    const VolumeTextures& volume = context.volume;
    const RegularGrid& grid = volume.grid;
    plan_ = lightPlan(inputs, grid, medium);
    if (medium.bricks.empty()) plan_.count = 0;
    if (full_) diffuse_->bind();
    const int batch = batchOf(plan_, grid);
    light_.resize(plan_.lightSizePx, batch + 1, GL_R16, plan_.repeats);
    light_.open(-1);
    lastLayer_ = 0;
    cloudyAir_.open(plan_);
    const BlockOrder blocks(volume, plan_);
    const auto names = marchDefines(inputs.look, medium);
    for (int first = 0; first < plan_.count; first += batch) {
        const int slices = std::min(batch, plan_.count - first);
        if (first > 0) light_.open(lastLayer_);
        bind(frame, medium, context, {first, slices});
        context.timer.pass("light");
        light_.march(context.programs.get("light/slice_light.comp", names),
                     tilesOf(volume.blocks, grid.spacingM * static_cast<double>(kBlockVoxels),
                             plan_, first, slices),
                     context.progress);
        context.timer.pass("light to medium");
        lightToMedium(blocks.within(first, slices), medium, context.programs);
        cloudyAir_.keep(plan_, first, slices, context.programs.get("march/sun_through.comp"));
        lastLayer_ = slices;
    }
}

/// What arrived within the batch of layers that is held.
void MarchEngine::lightToMedium(const std::vector<glm::ivec4>& blocks, const PackedMedium& medium,
                                gl::ProgramCache& programs) {
    if (blocks.empty()) return;
    blocks_.write(blocks.data(), blocks.size() * sizeof(glm::ivec4));
    blocks_.bind(GL_SHADER_STORAGE_BUFFER, kMarchBlocksBuffer);
    medium.extinction.bindImage(kMarchExtinctionImage, GL_READ_WRITE);
    programs.get("march/light_to_medium.comp").dispatchGroups(static_cast<int>(blocks.size()));
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void MarchEngine::march(const FrameRequest& frame, const gl::Program& program,
                        const Progress& progress) {
    const glm::ivec2 sizePx = frame.inputs.sizePx;
    if (!blueNoise_) blueNoise_ = uploadBlueNoise();
    blueNoise_.bind(kMarchBlueNoiseUnit);
    phases_.bind();
    frame.linear.bindImage(kMarchLinearImage, GL_READ_WRITE);
    program.setFloat(kMarchBlendLocation, 1.0f / static_cast<float>(frame.sample + 1));
    for (int row = 0; row < sizePx.y; row += kBandRows) {
        if (!goOn(progress, static_cast<double>(row) / sizePx.y)) throw Cancelled{};
        program.setInt(kMarchFirstRowLocation, row);
        program.dispatch({sizePx.x, std::min(kBandRows, sizePx.y - row), 1});
    }
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
}

/// Has the eye pass count its samples.
void MarchEngine::openCounts(glm::ivec2 sizePx) {
    const block::CountBlock zeros{};
    counts_.write(&zeros, sizeof(zeros));
    counts_.bind(GL_SHADER_STORAGE_BUFFER, kMarchCountsBuffer);
    if (taken_.size() != glm::ivec3(sizePx, 1)) {
        taken_ = gl::Texture::make2D(GL_R32UI, sizePx);
    }
    taken_.bindImage(kMarchTakenImage, GL_WRITE_ONLY);
}

bool MarchEngine::floor(const FrameRequest& frame, RenderContext& context) {
    const RegularGrid& grid = context.volume.grid;
    const PackedMedium& medium = context.medium.as<PackedMedium>();
    bind(frame, medium, context, {0, lastLayer_});
    if (floor_.size() != grid.size) {
        floor_ = gl::Texture::make3D(GL_RGBA16, grid.size);
        floor_.setLinear();
        glClearTexImage(floor_.name(), 0, GL_RGBA, GL_FLOAT, nullptr);
    }
    floor_.bind(kMarchFloorUnit);
    taken_.bindImage(kMarchTakenImage, GL_READ_ONLY);
    march(frame, context.programs.get("march/eye.comp", eyeNames(frame.inputs, medium, true)), {});
    return true;
}

/// Waits for the eye pass.
SampleCounts MarchEngine::counts() const {
    block::CountBlock counted{};
    glGetNamedBufferSubData(counts_.name(), 0, sizeof(counted), &counted);
    return {counted.rays, counted.taken, counted.skipped, counted.terminated};
}

void MarchEngine::describe(const FrameInputs& inputs, RenderContext& context) {
    context.stats.planes = steps_;
    context.stats.lightSize = {plan_.lightSizePx, plan_.count};
    if (full_) context.stats.light = diffuse_->progress();
    if (!inputs.profile) return;
    const MediumPlan& plan = context.medium.as<PackedMedium>().look;
    const double mixtures = plan.classes.size() > kClassesBesideSkylight ? 2.0 : 1.0;
    context.stats.bytesPerSample =
        kTrilinearBytes * (1.0 + mixtures / 4.0) + (isNoisy(plan) ? kNoiseBytes : 0.0);
    if (context.stats.marchedEye) context.stats.samples = counts();
}

std::size_t MarchEngine::otherBytes() const {
    return phases_.bytes() + cloudyAir_.bytes() + block_.bytes() + blueNoise_.bytes() +
           taken_.bytes() + floor_.bytes();
}

template <>
std::unique_ptr<Integrator> makeIntegrator<Engine::march>() {
    return std::make_unique<MarchEngine>();
}

}  // namespace neph::render
