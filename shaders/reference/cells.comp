// cells.comp: the largest extinction that a sample in each cell can have; cells are those of
// shaders/reference/medium.glsl.
#version 450 core
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
#include "../lib/noise.glsl"
#include "../shared/frame_block.glsl"
#include "../shared/reference_layout.glsl"

layout(binding = kMedium0Unit) uniform sampler3D t_medium0;
#if CLASS_TEXTURES > 1
layout(binding = kMedium1Unit) uniform sampler3D t_medium1;
#endif
layout(r32f, binding = kBoundImage) writeonly uniform image3D o_bound;
layout(location = kBoundCellVoxelsLocation) uniform int cellVoxels;  // a side
#if NOISE
// r: billow, g: wisp; levels of maxima.
layout(binding = kNoiseBoundUnit) uniform sampler3D t_noiseBound;
// Of each class's detail.
layout(location = kBoundAmountLocation) uniform float amount[kMaxClasses];
layout(location = kBoundTexelsPerMLocation) uniform vec3 texelsPerM[kMaxClasses];
// 0 billow, 1 wisp.
layout(location = kBoundCharacterLocation) uniform float character[kMaxClasses];
layout(location = kBoundVoxelLocation) uniform vec3 voxelM;
layout(location = kBoundMovedLocation) uniform vec3 movedM;  // FrameBlock::moved

/// The largest factor of detail of a class within a cell: texel i of level l of the bounds has the
/// largest noise that interpolation gives between texels i 2^l and (i + 1) 2^l.
float largestDetail(int index, ivec3 cell) {
    vec3 lower = ((vec3(cell * cellVoxels) - 0.5) * voxelM + movedM) * texelsPerM[index] - 0.5;
    vec3 extent = float(cellVoxels) * voxelM * texelsPerM[index];
    float longest = max(max(extent.x, extent.y), extent.z);
    int level = clamp(int(ceil(log2(max(longest, 1.0)))), 0, textureQueryLevels(t_noiseBound) - 1);
    ivec3 first = ivec3(floor(lower)) >> level;
    ivec3 last = ivec3(floor(lower + extent)) >> level;
    ivec3 mask = (textureSize(t_noiseBound, 0) >> level) - 1;
    last = min(last, first + mask);  // once around is all there is
    float largest = 0.0;
    for (int z = first.z; z <= last.z; ++z) {
        for (int y = first.y; y <= last.y; ++y) {
            for (int x = first.x; x <= last.x; ++x) {
                vec2 noise = texelFetch(t_noiseBound, ivec3(x, y, z) & mask, level).rg;
                largest = max(largest, character[index] < 0.5 ? noise.r : noise.g);
            }
        }
    }
    return detailFactor(largest, amount[index]);
}
#endif

float classOf(vec4 first, vec4 second, int index) {
    return index < 4 ? first[index] : second[index - 4];
}

void main() {
    ivec3 cell = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(cell, imageSize(o_bound)))) return;
    ivec3 size = textureSize(t_medium0, 0);
    ivec3 lower = cell * cellVoxels - 1;
    ivec3 upper = (cell + 1) * cellVoxels;
    lower.z = max(lower.z, 0);
    upper.z = min(upper.z, size.z);
#if !PERIODIC
    lower.xy = max(lower.xy, ivec2(0));
    upper.xy = min(upper.xy, size.xy);
#endif
    float factor[CLASSES];
    for (int i = 0; i < CLASSES; ++i) {
        factor[i] = 1.0;
#if NOISE
        if (amount[i] > 0.0) factor[i] = largestDetail(i, cell);
#endif
    }
    float largest = 0.0;
    vec4 second = vec4(0.0);
    for (int z = lower.z; z < upper.z; ++z) {
        for (int y = lower.y; y < upper.y; ++y) {
            for (int x = lower.x; x < upper.x; ++x) {
                ivec3 voxel = ivec3(x, y, z);
#if PERIODIC
                voxel = (voxel + size) % size;
#endif
                vec4 first = texelFetch(t_medium0, voxel, 0);
#if CLASS_TEXTURES > 1
                second = texelFetch(t_medium1, voxel, 0);
#endif
                float sum = 0.0;
                for (int i = 0; i < CLASSES; ++i) sum += factor[i] * classOf(first, second, i);
                largest = max(largest, sum);
            }
        }
    }
    // Interpolation is not exact to the last digit.
    imageStore(o_bound, cell, vec4(1.001 * largest, 0.0, 0.0, 0.0));
}
