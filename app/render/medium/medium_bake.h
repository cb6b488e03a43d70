// medium_bake.h: the medium of half-angle slicing: one extinction per optical class, as the look
// has it.
#pragma once
#include "app/gl/program.h"
#include "app/render/medium/brick_map.h"
#include "app/render/medium/volume_textures.h"
#include "core/look/medium.h"

namespace neph::render {

/// Channels: classes first; skylight in the last channel.
struct MediumTextures {
    MediumPlan plan;
    gl::Texture first, second;  ///< RGBA32F; `second` only for more than three classes
    BrickMap bricks;

    int textureCount() const { return second ? 2 : 1; }
    std::size_t bytes() const { return first.bytes() + second.bytes() + bricks.map.bytes(); }
};

/// Diffuse light from below relative to that from above: about the albedo of land. docs/physics.md
/// §5
inline constexpr float kGroundShare = 0.2f;

/// Bakes on the GPU; waits for a small read-back of the bricks.
void bakeMedium(const VolumeTextures& volume, const MediumPlan& plan, gl::ProgramCache& programs,
                MediumTextures& out);

}  // namespace neph::render
