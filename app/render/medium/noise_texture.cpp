// noise_texture.cpp: baked once. Processors compute both sides of a branch, so each noise of the
// stack is a dispatch of its own.
#include "app/render/medium/noise_texture.h"

#include <fmt/format.h>

#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "app/gl/shader_source.h"
#include "core/base/atomic_file.h"
#include "core/base/hash.h"
#include "core/base/resources.h"
#include "core/optics/blue_noise.h"

namespace neph::render {
namespace {

gl::Texture make(GLenum format, glm::ivec3 size, int levels) {
    gl::Texture noise = gl::Texture::make3D(format, size, levels);
    noise.setRepeat();
    noise.bindImage(kNoiseImage, GL_WRITE_ONLY);
    return noise;
}

void bake(gl::ProgramCache& programs, const std::vector<std::string>& defines) {
    programs.get("medium/bake_noise.comp", defines).dispatch(glm::ivec3(kNoiseSize));
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

std::filesystem::path cacheFile(const gl::ProgramCache& programs) {
    const auto folder = userCacheDir();
    if (!folder) return {};
    const auto source = gl::loadShader(programs.root(), "medium/bake_noise.comp", {});
    return *folder / fmt::format("noise-{:016x}.bin", hashOf(source.text));
}

/// The texels, and their hash behind them; empty when the file is absent or not whole.
std::string readCache(const std::filesystem::path& file, std::size_t bytes) {
    std::string texels(bytes, '\0');
    std::uint64_t hash = 0;
    std::ifstream in(file, std::ios::binary);
    in.read(texels.data(), static_cast<std::streamsize>(bytes));
    in.read(reinterpret_cast<char*>(&hash), sizeof(hash));
    return in && hash == hashOf(texels) ? texels : std::string();
}

/// A cache that cannot be written is none.
void writeCache(const std::filesystem::path& file, std::string texels) {
    const std::uint64_t hash = hashOf(texels);
    texels.append(reinterpret_cast<const char*>(&hash), sizeof(hash));
    try {
        std::filesystem::create_directories(file.parent_path());
        replaceFile(file, std::string_view(texels));
    } catch (const std::exception&) {
        return;
    }
}

/// The first level, from the cache or baked.
std::string stackedTexels(gl::ProgramCache& programs, const gl::Texture& noise) {
    const std::filesystem::path file = cacheFile(programs);
    std::string texels = file.empty() ? std::string() : readCache(file, noise.bytes());
    if (!texels.empty()) return texels;
    bake(programs, {"STACKED 1", "WISP 0"});
    bake(programs, {"STACKED 1", "WISP 1"});
    texels.resize(noise.bytes());
    glGetTextureImage(noise.name(), 0, GL_RED, GL_UNSIGNED_BYTE,
                      static_cast<GLsizei>(texels.size()), texels.data());
    if (!file.empty()) writeCache(file, texels);
    return texels;
}

/// The next level: the mean of 2 x 2 x 2 texels. Drivers take longer for it than this does.
std::string halved(const std::string& texels, glm::ivec3 size) {
    const auto at = [&](int x, int y, int z) {
        return static_cast<unsigned char>(
            texels[static_cast<std::size_t>(x + size.x * (y + size.y * z))]);
    };
    std::string out;
    out.reserve(texels.size() / 8);
    for (int z = 0; z < size.z; z += 2)
        for (int y = 0; y < size.y; y += 2)
            for (int x = 0; x < size.x; x += 2) {
                int sum = 4;  // rounds to the nearest
                for (int k = 0; k < 8; ++k) sum += at(x + (k & 1), y + (k >> 1 & 1), z + (k >> 2));
                out.push_back(static_cast<char>(static_cast<unsigned char>(sum / 8)));
            }
    return out;
}

gl::Texture bakeFiltered(gl::ProgramCache& programs) {
    gl::Texture noise = make(GL_RG16, glm::ivec3(kNoiseSize), 1);
    bake(programs, {"STACKED 0"});
    noise.setLinear();
    return noise;
}

gl::Texture bakeStacked(gl::ProgramCache& programs) {
    gl::Texture noise = make(GL_R8, {kNoiseSize, kNoiseSize, 2 * kNoiseSize}, kNoiseLevels);
    std::string texels = stackedTexels(programs, noise);
    for (int level = 0; level < kNoiseLevels; ++level) {
        if (level > 0) texels = halved(texels, noise.size() >> (level - 1));
        noise.upload(GL_RED, GL_UNSIGNED_BYTE, texels.data(), level);
    }
    return noise;
}

}  // namespace

const gl::Texture& NoiseTextures::filtered(gl::ProgramCache& programs, gl::PassTimer& timer) {
    if (!filtered_) {
        timer.pass("noise");
        filtered_ = bakeFiltered(programs);
    }
    return filtered_;
}

const gl::Texture& NoiseTextures::stacked(gl::ProgramCache& programs, gl::PassTimer& timer) {
    if (!stacked_) {
        timer.pass("noise");
        stacked_ = bakeStacked(programs);
    }
    return stacked_;
}

gl::Texture uploadBlueNoise() {
    gl::Texture texture = gl::Texture::make2D(GL_R32F, glm::ivec2(kBlueNoiseSize));
    texture.upload(GL_RED, GL_FLOAT, blueNoise().data());
    return texture;
}

}  // namespace neph::render
