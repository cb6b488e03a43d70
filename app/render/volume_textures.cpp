// volume_textures.cpp: upload as halves, and the list of blocks that any bake has to visit.
#include "app/render/volume_textures.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace neph::render {
namespace {

constexpr float kLargestHalf = 32768.0f;  // a power of two below the top of the range

float largestOf(const Array3f& held) {
    return *std::max_element(held.values.begin(), held.values.end());
}

/// Uploads floats and lets the GPU make halves of them; returns what a texel is worth.
float uploadHalves(const Array3f& held, gl::ProgramCache& programs, gl::Texture& out) {
    const float largest = largestOf(held);
    const float perTexel = largest > 0.0f ? largest / kLargestHalf : 1.0f;
    gl::Texture whole = gl::Texture::make3D(GL_R32F, held.size);
    whole.upload(GL_RED, GL_FLOAT, held.values.data());
    out = gl::Texture::make3D(GL_R16F, held.size);
    out.setLinear();
    const gl::Program& program = programs.get("pass/to_half.comp");
    whole.bind(0);
    out.bindImage(0, GL_WRITE_ONLY);
    program.setFloat(0, 1.0f / perTexel);
    program.dispatch(held.size);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    return perTexel;
}

/// Marks the blocks that hold anything of `held`.
void mark(const Array3f& held, Array3<std::uint8_t>& blocks) {
    const float* value = held.values.data();
    for (int z = 0; z < held.size.z; ++z) {
        for (int y = 0; y < held.size.y; ++y) {
            for (int x = 0; x < held.size.x; x += kBlockVoxels) {
                const int end = std::min(kBlockVoxels, held.size.x - x);
                const bool any = std::any_of(value, value + end, [](float v) { return v > 0.0f; });
                value += end;
                if (any) blocks.at(x / kBlockVoxels, y / kBlockVoxels, z / kBlockVoxels) = 1;
            }
        }
    }
}

/// Interpolation carries what a voxel holds into the next block.
bool bordersOnAny(const Array3<std::uint8_t>& marked, glm::ivec3 p) {
    const glm::ivec3 lower = glm::max(p - 1, glm::ivec3(0));
    const glm::ivec3 upper = glm::min(p + 1, marked.size - 1);
    for (int z = lower.z; z <= upper.z; ++z)
        for (int y = lower.y; y <= upper.y; ++y)
            for (int x = lower.x; x <= upper.x; ++x)
                if (marked.at(x, y, z) != 0) return true;
    return false;
}

void listBlocks(const Array3<std::uint8_t>& marked, VolumeTextures& out) {
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

VolumeTextures uploadVolume(const SpeciesVolume& volume, gl::ProgramCache& programs) {
    VolumeTextures textures;
    textures.grid = volume.grid;
    textures.holdings = volume.holdings();
    Array3<std::uint8_t> blocks((volume.grid.size + kBlockVoxels - 1) / kBlockVoxels, 0);
    for (std::size_t s = 0; s < textures.held.size(); ++s) {
        const auto species = static_cast<Species>(s);
        const Array3f& held =
            volume.holdsExtinction(species) ? volume.extinction(species) : volume.content(species);
        if (held.empty()) {  // a sampler must have something bound
            uploadHalves(Array3f(glm::ivec3(1), 0.0f), programs, textures.held[s]);
            continue;
        }
        textures.perTexel[s] = uploadHalves(held, programs, textures.held[s]);
        mark(held, blocks);
    }
    listBlocks(blocks, textures);
    return textures;
}

}  // namespace neph::render
