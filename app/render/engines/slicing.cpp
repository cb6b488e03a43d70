// slicing.cpp: filling the frame's block and running the passes batch by batch.
#include "app/render/engines/slicing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "shaders/lib/glsl_cpp.h"

namespace neph::render {
namespace {

using namespace glm;
#include "shaders/shared/slicing_block.glsl"
static_assert(sizeof(SlicingBlock) == 21 * 16 + kMaxClasses * 32, "std140 and C++ agree");

constexpr std::size_t kLightBytes = std::size_t{128}
                                    << 20;  // bound on the light layers held at a time
// Between two questions to `progress`, a few milliseconds on the slowest machine. Rows are whole
// groups of the shader.
constexpr int kBandRows = 32, kBandSlices = 8;
constexpr float kOpaque = 1e-4f;          // transmittance below which the eye sees no further
constexpr double kRingShare = 3.0 / 8.0;  // of θ_f: the middle of the ring. docs/physics.md §3

vec4 v4(dvec3 v, double w = 0.0) {
    return {vec3(v), static_cast<float>(w)};
}

ClassBlock classBlock(const MediumClass& c) {
    const float perTile = 1.0f / (glsl::kDetailFeaturesPerTile * c.noiseScaleM);
    const float character = c.noiseCharacter == NoiseCharacter::billow ? 0.0f : 1.0f;
    return {vec4(c.colour * c.albedo, c.albedo), vec4(c.noiseAmount, perTile, character, 0.0f)};
}

void fillView(SlicingBlock& block, const Camera& camera, const RegularGrid& grid,
              const SlicePlan& plan) {
    block.eyeM = v4(camera.eyeWorld - grid.originM, grid.originM.z);
    block.forward = v4(camera.forward, plan.frontToBack ? 1.0 : -1.0);
    block.right = v4(camera.right * camera.tanHalfFovY * camera.aspect);
    block.up = v4(camera.up * camera.tanHalfFovY);
}

void fillLight(SlicingBlock& block, const Look& look, const SlicePlan& plan) {
    const ForwardShares shares = forwardShares(look);
    const double ringM =
        plan.lightStepM *
        std::tan(glm::radians(static_cast<double>(look.forwardAngleDeg)) * kRingShare);
    block.normal = v4(plan.normal, plan.firstM);
    block.towardsSun = v4(sunDirWorld(look), plan.lightStepM);
    block.lightU = v4(plan.lightU, plan.lightLowerM.x);
    block.lightV = v4(plan.lightV, plan.lightLowerM.y);
    block.lightScale = vec4(vec2(1.0 / plan.lightExtentM), plan.spacingM, ringM);
    block.forwardShare = {shares.inner, shares.outer, kOpaque, 0.0f};
}

void fillSky(SlicingBlock& block, const Look& look) {
    const vec3 zenith = look.skyZenith * look.skyIntensity;
    const vec3 horizon = look.skyHorizon * look.skyIntensity;
    block.sunRadiance = vec4(look.sunColour * look.sunIntensity, 0.0f);
    block.skyZenith = vec4(zenith, 0.0f);
    block.skyHorizon = vec4(horizon, 0.0f);
    block.ambient = vec4(0.5f * (zenith + horizon) * look.skylight, 0.0f);
    block.ground = vec4(look.groundColour, look.groundVisible ? 1.0f : 0.0f);
}

SlicingBlock fillBlock(const FrameInputs& inputs, const RegularGrid& grid,
                       const MediumTextures& medium, const SlicePlan& plan) {
    SlicingBlock block{};
    fillView(block, inputs.camera, grid, plan);
    fillLight(block, inputs.look, plan);
    fillSky(block, inputs.look);
    block.boxLowerM = v4(medium.occupied.lowerM);
    block.boxUpperM = v4(medium.occupied.upperM);
    block.gridExtentM = v4(grid.extentM());
    block.brickM = v4(medium.brickM);
    block.slices = {plan.count, 0, 0, static_cast<int>(medium.plan.classes.size())};
    block.picture = {inputs.sizePx, plan.lightSizePx};
    for (std::size_t i = 0; i < medium.plan.classes.size(); ++i) {
        block.classes[i] = classBlock(medium.plan.classes[i]);
    }
    return block;
}

std::vector<std::string> defines(const Look& look, const MediumTextures& medium) {
    const bool noisy = std::any_of(medium.plan.classes.begin(), medium.plan.classes.end(),
                                   [](const MediumClass& c) { return c.noiseAmount > 0.0f; });
    return {fmt::format("CLASS_TEXTURES {}", medium.textureCount()),
            fmt::format("CLASSES {}", medium.plan.classes.size()),
            fmt::format("PHASE_TABLE_SIZE {}", kPhaseTableSize),
            fmt::format("NOISE {}", noisy ? 1 : 0),
            fmt::format("TRANSLUCENT {}", look.transport == Transport::translucent ? 1 : 0),
            fmt::format("CONSISTENT {}", look.lightForm == LightForm::consistent ? 1 : 0)};
}

int planesOf(const FrameInputs& inputs) {
    return inputs.planes > 0 ? inputs.planes : inputs.look.planes;
}

}  // namespace

void SlicingEngine::resize(const FrameInputs& inputs) {
    const std::size_t layerBytes = static_cast<std::size_t>(plan_.lightSizePx.x) *
                                   static_cast<std::size_t>(plan_.lightSizePx.y) * sizeof(float);
    GLint maxLayers = 0;
    glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &maxLayers);
    const int most = std::min(static_cast<int>(kLightBytes / layerBytes), maxLayers) - 1;
    batch_ = std::clamp(plan_.count, 1, std::max(most, 1));
    const glm::ivec3 wanted{plan_.lightSizePx, batch_ + 1};
    if (light_.size() != wanted) {
        light_ = gl::Texture::make2DArray(GL_R32F, plan_.lightSizePx, batch_ + 1);
        light_.setLinear();
    }
    if (eye_.size() != glm::ivec3(inputs.sizePx, 1)) {
        eye_ = gl::Texture::make2D(GL_RGBA32F, inputs.sizePx);
    }
}

