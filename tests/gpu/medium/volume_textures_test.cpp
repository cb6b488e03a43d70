// volume_textures_test.cpp: what is uploaded, and the blocks that say where there is anything.
#include "app/render/medium/volume_textures.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <tuple>
#include <vector>

#include "tests/gpu/context.h"

using namespace neph;
using namespace neph::render;

namespace {

using Block = std::tuple<int, int, int>;

/// Few voxels hold anything, each of two species some.
SpeciesVolume sparse(glm::ivec3 size, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> exponent(-9.0f, -2.0f);
    SpeciesVolume volume;
    volume.grid = {size, glm::dvec3(0.0), glm::dvec3(100.0)};
    volume.contentKgPerM3[0] = Array3f(size);
    volume.extinctionPerM[3] = Array3f(size);
    for (Array3f* held : {&volume.contentKgPerM3[0], &volume.extinctionPerM[3]}) {
        for (float& value : held->values) {
            if (random() % 3000 == 0) value = std::pow(10.0f, exponent(random));
        }
    }
    return volume;
}

/// Blocks of the voxels into which interpolation carries more than a millionth of the largest.
std::set<Block> reached(const Array3f& held) {
    const float least = 1e-6f * *std::max_element(held.values.begin(), held.values.end());
    std::set<Block> blocks;
    for (int z = 0; z < held.size.z; ++z)
        for (int y = 0; y < held.size.y; ++y)
            for (int x = 0; x < held.size.x; ++x) {
                if (held.at(x, y, z) <= least) continue;
                for (int k = 0; k < 27; ++k) {
                    const glm::ivec3 p =
                        glm::ivec3(x, y, z) + glm::ivec3(k % 3, k / 3 % 3, k / 9) - 1;
                    // Where the domain repeats, those on its other side.
                    const glm::ivec3 around = (p + held.size) % held.size;
                    const glm::ivec3 block =
                        glm::ivec3(around.x, around.y, std::clamp(p.z, 0, held.size.z - 1)) /
                        glm::ivec3(kBlockVoxels);
                    blocks.emplace(block.x, block.y, block.z);
                }
            }
    return blocks;
}

std::set<Block> listed(const SpeciesVolume& volume) {
    std::set<Block> blocks;
    for (const glm::ivec3 block : uploadVolume(volume).blocks) {
        blocks.emplace(block.x, block.y, block.z);
    }
    return blocks;
}

std::vector<float> readBackFloats(const gl::Texture& texture) {
    const glm::ivec3 n = texture.size();
    std::vector<float> values(static_cast<std::size_t>(n.x * n.y * n.z));
    glGetTextureImage(texture.name(), 0, GL_RED, GL_FLOAT,
                      static_cast<GLsizei>(values.size() * sizeof(float)), values.data());
    return values;
}

}  // namespace

TEST_CASE("A single voxel lists the blocks that it reaches by interpolation and no others") {
    test::needContext();
    const glm::ivec3 size{24, 24, 17};
    for (const glm::ivec3 at : {glm::ivec3(0), glm::ivec3(8, 11, 7), glm::ivec3(15, 15, 15),
                                glm::ivec3(12, 16, 16), glm::ivec3(23, 23, 16)}) {
        CAPTURE(at.x);
        SpeciesVolume volume = sparse(size, 0);
        volume.extinctionPerM[3] = Array3f();
        volume.contentKgPerM3[0] = Array3f(size);
        volume.contentKgPerM3[0].at(at.x, at.y, at.z) = 1e-3f;
        CHECK((listed(volume) == reached(volume.contentKgPerM3[0])));
    }
}

TEST_CASE("Every block that a voxel with a millionth of the largest reaches is listed") {
    test::needContext();
    for (const glm::ivec3 size :
         {glm::ivec3(1), glm::ivec3(8), glm::ivec3(17, 40, 9), glm::ivec3(64, 33, 48)}) {
        for (unsigned seed = 0; seed < 5; ++seed) {
            CAPTURE(size.x);
            CAPTURE(seed);
            const SpeciesVolume volume = sparse(size, seed);
            std::set<Block> expected = reached(volume.contentKgPerM3[0]);
            expected.merge(reached(volume.extinctionPerM[3]));
            const std::set<Block> has = listed(volume);
            CHECK(std::includes(has.begin(), has.end(), expected.begin(), expected.end()));
        }
    }
}

TEST_CASE("What is held comes back to eleven bits over five decades below the largest") {
    test::needContext();
    const SpeciesVolume volume = sparse({64, 33, 48}, 11);
    const VolumeTextures textures = uploadVolume(volume);
    for (const std::size_t s : {0u, 3u}) {
        const Array3f& held = s == 0 ? volume.contentKgPerM3[0] : volume.extinctionPerM[3];
        const float largest = *std::max_element(held.values.begin(), held.values.end());
        const std::vector<float> texels = readBackFloats(textures.held[s]);
        REQUIRE(texels.size() == held.values.size());
        float worst = 0.0f;
        for (std::size_t i = 0; i < texels.size(); ++i) {
            const float value = held.values[i], back = texels[i] * textures.perTexel[s];
            if (value == 0.0f) REQUIRE(back == 0.0f);
            if (value > 1e-5f * largest) worst = std::max(worst, std::abs(back / value - 1.0f));
        }
        CHECK(worst <= 1.001f / 2048.0f);
        CHECK(worst > 0.0f);
    }
    CHECK((textures.held[1].size() == glm::ivec3(1)));
}
