// march.cpp: choosing the light's slices and the eye's step, and running the passes.
#include "app/render/engines/march/march.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "app/render/frame/frame_block.h"
#include "app/render/medium/detail_kinds.h"
#include "app/render/medium/noise_texture.h"
#include "core/optics/blue_noise.h"

namespace neph::render {
namespace {

constexpr int kBandRows = 32;  // between two questions to `progress`; whole groups of the shader
// Size of a light texel in voxels, and in a draft.
constexpr double kLightTexelVoxels = 1.0, kDraftLightTexelVoxels = 2.0;
// Steps shorter than this many voxels can show detail finer than a voxel.
constexpr double kFineSteps = 1.05;
// Layers of light held at a time; fewer where they would take more than three quarters of a byte a
// voxel, as in flat domains, and more than what is little on any machine.
constexpr int kLightBatch = 16;
constexpr std::size_t kLittleBytes = std::size_t{512} << 10;
// Steps adapt to the data: as long as makes this optical depth, within these multiples of the base.
constexpr float kStepOpticalDepth = 0.5f, kShortestStep = 0.5f, kLongestStep = 2.0f;

double voxelM(const RegularGrid& grid) {
    return std::cbrt(grid.spacingM.x * grid.spacingM.y * grid.spacingM.z);
}

SliceBox boxOf(const PackedMedium& medium, const RegularGrid& grid) {
    return medium.bricks.empty() ? SliceBox{glm::dvec3(0.0), grid.extentM()}
                                 : medium.bricks.occupied;
}

/// Slices that are marched before their light goes to the medium.
int batchOf(const SlicePlan& plan, const RegularGrid& grid) {
    const std::size_t mostBytes = std::max(kLittleBytes, grid.cellCount() / 4 * 3);
    const int layers = layersThatFit(plan.lightSizePx, sizeof(std::uint16_t), mostBytes);
    return std::min({kLightBatch, plan.count, layers - 1});
}

/// The blocks that may hold anything, by the layers of light that pass through them.
class BlockOrder {
  public:
    BlockOrder(const VolumeTextures& volume, const SlicePlan& plan) {
        const glm::dvec3 blockM = volume.grid.spacingM * static_cast<double>(kBlockVoxels);
        // Half the extent of a block along the light.
        const double reachM = 0.5 * glm::dot(glm::abs(plan.normal), blockM);
        for (const glm::ivec3 block : volume.blocks) {
            const glm::dvec3 middleM = (glm::dvec3(block) + 0.5) * blockM;
            const double alongM = glm::dot(plan.normal, middleM) - plan.firstM;
            const auto layer = [&](double m) {  // what lies before or behind all has an end's light
                return std::clamp(m / plan.spacingM, 0.0, static_cast<double>(plan.count));
            };
            blocks_.push_back(
                {glm::ivec4(block, 0), layer(alongM - reachM), layer(alongM + reachM)});
        }
    }

    /// Those that lie between layers `first` and `first + slices`, if only in part.
    std::vector<glm::ivec4> within(int first, int slices) const {
        std::vector<glm::ivec4> found;
        for (const Spanned& each : blocks_) {
            if (each.last >= first && each.first <= first + slices) found.push_back(each.block);
        }
        return found;
    }

