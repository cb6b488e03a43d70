// path_medium.cpp: the bounds are found on the GPU, the distances to what is not empty here.
#include "app/render/engines/path_medium.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/render/engines/frame_block.h"

namespace neph::render {
namespace {

constexpr double kMostCells = 1 << 25;  // 256 MiB

/// The largest factor of detail, that of the largest noise.
float largestDetail(const MediumClass& c) {
    return glsl::detailFactor(1.0f, c.noiseAmount);
}

Array3f boundsOf(const MediumTextures& medium, int cellVoxels, gl::ProgramCache& programs) {
    // Cells begin half a voxel below the first.
    const gl::Texture bounds =
        gl::Texture::make3D(GL_R32F, (medium.first.size() + cellVoxels) / cellVoxels);
    const gl::Program& program = programs.get("pass/trace_cells.comp", mediumDefines(medium));
    medium.first.bind(0);
    if (medium.second) medium.second.bind(1);
    bounds.bindImage(0, GL_WRITE_ONLY);
    program.setInt(0, cellVoxels);
    for (std::size_t i = 0; i < medium.plan.classes.size(); ++i) {
        program.setFloat(1 + static_cast<int>(i), largestDetail(medium.plan.classes[i]));
    }
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

PathMedium makePathMedium(const MediumTextures& medium, glm::dvec3 voxelM, int cellVoxels,
                          double boundScale, gl::ProgramCache& programs) {
    const Array3f bounds = boundsOf(medium, cellVoxels, programs);
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
    out.cellM = voxelM * static_cast<double>(cellVoxels);
    out.voxelM = voxelM;
    return out;
}

std::vector<std::string> mediumDefines(const MediumTextures& medium) {
    // An array has at least one element.
    return {fmt::format("CLASSES {}", std::max<std::size_t>(medium.plan.classes.size(), 1)),
            fmt::format("CLASS_TEXTURES {}", medium.textureCount()),
            fmt::format("NOISE {}", isNoisy(medium.plan) ? 1 : 0),
            fmt::format("PHASE_TABLE_SIZE {}", kPhaseTableSize),
            fmt::format("SCATTERING_INTERVALS {}", kScatteringIntervals)};
}

}  // namespace neph::render
