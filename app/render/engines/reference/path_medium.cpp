// path_medium.cpp: the bounds are found on the GPU, the distances to what is not empty here.
#include "app/render/engines/reference/path_medium.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/type_precision.hpp>

#include "app/render/frame/frame_block.h"

namespace neph::render {
namespace {

constexpr double kMostCells = 1 << 25;  // 256 MiB

using Texels = Array3<glm::u16vec2>;

/// The largest of a texel and those after it in each axis, up to the texel `reach` further.
Texels largestOf(const Texels& texels, int reach, int step) {
    const int n = texels.size.x, half = n / step;
    Texels out{glm::ivec3(half)};
    for (int z = 0; z < half; ++z)
        for (int y = 0; y < half; ++y)
            for (int x = 0; x < half; ++x) {
                glm::u16vec2 most(0);
                for (int k = 0; k < (reach + 1) * (reach + 1) * (reach + 1); ++k) {
                    const glm::ivec3 at = step * glm::ivec3(x, y, z) +
                                          glm::ivec3(k % (reach + 1), k / (reach + 1) % (reach + 1),
                                                     k / (reach + 1) / (reach + 1));
                    most = glm::max(most, texels.at(at.x % n, at.y % n, at.z % n));
                }
                out.at(x, y, z) = most;
            }
    return out;
}

/// Levels of maxima. shaders/reference/cells.comp
gl::Texture noiseBound(const gl::Texture& noise) {
    Texels texels(noise.size());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(noise.name(), 0, GL_RG, GL_UNSIGNED_SHORT,
                      static_cast<GLsizei>(texels.values.size() * sizeof(glm::u16vec2)),
                      texels.values.data());
    const int levels = static_cast<int>(std::lround(std::log2(noise.size().x))) + 1;
    gl::Texture bound = gl::Texture::make3D(GL_RG16, noise.size(), levels);
    texels = largestOf(texels, 1, 1);
    for (int level = 0; level < levels; ++level) {
        if (level > 0) texels = largestOf(texels, 1, 2);
        bound.upload(GL_RG, GL_UNSIGNED_SHORT, texels.values.data(), level);
    }
    return bound;
}

void setDetail(const MediumPlan& plan, const RegularGrid& grid, int texels,
               const gl::Program& program) {
    for (std::size_t i = 0; i < plan.classes.size(); ++i) {
        const MediumClass& c = plan.classes[i];
        const auto at = static_cast<int>(i);
        program.setFloat(kBoundAmountLocation + at, c.noiseAmount);
        const glm::vec2 perM = static_cast<float>(texels) /
                               (glsl::kDetailFeaturesPerTile * c.noiseScaleM * c.noiseFit);
        program.setVec3(kBoundTexelsPerMLocation + at, {perM, perM.x});
        program.setFloat(kBoundCharacterLocation + at,
                         c.noiseCharacter == NoiseCharacter::billow ? 0.0f : 1.0f);
    }
    program.setVec3(kBoundVoxelLocation, glm::vec3(grid.spacingM));
    program.setVec3(kBoundMovedLocation, glm::vec3(grid.movedM, 0.0f));
}

Array3f boundsOf(const MediumTextures& medium, const RegularGrid& grid, int cellVoxels,
                 const gl::Texture* noise, gl::ProgramCache& programs) {
    // Cells begin half a voxel below the first.
    const gl::Texture bounds =
        gl::Texture::make3D(GL_R32F, (medium.first.size() + cellVoxels) / cellVoxels);
    std::vector<std::string> defines = mediumDefines(medium);
    defines.push_back(fmt::format("PERIODIC {}", medium.plan.repeats ? 1 : 0));
    const gl::Program& program = programs.get("reference/cells.comp", defines);
    medium.first.bind(kMedium0Unit);
    if (medium.second) medium.second.bind(kMedium1Unit);
    gl::Texture detail;
    if (isNoisy(medium.plan)) {
        detail = noiseBound(*noise);
        detail.bind(kNoiseBoundUnit);
        setDetail(medium.plan, grid, noise->size().x, program);
    }
    bounds.bindImage(kBoundImage, GL_WRITE_ONLY);
    program.setInt(kBoundCellVoxelsLocation, cellVoxels);
    program.dispatch(bounds.size());
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    return readBack(bounds);
}

}  // namespace

int cellVoxelsFor(glm::ivec3 voxels) {
    int side = 1;
    while (static_cast<double>(voxels.x) * voxels.y * voxels.z / std::pow(side, 3) > kMostCells) {
        side *= 2;
    }
    return side;
}

PathMedium makePathMedium(const MediumTextures& medium, const RegularGrid& grid, int cellVoxels,
                          double boundScale, const gl::Texture* noise, gl::ProgramCache& programs) {
    const Array3f bounds = boundsOf(medium, grid, cellVoxels, noise, programs);
    const Array3<std::uint8_t> distances = emptyDistances(bounds, 0.0f);
    std::vector<glm::vec2> cells;
    cells.reserve(bounds.values.size());
    for (std::size_t i = 0; i < bounds.values.size(); ++i) {
        cells.emplace_back(bounds.values[i] * static_cast<float>(boundScale),
                           static_cast<float>(distances.values[i]));
    }
    PathMedium out;
    out.cells = gl::Texture::make3D(GL_RG32F, bounds.size);
    out.cells.upload(GL_RG, GL_FLOAT, cells.data());
    std::vector<PhaseSpec> phases;
    for (const MediumClass& c : medium.plan.classes) phases.push_back(c.phase);
    out.tables = makeScatteringTables(phases);
    const auto peak = [](const PhaseSpec& spec) { return phaseValue(spec, 1.0f).g; };
    for (std::size_t i = 1; i < phases.size(); ++i) {
        const auto best = static_cast<std::size_t>(out.lobeClass);
        if (peak(phases[i]) > peak(phases[best])) out.lobeClass = static_cast<int>(i);
    }
    out.cellM = grid.spacingM * static_cast<double>(cellVoxels);
    out.voxelM = grid.spacingM;
    return out;
}

std::vector<std::string> mediumDefines(const MediumTextures& medium) {
    // An array has at least one element.
    return {fmt::format("CLASSES {}", std::max<std::size_t>(medium.plan.classes.size(), 1)),
            fmt::format("CLASS_TEXTURES {}", medium.textureCount()),
            fmt::format("NOISE {}", isNoisy(medium.plan) ? 1 : 0)};
}

}  // namespace neph::render
