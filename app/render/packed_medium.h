// packed_medium.h: the medium of the march: two textures, whatever the number of species.
#pragma once
#include "app/render/brick_map.h"
#include "app/render/volume_textures.h"
#include "core/medium.h"

namespace neph::render {

struct PackedMedium {
    MediumPlan plan;
    /// RG16F a voxel. r: extinction of all that is visible, 1/m, the look's noise left out; g: the
    /// share of sunlight that arrives, which the march's light pass fills in.
    gl::Texture extinction;
    /// RGBA8 a cell of 2 x 2 x 2 voxels. r: skylight; then the classes' shares of the extinction
    /// times a weight of their cell. `second` only for more than three classes.
    gl::Texture first, second;
    BrickMap bricks;

    int mixtureCount() const { return second ? 2 : 1; }
    std::size_t bytes() const {
        return extinction.bytes() + first.bytes() + second.bytes() + bricks.map.bytes();
    }
};

/// Bakes on the GPU; waits for a small read-back of the bricks.
void packMedium(const VolumeTextures& volume, const MediumPlan& plan, gl::ProgramCache& programs,
                PackedMedium& out);

}  // namespace neph::render
