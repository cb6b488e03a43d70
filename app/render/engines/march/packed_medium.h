// packed_medium.h: the medium of the march: two textures, whatever the number of species.
#pragma once
#include "app/gl/program.h"
#include "app/render/medium/brick_map.h"
#include "app/render/medium/volume_textures.h"
#include "core/look/medium.h"

namespace neph::render {

/// What of the look's detail is in the extinction.
enum class PackedDetail {
    none,    ///< nothing: the eye adds all of it, sample by sample
    voxels,  ///< down to the size of a voxel: what light and coarse steps can show
};

struct PackedMedium {
    MediumPlan look;  ///< what the look asks for
    /// What the textures hold: `look`, without the noise where it is in the extinction, so that
    /// species that differ by their detail alone share a class.
    MediumPlan plan;
    PackedDetail detail = PackedDetail::voxels;
    /// RG16F a voxel. r: extinction of all that is visible, 1/m; g: the share of sunlight that
    /// arrives, which the march's light pass fills in.
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

/// Bakes on the GPU, with PackedDetail::voxels; waits for a small read-back of the bricks. `noise`:
/// stacked; null when the look has none.
void packMedium(const VolumeTextures& volume, const Look& look, const gl::Texture* noise,
                gl::ProgramCache& programs, PackedMedium& out);

/// The same medium with the other detail; light and bricks stay.
void repackMedium(const VolumeTextures& volume, const Look& look, PackedDetail detail,
                  const gl::Texture* noise, gl::ProgramCache& programs, PackedMedium& out);

}  // namespace neph::render
