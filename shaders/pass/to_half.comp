// to_half.comp: one species of the volume from floats to scaled halves.
#version 450 core
layout(local_size_x = 8, local_size_y = 4, local_size_z = 2) in;

layout(binding = 0) uniform sampler3D t_whole;
layout(r16f, binding = 0) writeonly uniform image3D o_half;
layout(location = 0) uniform float scale;

void main() {
    ivec3 voxel = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(voxel, imageSize(o_half)))) return;
    imageStore(o_half, voxel, vec4(scale * texelFetch(t_whole, voxel, 0).r, 0.0, 0.0, 0.0));
}
