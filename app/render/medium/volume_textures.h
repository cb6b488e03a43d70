// volume_textures.h: the volume on the GPU, and where in it there is anything at all.
#pragma once
#include <array>
#include <vector>

#include "app/gl/objects.h"
#include "core/grid/species.h"
#include "core/look/medium.h"

namespace neph::render {

#include "shaders/shared/medium_layout.glsl"

/// Mass contents or extinctions as R16F, each species scaled so that its largest value is near the
/// top of the range: 11 bits of precision over nine decades. Absent species have one empty voxel.
struct VolumeTextures {
    RegularGrid grid;
    double cellM = 1.0;  ///< as SpeciesVolume::cellM
    std::array<gl::Texture, kSpeciesCount> held;
    std::array<float, kSpeciesCount> perTexel{};  ///< held value = texel × perTexel
    std::array<Holding, kSpeciesCount> holdings{};
    /// Lower corners, in blocks, of all blocks that hold or border on anything, also across the
    /// sides of the domain.
    std::vector<glm::ivec3> blocks;
    gl::Buffer blockList;  ///< the same: ivec4 (xyz, 0)

    std::size_t bytes() const;
};

/// What a look makes of it.
MediumPlan planMedium(const Look& look, const VolumeTextures& volume);

/// Converts with a few threads.
VolumeTextures uploadVolume(const SpeciesVolume& volume);

}  // namespace neph::render