void SlicingEngine::uploadPhases(const Look& look, const MediumPlan& plan) {
    const bool same = havePhases_ && phasePlan_ == plan &&
                      phaseLook_.phaseDisplay == look.phaseDisplay &&
                      phaseLook_.phaseTruncationDeg == look.phaseTruncationDeg;
    if (same) return;
    std::vector<glm::vec4> values;
    values.reserve(plan.classes.size() * kPhaseTableSize + 1);
    for (const PhaseTable& table : displayPhases(look, plan)) {
        for (const glm::vec3& value : table) values.emplace_back(value, 0.0f);
    }
    if (values.empty()) values.emplace_back(0.0f);  // a buffer that is bound must have a size
    phases_.write(values.data(), values.size() * sizeof(glm::vec4));
    phaseLook_ = look;
    phasePlan_ = plan;
    havePhases_ = true;
}

void SlicingEngine::marchLight(const gl::Program& program, int slices, const Progress& progress) {
    light_.bindImage(0, GL_WRITE_ONLY);
    for (int layer = 0; layer < slices; ++layer) {
        if (layer % kBandSlices == 0 && !goOn(progress, 0.0)) throw Cancelled{};
        program.setInt(0, layer);
        program.dispatch({plan_.lightSizePx, 1});
        glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
    }
}

/// Layer 0 takes over from the last layer of the batch before, or full light (-1).
void SlicingEngine::carryLight(int fromLayer) {
    const glm::ivec2 size = plan_.lightSizePx;
    if (fromLayer < 0) {
        const float full = 1.0f;
        glClearTexSubImage(light_.name(), 0, 0, 0, 0, size.x, size.y, 1, GL_RED, GL_FLOAT, &full);
    } else {
        glCopyImageSubData(light_.name(), GL_TEXTURE_2D_ARRAY, 0, 0, 0, fromLayer, light_.name(),
                           GL_TEXTURE_2D_ARRAY, 0, 0, 0, 0, size.x, size.y, 1);
    }
}

/// Light and eye for the slices of one batch; returns the layer that holds the light behind them.
int SlicingEngine::marchBatch(const FrameInputs& inputs, const MediumTextures& medium,
                              gl::ProgramCache& programs, int slices, bool keepLight,
                              const Progress& progress) {
    const auto names = defines(inputs.look, medium);
    if (!keepLight) marchLight(programs.get("pass/slice_light.comp", names), slices, progress);
    phases_.bind(GL_SHADER_STORAGE_BUFFER, 0);
    eye_.bindImage(0, GL_READ_WRITE);
    const gl::Program& eye = programs.get("pass/slice_eye.comp", names);
    for (int row = 0; row < inputs.sizePx.y; row += kBandRows) {
        if (!goOn(progress, static_cast<double>(row) / inputs.sizePx.y)) throw Cancelled{};
        eye.setInt(0, row);
        eye.dispatch({inputs.sizePx.x, std::min(kBandRows, inputs.sizePx.y - row), 1});
    }
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    return slices;
}

void SlicingEngine::render(const FrameInputs& inputs, const RegularGrid& grid,
                           const MediumTextures& medium, const gl::Texture* noise,
                           gl::ProgramCache& programs, const gl::Texture& linear, bool lightIsValid,
                           const Progress& progress) {
    const SliceBox box =
        medium.empty() ? SliceBox{glm::dvec3(0.0), grid.extentM()} : medium.occupied;
    const double voxelM = std::cbrt(grid.spacingM.x * grid.spacingM.y * grid.spacingM.z);
    plan_ = planSlices(inputs.camera, sunDirWorld(inputs.look), box, planesOf(inputs), voxelM);
    if (medium.empty()) plan_.count = 0;
    resize(inputs);
    uploadPhases(inputs.look, medium.plan);

    medium.first.bind(0);
    if (medium.second) medium.second.bind(1);
    medium.emptiness.bind(2);
    if (noise) noise->bind(3);
    light_.bind(4);
    SlicingBlock block = fillBlock(inputs, grid, medium, plan_);
    const auto upload = [&](int first, int slices) {
        block.slices.y = first;
        block.slices.z = slices;
        block_.write(&block, sizeof(block));
        block_.bind(GL_UNIFORM_BUFFER, 0);
    };
    upload(0, 0);
    const glm::vec4 nothingYet{0.0f, 0.0f, 0.0f, 1.0f};
    glClearTexImage(eye_.name(), 0, GL_RGBA, GL_FLOAT, &nothingYet);

    const bool keepLight =
        lightIsValid && plan_.count <= batch_;  // of several batches only the last is held
    int lastLayer = -1;
    for (int first = 0; first < plan_.count; first += batch_) {
        const int slices = std::min(batch_, plan_.count - first);
        upload(first, slices);
        carryLight(lastLayer);
        lastLayer = marchBatch(inputs, medium, programs, slices, keepLight, progress);
    }
    const gl::Program& background = programs.get("pass/background.comp");
    background.setInt(0, std::max(lastLayer, 0));
    eye_.bindImage(0, GL_READ_ONLY);
    linear.bindImage(1, GL_WRITE_ONLY);
    background.dispatch({inputs.sizePx, 1});
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
}

}  // namespace neph::render
