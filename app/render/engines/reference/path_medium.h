// path_medium.h: a medium of optical classes, made ready for paths of light: bounds of extinction
// and tables to scatter by.
#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "app/gl/objects.h"
#include "app/gl/program.h"
#include "app/render/engines/reference/scattering_tables.h"
#include "app/render/medium/medium_bake.h"

namespace neph::render {

struct PathMedium {
    gl::Texture cells;  ///< RG32F; shaders/reference/medium.glsl
    ScatteringTables tables;
    glm::dvec3 cellM{1.0}, voxelM{1.0};
    int lobeClass = 0;  ///< with the highest forward peak

    std::size_t bytes() const {
        return cells.bytes() + tables.phases.bytes() + tables.scattering.bytes();
    }
};

/// Voxels along the edge of a cell: one, but where there would be too many cells.
int cellVoxelsFor(glm::ivec3 voxels);

/// `grid`: of the medium's voxels. Waits for a read-back of the bounds, which are multiplied by
/// `boundScale`, at least 1. `noise`: the filtered one, where the medium has detail.
PathMedium makePathMedium(const MediumTextures& medium, const RegularGrid& grid, int cellVoxels,
                          double boundScale, const gl::Texture* noise, gl::ProgramCache& programs);

/// Macros by which shaders read such a medium.
std::vector<std::string> mediumDefines(const MediumTextures& medium);

}  // namespace neph::render
