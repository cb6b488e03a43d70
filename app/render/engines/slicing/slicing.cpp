// slicing.cpp: running the passes batch by batch.
#include "app/render/engines/slicing/slicing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "app/render/frame/frame_block.h"

namespace neph::render {

#include "shaders/shared/display_layout.glsl"
#include "shaders/shared/slicing_layout.glsl"

namespace {

// Bound on the light layers held at a time.
constexpr std::size_t kLightBytes = std::size_t{128} << 20;
// Between two questions to `progress`, a few milliseconds on the slowest machine. Rows are whole
// groups of the shader.
constexpr int kBandRows = 4 * kSlicingEyeGroup;

std::vector<std::string> defines(const Look& look, const MediumTextures& medium) {
    std::vector<std::string> names =
        lightDefines(look, medium.plan, look.lightForm == LightForm::consistent);
    names.push_back(fmt::format("CLASS_TEXTURES {}", medium.textureCount()));
    names.push_back("PACKED 0");
    names.push_back("LIGHT_FORMAT r32f");
    return names;
}

int planesOf(const FrameInputs& inputs) {
    return inputs.planes > 0 ? inputs.planes : inputs.look.planes;
}

}  // namespace

void SlicingEngine::resize(const FrameInputs& inputs) {
    const int most = layersThatFit(plan_.lightSizePx, sizeof(float), kLightBytes) - 1;
    batch_ = std::clamp(plan_.count, 1, most);
    light_.resize(plan_.lightSizePx, batch_ + 1, GL_R32F);
    if (eye_.size() != glm::ivec3(inputs.sizePx, 1)) {
        eye_ = gl::Texture::make2D(GL_RGBA32F, inputs.sizePx);
    }
}

void SlicingEngine::marchEye(const FrameInputs& inputs, const gl::Program& program,
                             const Progress& progress) {
    phases_.bind();
    eye_.bindImage(kSlicingEyeImage, GL_READ_WRITE);
    for (int row = 0; row < inputs.sizePx.y; row += kBandRows) {
        if (!goOn(progress, static_cast<double>(row) / inputs.sizePx.y)) throw Cancelled{};
        program.setInt(kSlicingFirstRowLocation, row);
        program.dispatch({inputs.sizePx.x, std::min(kBandRows, inputs.sizePx.y - row), 1});
    }
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

void SlicingEngine::render(const FrameInputs& inputs, const VolumeTextures& volume,
                           const MediumTextures& medium, const gl::Texture* noise,
                           gl::ProgramCache& programs, const gl::Texture& linear, bool lightIsValid,
                           const Progress& progress, gl::PassTimer& timer) {
    const RegularGrid& grid = volume.grid;
    const bool empty = medium.bricks.empty();
    const SliceBox box = empty ? SliceBox{glm::dvec3(0.0), grid.extentM()} : medium.bricks.occupied;
    const double voxelM = std::cbrt(grid.spacingM.x * grid.spacingM.y * grid.spacingM.z);
    plan_ = planSlices(inputs.camera, sunDirWorld(inputs.look), box, planesOf(inputs), voxelM);
    if (empty) plan_.count = 0;
    resize(inputs);
    phases_.update(inputs.look, medium.plan);

    medium.first.bind(kMedium0Unit);
    if (medium.second) medium.second.bind(kMedium1Unit);
    medium.bricks.map.bind(kBricksUnit);
    if (noise) noise->bind(kNoiseUnit);
    light_.bind(kLightUnit);
    FrameBlock block = makeFrameBlock(inputs, grid, medium.bricks, medium.plan, plan_);
    const auto upload = [&](int first, int slices) {
        block.slices.y = first;
        block.slices.z = slices;
        block_.write(&block, sizeof(block));
        block_.bind(GL_UNIFORM_BUFFER, block::kFrameBinding);
    };
    upload(0, 0);
    const glm::vec4 nothingYet{0.0f, 0.0f, 0.0f, 1.0f};
    glClearTexImage(eye_.name(), 0, GL_RGBA, GL_FLOAT, &nothingYet);

    const auto names = defines(inputs.look, medium);
    const bool keepLight =
        lightIsValid && plan_.count <= batch_;  // of several batches only the last is held
    int lastLayer = -1;
    for (int first = 0; first < plan_.count; first += batch_) {
        const int slices = std::min(batch_, plan_.count - first);
        upload(first, slices);
        timer.pass("light");
        light_.open(lastLayer);
        if (!keepLight) {
            light_.march(
                programs.get("light/slice_light.comp", names),
                tilesOf(volume.blocks, volume.grid.spacingM * static_cast<double>(kBlockVoxels),
                        plan_, first, slices),
                progress);
        }
        timer.pass("eye");
        marchEye(inputs, programs.get("slicing/eye.comp", names), progress);
        lastLayer = slices;
    }
    timer.pass("background");
    const gl::Program& background = programs.get("display/background.comp");
    background.setInt(kBackgroundLayerLocation, std::max(lastLayer, 0));
    eye_.bindImage(kBackgroundEyeImage, GL_READ_ONLY);
    linear.bindImage(kBackgroundLinearImage, GL_WRITE_ONLY);
    background.dispatch({inputs.sizePx, 1});
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
}

}  // namespace neph::render