  private:
    struct Spanned {
        glm::ivec4 block;
        double first, last;  ///< layers
    };
    std::vector<Spanned> blocks_;
};

std::vector<std::string> defines(const Look& look, const PackedMedium& medium) {
    std::vector<std::string> names = lightDefines(look, medium.plan, true);
    names.push_back("PACKED 1");
    names.push_back("LIGHT_FORMAT r16");
    names.push_back(fmt::format("MIXTURE_TEXTURES {}", medium.mixtureCount()));
    return names;
}

DetailKinds kindsOf(const MediumPlan& plan) {
    std::vector<Detail> details;
    for (const MediumClass& c : plan.classes) {
        details.push_back({c.noiseAmount, c.noiseScaleM, c.noiseCharacter});
    }
    return render::kindsOf(details);
}

std::vector<std::string> eyeDefines(const FrameInputs& inputs, const PackedMedium& medium,
                                    bool floor) {
    std::vector<std::string> names = defines(inputs.look, medium);
    names.push_back(fmt::format("PHASE_TABLE_SIZE {}", kPhaseTableSize));
    names.push_back(fmt::format("PROFILE {}", inputs.profile && !floor ? 1 : 0));
    names.push_back(fmt::format("FLOOR {}", floor ? 1 : 0));
    if (!isNoisy(medium.plan)) return names;
    const DetailKinds kinds = kindsOf(medium.plan);
    names.push_back(fmt::format("NOISE_SIZE {}.0", kNoiseSize));
    names.push_back(fmt::format("KINDS {}", kinds.first.size()));
    names.push_back(fmt::format("KIND_OF_CLASS int[]({})", fmt::join(kinds.of, ", ")));
    names.push_back(fmt::format("CLASS_OF_KIND int[]({})", fmt::join(kinds.first, ", ")));
    return names;
}

double diagonalOf(const SliceBox& box) {
    return glm::length(box.upperM - box.lowerM);
}

double baseStepM(const FrameInputs& inputs, const RegularGrid& grid, const PackedMedium& medium) {
    return inputs.planes > 0 ? diagonalOf(boxOf(medium, grid)) / inputs.planes
                             : voxelM(grid) / static_cast<double>(inputs.sampling.quality);
}

gl::Texture uploadBlueNoise() {
    gl::Texture texture = gl::Texture::make2D(GL_R32F, glm::ivec2(kBlueNoiseSize));
    texture.upload(GL_RED, GL_FLOAT, blueNoise().data());
    return texture;
}

}  // namespace

PackedDetail MarchEngine::detailFor(const FrameInputs& inputs, const RegularGrid& grid,
                                    const PackedMedium& medium) {
    const bool fine = baseStepM(inputs, grid, medium) < kFineSteps * voxelM(grid);
    return fine && isNoisy(medium.look) ? PackedDetail::none : PackedDetail::voxels;
}

void MarchEngine::bind(const FrameInputs& inputs, const RegularGrid& grid,
                       const PackedMedium& medium, const gl::Texture* noise, glm::ivec2 batch) {
    const double diagonalM = diagonalOf(boxOf(medium, grid));
    const bool fixed = inputs.planes > 0;
    const double stepM = fixed ? diagonalM / inputs.planes
                               : voxelM(grid) / static_cast<double>(inputs.sampling.quality);
    steps_ = static_cast<int>(std::lround(diagonalM / stepM));
    FrameBlock block = makeFrameBlock(inputs, grid, medium.bricks, medium.plan, plan_);
    block.slices.y = batch.x;
    block.slices.z = batch.y;
    block.march = {static_cast<float>(stepM), kStepOpticalDepth / inputs.sampling.quality,
                   fixed ? 1.0f : kShortestStep, fixed ? 1.0f : kLongestStep};
    block_.write(&block, sizeof(block));
    block_.bind(GL_UNIFORM_BUFFER, 0);
    medium.extinction.bind(0);
    medium.first.bind(1);
    medium.bricks.map.bind(2);
    if (noise) noise->bind(3);
    light_.bind(4);
    if (medium.second) medium.second.bind(5);
}

void MarchEngine::light(const FrameInputs& inputs, const VolumeTextures& volume,
                        PackedMedium& medium, gl::ProgramCache& programs, const Progress& progress,
                        gl::PassTimer& timer) {
    timer.pass("light");
    const RegularGrid& grid = volume.grid;
    plan_ = planSunSlices(
        sunDirWorld(inputs.look), boxOf(medium, grid),
        (inputs.draftLight ? kDraftLightTexelVoxels : kLightTexelVoxels) * voxelM(grid));
    if (medium.bricks.empty()) plan_.count = 0;
    const int batch = batchOf(plan_, grid);
    light_.resize(plan_.lightSizePx, batch + 1, GL_R16);
    light_.open(-1);
    lastLayer_ = 0;
    const BlockOrder blocks(volume, plan_);
    const auto names = defines(inputs.look, medium);
    for (int first = 0; first < plan_.count; first += batch) {
        const int slices = std::min(batch, plan_.count - first);
        if (first > 0) light_.open(lastLayer_);
        bind(inputs, grid, medium, nullptr, {first, slices});
        timer.pass("light");
        light_.march(
            programs.get("light/slice_light.comp", names),
            tilesOf(volume.blocks, volume.grid.spacingM * static_cast<double>(kBlockVoxels), plan_,
                    first, slices),
            progress);
        timer.pass("light to medium");
        lightToMedium(blocks.within(first, slices), medium, programs);
        lastLayer_ = slices;
    }
}

/// What arrived within the batch of layers that is held.
void MarchEngine::lightToMedium(const std::vector<glm::ivec4>& blocks, const PackedMedium& medium,
                                gl::ProgramCache& programs) {
    if (blocks.empty()) return;
    blocks_.write(blocks.data(), blocks.size() * sizeof(glm::ivec4));
    blocks_.bind(GL_SHADER_STORAGE_BUFFER, 1);
    medium.extinction.bindImage(0, GL_READ_WRITE);
    programs.get("march/light_to_medium.comp").dispatchGroups(static_cast<int>(blocks.size()));
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void MarchEngine::march(const FrameInputs& inputs, const gl::Program& program,
                        const gl::Texture& linear, const Progress& progress) {
    if (!blueNoise_) blueNoise_ = uploadBlueNoise();
    blueNoise_.bind(6);
    phases_.bind();
    linear.bindImage(0, GL_READ_WRITE);
    program.setFloat(1, 1.0f / static_cast<float>(inputs.sample + 1));
    for (int row = 0; row < inputs.sizePx.y; row += kBandRows) {
        if (!goOn(progress, static_cast<double>(row) / inputs.sizePx.y)) throw Cancelled{};
        program.setInt(0, row);
        program.dispatch({inputs.sizePx.x, std::min(kBandRows, inputs.sizePx.y - row), 1});
    }
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
}

void MarchEngine::eye(const FrameInputs& inputs, const RegularGrid& grid,
                      const PackedMedium& medium, const gl::Texture* noise,
                      gl::ProgramCache& programs, const gl::Texture& linear,
                      const Progress& progress) {
    phases_.update(inputs.look, medium.plan);
    bind(inputs, grid, medium, noise, {0, lastLayer_});
    if (inputs.profile) {
        const std::array<GLuint, 4> zeros{};
        counts_.write(zeros.data(), sizeof(zeros));
        counts_.bind(GL_SHADER_STORAGE_BUFFER, 2);
        if (taken_.size() != glm::ivec3(inputs.sizePx, 1)) {
            taken_ = gl::Texture::make2D(GL_R32UI, inputs.sizePx);
        }
        taken_.bindImage(1, GL_WRITE_ONLY);
    }
    march(inputs, programs.get("march/eye.comp", eyeDefines(inputs, medium, false)), linear,
          progress);
}

void MarchEngine::floor(const FrameInputs& inputs, const RegularGrid& grid,
                        const PackedMedium& medium, gl::ProgramCache& programs,
                        const gl::Texture& linear) {
    bind(inputs, grid, medium, nullptr, {0, lastLayer_});
    if (floor_.size() != grid.size) {
        floor_ = gl::Texture::make3D(GL_RGBA16, grid.size);
        floor_.setLinear();
        glClearTexImage(floor_.name(), 0, GL_RGBA, GL_FLOAT, nullptr);
    }
    floor_.bind(7);
    taken_.bindImage(1, GL_READ_ONLY);
    march(inputs, programs.get("march/eye.comp", eyeDefines(inputs, medium, true)), linear, {});
}

SampleCounts MarchEngine::counts() const {
    std::array<GLuint, 4> values{};
    glGetNamedBufferSubData(counts_.name(), 0, sizeof(values), values.data());
    return {values[0], values[1], values[2], values[3]};
}

std::size_t MarchEngine::bytes() const {
    return light_.bytes() + phases_.bytes() + blueNoise_.bytes() + taken_.bytes() + floor_.bytes();
}

}  // namespace neph::render
