// volume_textures.cpp: upload as halves, and the list of blocks that any bake has to visit.
#include "app/render/medium/volume_textures.h"

#include <Imath/half.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/parallel.h"

namespace neph::render {
namespace {

constexpr float kLargestHalf = 32768.0f;  // a power of two below the top of the range
constexpr float kLeastShare = 1e-8f;      // of the largest value, below which nothing shows
constexpr std::size_t kChunk = 1 << 16;
constexpr std::size_t kMostWorkers = 8;  // memory is busy with fewer

using Blocks = Array3<std::uint8_t>;

/// Layers of a block's height, each done by one thread.
template <typename Work>
void overLayers(glm::ivec3 size, const Work& work) {
    const auto layers = static_cast<std::size_t>((size.z + kBlockVoxels - 1) / kBlockVoxels);
    shareOut(
        layers, workerCount(kMostWorkers),
        [&](std::size_t layer, std::size_t, const Progress&) { work(static_cast<int>(layer)); });
}

float largestOf(const Array3f& held) {
    std::vector<float> largest(held.values.size() / kChunk + 1, 0.0f);
    shareOut(
        largest.size(), workerCount(kMostWorkers),
        [&](std::size_t chunk, std::size_t, const Progress&) {
            const auto first = held.values.begin() + static_cast<std::ptrdiff_t>(chunk * kChunk);
            const auto end = first + std::min<std::ptrdiff_t>(kChunk, held.values.end() - first);
            if (first != end) largest[chunk] = *std::max_element(first, end);
        });
    return *std::max_element(largest.begin(), largest.end());
}

/// Which parts of a block hold anything, along each axis: its first voxel, any, its last.
struct Thirds {
    std::array<std::array<bool, 3>, 3> any{};
    /// The voxel of so many.
    void mark(int axis, int voxel, int voxels) {
        auto& along = any[static_cast<std::size_t>(axis)];
        if (voxel == 0) along[0] = true;
        if (voxel == voxels - 1) along[2] = true;
        along[1] = true;
    }
};

/// Marks a block that holds anything, and neighbours into which interpolation carries it: where the
/// domain repeats, those on its other side.
void markAround(glm::ivec3 block, const Thirds& thirds, Blocks& blocks) {
    for (int k = 0; k < 27; ++k) {
        const glm::ivec3 step{k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1};
        bool reached = true;
        for (int axis = 0; axis < 3; ++axis) {
            const auto& any = thirds.any[static_cast<std::size_t>(axis)];
            reached = reached && (step[axis] == 0 || any[step[axis] < 0 ? 0 : 2]);
        }
        glm::ivec3 p = block + step;
        p.x = (p.x + blocks.size.x) % blocks.size.x;
        p.y = (p.y + blocks.size.y) % blocks.size.y;
        if (reached && p.z >= 0 && p.z < blocks.size.z) blocks.at(p.x, p.y, p.z) = 1;
    }
}

Thirds thirdsOf(const Array3f& held, glm::ivec3 block, float least) {
    const glm::ivec3 lower = block * kBlockVoxels;
    const glm::ivec3 upper = glm::min(lower + kBlockVoxels, held.size);
    Thirds thirds;
    for (int z = lower.z; z < upper.z; ++z)
        for (int y = lower.y; y < upper.y; ++y) {
            const float* row = &held.at(0, y, z);
            for (int x = lower.x; x < upper.x; ++x) {
                if (row[x] <= least) continue;
                for (int axis = 0; axis < 3; ++axis) {
                    thirds.mark(axis, glm::ivec3(x, y, z)[axis] - lower[axis],
                                upper[axis] - lower[axis]);
                }
            }
        }
    return thirds;
}

/// Marks the blocks in which any of `held` shows.
void mark(const Array3f& held, float largest, Blocks& blocks) {
    const float least = kLeastShare * largest;
    Array3<Thirds> thirds(blocks.size, {});
    overLayers(held.size, [&](int z) {
        for (int y = 0; y < blocks.size.y; ++y)
            for (int x = 0; x < blocks.size.x; ++x)
                thirds.at(x, y, z) = thirdsOf(held, {x, y, z}, least);
    });
    for (int z = 0; z < blocks.size.z; ++z)
        for (int y = 0; y < blocks.size.y; ++y)
            for (int x = 0; x < blocks.size.x; ++x) {
                const Thirds& here = thirds.at(x, y, z);
                if (here.any[0][1]) markAround({x, y, z}, here, blocks);
            }
}

/// Uploads as halves times a scale; returns what a texel is worth.
float uploadHalves(const Array3f& held, float largest, gl::Texture& out) {
    const float perTexel = largest > 0.0f ? largest / kLargestHalf : 1.0f;
    std::vector<std::uint16_t> halves(held.values.size());
    const std::size_t layer = static_cast<std::size_t>(held.size.x) *
                              static_cast<std::size_t>(held.size.y) * kBlockVoxels;
    overLayers(held.size, [&](int index) {
        const std::size_t first = static_cast<std::size_t>(index) * layer;
        const std::size_t end = std::min(first + layer, halves.size());
        for (std::size_t i = first; i < end; ++i) {
            halves[i] = imath_float_to_half(held.values[i] / perTexel);
        }
    });
    out = gl::Texture::make3D(GL_R16F, held.size);
    out.setLinear();
    out.upload(GL_RED, GL_HALF_FLOAT, halves.data());
    return perTexel;
}

void listBlocks(const Blocks& marked, VolumeTextures& out) {
    std::vector<glm::ivec4> list;
    for (int z = 0; z < marked.size.z; ++z)
        for (int y = 0; y < marked.size.y; ++y)
            for (int x = 0; x < marked.size.x; ++x)
                if (marked.at(x, y, z) != 0) {
                    list.emplace_back(x, y, z, 0);
                    out.blocks.emplace_back(x, y, z);
                }
    if (list.empty()) list.emplace_back(0);  // a buffer that is bound must have a size
    out.blockList.write(list.data(), list.size() * sizeof(glm::ivec4));
}

}  // namespace

std::size_t VolumeTextures::bytes() const {
    std::size_t sum = blockList.bytes();
    for (const gl::Texture& texture : held) sum += texture.bytes();
    return sum;
}

MediumPlan planMedium(const Look& look, const VolumeTextures& volume) {
    return planMedium(look, volume.holdings, volume.cellM, volume.grid.extentM());
}

VolumeTextures uploadVolume(const SpeciesVolume& volume) {
    VolumeTextures textures;
    textures.grid = volume.grid;
    textures.cellM = volume.cellM();
    textures.holdings = volume.holdings();
    Blocks blocks((volume.grid.size + kBlockVoxels - 1) / kBlockVoxels, 0);
    for (std::size_t s = 0; s < textures.held.size(); ++s) {
        const auto species = static_cast<Species>(s);
        const Array3f& held =
            volume.holdsExtinction(species) ? volume.extinction(species) : volume.content(species);
        if (held.empty()) {  // a sampler must have something bound
            uploadHalves(Array3f(glm::ivec3(1), 0.0f), 0.0f, textures.held[s]);
            continue;
        }
        const float largest = largestOf(held);
        textures.perTexel[s] = uploadHalves(held, largest, textures.held[s]);
        mark(held, largest, blocks);
    }
    listBlocks(blocks, textures);
    return textures;
}

}  // namespace neph::render
