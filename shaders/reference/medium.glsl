// medium.glsl: the medium as paths of light meet it, and the cells that bound it.
//
// A cell holds the largest extinction that a sample in it can have, and, where that is nothing, how
// many cells around are as empty. Cells lie half a voxel lower than voxels: their walls are where
// interpolation takes up other voxels.
#pragma once
#include "../lib/ray_box.glsl"
#include "../medium/sample.glsl"
#include "../medium/total_extinction.glsl"
#include "../shared/reference_layout.glsl"

// r: bound, 1/m; g: cells to the next occupied one.
layout(binding = kCellsUnit) uniform sampler3D t_cells;

layout(location = kTraceCellLocation) uniform vec3 cellM;    // size
layout(location = kTraceVoxelLocation) uniform vec3 voxelM;  // of the medium

ivec3 cellAt(vec3 positionM) {
    ivec3 last = textureSize(t_cells, 0) - 1;
    return clamp(ivec3(floor((positionM + 0.5 * voxelM) / cellM)), ivec3(0), last);
}

/// What is met next along a ray: where cells end, or something that may be a particle.
struct Stretch {
    float boundPerM;
    float lengthM;  ///< to the wall
    vec3 wallM;     ///< coordinates of the three walls ahead
    int axis;       ///< of the wall that comes first
    int reach;      ///< cells to the wall along each axis
};

Stretch stretchAhead(vec3 positionM, vec3 dir, ivec3 cell) {
    vec2 known = texelFetch(t_cells, cell, 0).rg;
    Stretch s;
    s.boundPerM = known.r;
    s.reach = max(int(known.g), 1);
    vec3 d = divisible(dir);
    bvec3 up = greaterThan(d, vec3(0.0));
    vec3 next = vec3(cell) + mix(vec3(1 - s.reach), vec3(s.reach), up);
    s.wallM = clamp(next * cellM - 0.5 * voxelM, vec3(0.0), u_.gridExtentM.xyz);
    vec3 distanceM = (s.wallM - positionM) / d;
    s.axis = distanceM.x <= distanceM.y ? (distanceM.x <= distanceM.z ? 0 : 2)
                                        : (distanceM.y <= distanceM.z ? 1 : 2);
    s.lengthM = max(distanceM[s.axis], 0.0);
    return s;
}

/// Moves to the wall and into the cell behind it; false where the grid ends there: behind periodic
/// sides it begins again.
bool crossWall(Stretch s, vec3 dir, inout vec3 positionM, inout ivec3 cell) {
    bool up = divisible(dir)[s.axis] > 0.0;
    float wallM = s.wallM[s.axis];
    positionM += s.lengthM * dir;
    positionM[s.axis] = wallM;
    float extentM = u_.gridExtentM[s.axis];
    bool leaves = up ? wallM >= extentM : wallM <= 0.0;
#if PERIODIC
    if (leaves && s.axis < 2) {
        positionM[s.axis] = up ? 0.0 : extentM;
        cell = cellAt(positionM);
        return true;
    }
#endif
    if (leaves) return false;
    int ahead = cell[s.axis] + (up ? s.reach : -s.reach);
    if (s.reach > 1) cell = cellAt(positionM);
    cell[s.axis] = ahead;
    return true;
}
