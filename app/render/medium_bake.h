// medium_bake.h: the volume on the GPU and what a look makes of it.
#pragma once
#include <array>
#include <vector>

#include "app/gl/objects.h"
#include "app/gl/program.h"
#include "app/render/engines/slice_plan.h"
#include "core/medium.h"
#include "core/species.h"

namespace neph::render {

/// Mass contents or extinctions as uploaded; absent species have one empty voxel.
struct VolumeTextures {
    RegularGrid grid;
    std::array<gl::Texture, kSpeciesCount> held;
    std::array<Holding, kSpeciesCount> holdings{};

    std::size_t bytes() const;
};
VolumeTextures uploadVolume(const SpeciesVolume& volume);

/// Extinction per class and skylight, with a map of what is empty. Channels: classes first;
/// skylight in the last channel.
struct MediumTextures {
    MediumPlan plan;
    gl::Texture first, second;  ///< RGBA32F; `second` only for more than three classes
    gl::Texture emptiness;      ///< R8UI a brick: Chebyshev distance to the nearest occupied brick
    SliceBox occupied;          ///< in grid space; empty (lower == upper) when nothing is there
    glm::dvec3 brickM{1.0};

    int textureCount() const { return second ? 2 : 1; }
    bool empty() const { return occupied.lowerM == occupied.upperM; }
    std::size_t bytes() const { return first.bytes() + second.bytes() + emptiness.bytes(); }
};

/// Voxels along the edge of an occupancy brick.
inline constexpr int kBrickVoxels = 8;

/// Bakes on the GPU; waits for a small read-back of the bricks.
void bakeMedium(const VolumeTextures& volume, const MediumPlan& plan, gl::ProgramCache& programs,
                MediumTextures& out);

/// A 128³ tiling texture of the two detail noises.
gl::Texture bakeNoiseTexture(gl::ProgramCache& programs);

}  // namespace neph::render
