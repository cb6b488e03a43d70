// bake_noise.comp: the two detail noises into one tiling texture: side by side in two channels, or,
// STACKED, a tile of billow with a tile of wisp upon it, which takes half the cache.
#version 450 core
layout(local_size_x = 8, local_size_y = 4, local_size_z = 2) in;
#include "../lib/noise.glsl"

#if STACKED
layout(r8, binding = 0) writeonly uniform image3D o_noise;
#else
layout(rg16, binding = 0) writeonly uniform image3D o_noise;
#endif

void main() {
    ivec3 voxel = ivec3(gl_GlobalInvocationID);
    ivec3 size = imageSize(o_noise);
    if (any(greaterThanEqual(voxel, size))) return;
#if STACKED
    size.z /= 2;
    vec3 tile = (vec3(voxel) + 0.5) / vec3(size);
    float noise = voxel.z < size.z ? billow(tile) : wisp(tile - vec3(0.0, 0.0, 1.0));
    imageStore(o_noise, voxel, vec4(noise, 0.0, 0.0, 0.0));
#else
    vec3 tile = (vec3(voxel) + 0.5) / vec3(size);
    imageStore(o_noise, voxel, vec4(billow(tile), wisp(tile), 0.0, 0.0));
#endif
}
