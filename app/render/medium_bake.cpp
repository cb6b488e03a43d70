// medium_bake.cpp: upload, bake, and the map of empty bricks.
#include "app/render/medium_bake.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace neph::render {
namespace {

constexpr int kNoiseSize = 128;
/// Bricks whose densest voxel could not dim a ray through the whole domain by more than this are
/// empty.
constexpr double kInvisibleOpticalDepth = 1e-4;
/// Diffuse light from below relative to that from above: about the albedo of land. docs/physics.md
/// §5
constexpr float kGroundShare = 0.2f;

std::vector<std::string> defines(const MediumTextures& medium) {
    return {fmt::format("CLASS_TEXTURES {}", medium.textureCount())};
}

void bakeExtinction(const VolumeTextures& volume, gl::ProgramCache& programs, MediumTextures& out) {
    const gl::Program& program = programs.get("pass/bake_medium.comp", defines(out));
    for (int s = 0; s < kSpeciesCount; ++s) {
        const auto i = static_cast<std::size_t>(s);
        volume.held[i].bind(static_cast<GLuint>(s));
        program.setFloat(s, out.plan.extinctionPerHeld[i]);
        program.setInt(kSpeciesCount + s, out.plan.classOf[i]);
    }
    out.first.bindImage(0, GL_WRITE_ONLY);
    if (out.second) out.second.bindImage(1, GL_WRITE_ONLY);
    program.dispatch(volume.grid.size);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

void bakeSkylight(const VolumeTextures& volume, gl::ProgramCache& programs, MediumTextures& out) {
    const gl::Program& program = programs.get("pass/bake_skylight.comp", defines(out));
    (out.second ? out.second : out.first).bindImage(0, GL_READ_WRITE);
    if (out.second) out.first.bind(0);
    program.setFloat(0, static_cast<float>(volume.grid.spacingM.z));
    program.setFloat(1, kSkylightAsymmetry);
    program.setFloat(2, kGroundShare);
    program.dispatch({volume.grid.size.x, volume.grid.size.y, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

Array3f readBricks(const VolumeTextures& volume, gl::ProgramCache& programs,
                   const MediumTextures& medium) {
    const glm::ivec3 bricks = (volume.grid.size + kBrickVoxels - 1) / kBrickVoxels;
    const gl::Texture maximum = gl::Texture::make3D(GL_R32F, bricks);
    const gl::Program& program = programs.get("pass/brick_maximum.comp", defines(medium));
    medium.first.bind(0);
    if (medium.second) medium.second.bind(1);
    maximum.bindImage(0, GL_WRITE_ONLY);
    program.setInt(0, kBrickVoxels);
    program.dispatch(bricks);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    Array3f values(bricks);
    glGetTextureImage(maximum.name(), 0, GL_RED, GL_FLOAT,
                      static_cast<GLsizei>(values.values.size() * sizeof(float)),
                      values.values.data());
    return values;
}

/// Chebyshev distance to the nearest occupied brick, by a forward and a backward sweep over the 13
/// earlier neighbours.
Array3<std::uint8_t> distances(const Array3f& bricks, float threshold) {
    constexpr std::uint8_t kFar = 255;
    Array3<std::uint8_t> distance(bricks.size, kFar);
    const glm::ivec3 n = bricks.size;
    for (std::size_t i = 0; i < bricks.values.size(); ++i) {
        if (bricks.values[i] > threshold) distance.values[i] = 0;
    }
    const auto relax = [&](glm::ivec3 p, int sign) {
        std::uint8_t& here = distance.at(p.x, p.y, p.z);
        for (int k = 0; k < 13; ++k) {
            const glm::ivec3 q = p - sign * glm::ivec3(1 - k % 3, 1 - k / 3 % 3, 1 - k / 9);
            if (glm::any(glm::lessThan(q, glm::ivec3(0))) ||
                glm::any(glm::greaterThanEqual(q, n))) {
                continue;
            }
            here = std::min<std::uint8_t>(here, static_cast<std::uint8_t>(std::min<int>(
                                                    distance.at(q.x, q.y, q.z) + 1, kFar)));
        }
    };
    for (int z = 0; z < n.z; ++z)
        for (int y = 0; y < n.y; ++y)
            for (int x = 0; x < n.x; ++x) relax({x, y, z}, 1);
    for (int z = n.z - 1; z >= 0; --z)
        for (int y = n.y - 1; y >= 0; --y)
            for (int x = n.x - 1; x >= 0; --x) relax({x, y, z}, -1);
    return distance;
}

SliceBox boundsOf(const Array3<std::uint8_t>& distance, glm::dvec3 brickM, glm::dvec3 extentM) {
    glm::ivec3 lower = distance.size, upper{0};
    for (int z = 0; z < distance.size.z; ++z)
        for (int y = 0; y < distance.size.y; ++y)
            for (int x = 0; x < distance.size.x; ++x) {
                if (distance.at(x, y, z) != 0) continue;
                lower = glm::min(lower, glm::ivec3(x, y, z));
                upper = glm::max(upper, glm::ivec3(x, y, z) + 1);
            }
    if (upper == glm::ivec3(0)) return {};
    return {glm::dvec3(lower) * brickM, glm::min(glm::dvec3(upper) * brickM, extentM)};
}

void mapEmptiness(const VolumeTextures& volume, gl::ProgramCache& programs, MediumTextures& out) {
    const Array3f maximum = readBricks(volume, programs, out);
    const double diagonalM = glm::length(volume.grid.extentM());
    const auto distance =
        distances(maximum, static_cast<float>(kInvisibleOpticalDepth / diagonalM));
    out.brickM = volume.grid.spacingM * static_cast<double>(kBrickVoxels);
    out.occupied = boundsOf(distance, out.brickM, volume.grid.extentM());
    out.emptiness = gl::Texture::make3D(GL_R8UI, distance.size);
    out.emptiness.upload(GL_RED_INTEGER, GL_UNSIGNED_BYTE, distance.values.data());
}

gl::Texture makeMediumTexture(glm::ivec3 size) {
    gl::Texture texture = gl::Texture::make3D(GL_RGBA32F, size);
    texture.setLinear();
    return texture;
}

}  // namespace

std::size_t VolumeTextures::bytes() const {
    std::size_t sum = 0;
    for (const gl::Texture& texture : held) sum += texture.bytes();
    return sum;
}

VolumeTextures uploadVolume(const SpeciesVolume& volume) {
    VolumeTextures textures;
    textures.grid = volume.grid;
    textures.holdings = volume.holdings();
    for (std::size_t s = 0; s < textures.held.size(); ++s) {
        const auto species = static_cast<Species>(s);
        const Array3f& held =
            volume.holdsExtinction(species) ? volume.extinction(species) : volume.content(species);
        // A sampler must have something bound.
        textures.held[s] = gl::Texture::make3D(GL_R32F, held.empty() ? glm::ivec3(1) : held.size);
        const float zero = 0.0f;
        textures.held[s].upload(GL_RED, GL_FLOAT, held.empty() ? &zero : held.values.data());
    }
    return textures;
}

void bakeMedium(const VolumeTextures& volume, const MediumPlan& plan, gl::ProgramCache& programs,
                MediumTextures& out) {
    const bool sameSize = out.first && out.first.size() == volume.grid.size;
    const bool needsSecond = plan.classes.size() > 3;
    if (!sameSize) out = {};
    out.plan = plan;
    if (!out.first) out.first = makeMediumTexture(volume.grid.size);
    if (needsSecond != static_cast<bool>(out.second)) {
        out.second = needsSecond ? makeMediumTexture(volume.grid.size) : gl::Texture();
    }
    bakeExtinction(volume, programs, out);
    bakeSkylight(volume, programs, out);
    mapEmptiness(volume, programs, out);
}

gl::Texture bakeNoiseTexture(gl::ProgramCache& programs) {
    gl::Texture noise = gl::Texture::make3D(GL_RG16, glm::ivec3(kNoiseSize));
    noise.setLinear();
    noise.setRepeat();
    noise.bindImage(0, GL_WRITE_ONLY);
    programs.get("pass/bake_noise.comp").dispatch(noise.size());
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    return noise;
}

}  // namespace neph::render
