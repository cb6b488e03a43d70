// volume_textures.h: the volume on the GPU, and where in it there is anything at all.
#pragma once
#include <array>
#include <vector>

#include "app/gl/objects.h"
#include "app/gl/program.h"
#include "app/render/brick_map.h"
#include "core/species.h"

namespace neph::render {

/// Mass contents or extinctions as R16F, each species scaled so that its largest value is near the
/// top of the range: 11 bits of precision over nine decades. Absent species have one empty voxel.
struct VolumeTextures {
    RegularGrid grid;
    std::array<gl::Texture, kSpeciesCount> held;
    std::array<float, kSpeciesCount> perTexel{};  ///< held value = texel × perTexel
    std::array<Holding, kSpeciesCount> holdings{};
    /// Lower corners, in bricks, of all bricks that hold or border on anything: ivec4 (xyz, 0).
    gl::Buffer candidates;
    std::vector<glm::ivec3> candidateBricks;  ///< the same

    glm::ivec3 brickCount() const { return (grid.size + kBrickVoxels - 1) / kBrickVoxels; }
    std::size_t bytes() const;
};

VolumeTextures uploadVolume(const SpeciesVolume& volume, gl::ProgramCache& programs);

}  // namespace neph::render
