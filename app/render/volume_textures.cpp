// volume_textures.cpp: upload as halves, and the list of blocks that any bake has to visit.
#include "app/render/volume_textures.h"

#include <Imath/half.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/parallel.h"

namespace neph::render {
namespace {

constexpr float kLargestHalf = 32768.0f;  // a power of two below the top of the range
constexpr std::size_t kMostWorkers = 8;   // memory is busy with fewer

using Blocks = Array3<std::uint8_t>;

/// Layers of a block's height, each done by one thread.
template <typename Work>
void overLayers(glm::ivec3 size, const Work& work) {
    const auto layers = static_cast<std::size_t>((size.z + kBlockVoxels - 1) / kBlockVoxels);
    shareOut(
        layers, workerCount(kMostWorkers),
        [&](std::size_t layer, std::size_t, const Progress&) { work(static_cast<int>(layer)); });
}

/// Largest value of a layer of blocks; marks those that hold anything.
float scan(const Array3f& held, int layer, Blocks& blocks) {
    float largest = 0.0f;
    const int end = std::min((layer + 1) * kBlockVoxels, held.size.z);
    for (int z = layer * kBlockVoxels; z < end; ++z) {
        for (int y = 0; y < held.size.y; ++y) {
            const float* row = &held.at(0, y, z);
            for (int x = 0; x < held.size.x; x += kBlockVoxels) {
                const int stop = std::min(x + kBlockVoxels, held.size.x);
                const float most = *std::max_element(row + x, row + stop);
                if (most > 0.0f) blocks.at(x / kBlockVoxels, y / kBlockVoxels, layer) = 1;
                largest = std::max(largest, most);
            }
        }
    }
    return largest;
}

float largestOf(const Array3f& held, Blocks& blocks) {
    std::vector<float> largest(static_cast<std::size_t>(blocks.size.z), 0.0f);
    overLayers(held.size, [&](int layer) {
        largest[static_cast<std::size_t>(layer)] = scan(held, layer, blocks);
    });
    return *std::max_element(largest.begin(), largest.end());
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

/// Interpolation carries what a voxel holds into the next block.
bool bordersOnAny(const Blocks& marked, glm::ivec3 p) {
    const glm::ivec3 lower = glm::max(p - 1, glm::ivec3(0));
    const glm::ivec3 upper = glm::min(p + 1, marked.size - 1);
    for (int z = lower.z; z <= upper.z; ++z)
        for (int y = lower.y; y <= upper.y; ++y)
            for (int x = lower.x; x <= upper.x; ++x)
                if (marked.at(x, y, z) != 0) return true;
    return false;
}

void listBlocks(const Blocks& marked, VolumeTextures& out) {
    std::vector<glm::ivec4> list;
    for (int z = 0; z < marked.size.z; ++z)
        for (int y = 0; y < marked.size.y; ++y)
            for (int x = 0; x < marked.size.x; ++x)
                if (bordersOnAny(marked, {x, y, z})) {
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

VolumeTextures uploadVolume(const SpeciesVolume& volume) {
    VolumeTextures textures;
    textures.grid = volume.grid;
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
        textures.perTexel[s] = uploadHalves(held, largestOf(held, blocks), textures.held[s]);
    }
    listBlocks(blocks, textures);
    return textures;
}

}  // namespace neph::render
