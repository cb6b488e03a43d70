// bake_noise.comp: the two detail noises into one tiling texture.
#version 450 core
layout(local_size_x = 8, local_size_y = 4, local_size_z = 2) in;
#include "../lib/noise.glsl"

layout(rg16, binding = 0) writeonly uniform image3D o_noise;

void main() {
    ivec3 voxel = ivec3(gl_GlobalInvocationID);
    ivec3 size = imageSize(o_noise);
    if (any(greaterThanEqual(voxel, size))) return;
    vec3 tile = (vec3(voxel) + 0.5) / vec3(size);
    imageStore(o_noise, voxel, vec4(billow(tile), wisp(tile), 0.0, 0.0));
}
