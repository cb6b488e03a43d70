// bake_noise.comp: the detail noises into a tiling texture: side by side in two channels, or,
// STACKED, one of them (WISP or billow) into its half of a texture in which wisp lies upon billow,
// which takes half the cache.
#version 450 core
layout(local_size_x = 8, local_size_y = 4, local_size_z = 2) in;
#include "../lib/noise.glsl"
#include "../shared/medium_layout.glsl"

#if STACKED
layout(r8, binding = kNoiseImage) writeonly uniform image3D o_noise;
#else
layout(rg16, binding = kNoiseImage) writeonly uniform image3D o_noise;
#endif

void main() {
    ivec3 voxel = ivec3(gl_GlobalInvocationID);
    ivec3 size = imageSize(o_noise);
#if STACKED
    size.z /= 2;
#endif
    if (any(greaterThanEqual(voxel, size))) return;
    vec3 tile = (vec3(voxel) + 0.5) / vec3(size);
#if !STACKED
    imageStore(o_noise, voxel, vec4(billow(tile), wisp(tile), 0.0, 0.0));
#elif WISP
    imageStore(o_noise, voxel + ivec3(0, 0, size.z), vec4(wisp(tile), 0.0, 0.0, 0.0));
#else
    imageStore(o_noise, voxel, vec4(billow(tile), 0.0, 0.0, 0.0));
#endif
}
