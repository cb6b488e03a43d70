// light_to_medium.comp: the sun's light at each voxel of the march's medium, as an optical depth:
// -log2 of the share that arrives. One work group a brick that may hold anything.
//
// Layer k of the light lies on the plane between slices k - 1 and k.
#version 450 core
layout(local_size_x = 8, local_size_y = 8, local_size_z = 1) in;
#include "frame.glsl"

const float kDarkest = 1.5e-5;  // the smallest step of 16 bits
layout(binding = 4) uniform sampler2DArray t_light;
layout(rg16f, binding = 0) uniform image3D io_extinction;
layout(std430, binding = 1) readonly buffer Candidates {
    ivec4 candidates[];
};
layout(location = 20) uniform int firstGroup;

float lightAt(vec3 positionM) {
    float slice = (dot(u_.normal.xyz, positionM) - u_.normal.w) / u_.lightScale.z;
    float layer = clamp(slice, 0.0, float(u_.slices.x));
    float below = min(floor(layer), float(u_.slices.x - 1));
    vec2 at = lightCoordinate(positionM);
    return mix(textureLod(t_light, vec3(at, below), 0.0).r,
               textureLod(t_light, vec3(at, below + 1.0), 0.0).r, layer - below);
}

void main() {
    ivec3 voxel =
        8 * candidates[firstGroup + int(gl_WorkGroupID.x)].xyz + ivec3(gl_LocalInvocationID);
    ivec3 size = imageSize(io_extinction);
    vec3 cellM = u_.gridExtentM.xyz / vec3(size);
    for (int z = 0; z < 8; ++z, ++voxel.z) {
        float light = lightAt((vec3(voxel) + 0.5) * cellM);
        float extinctionPerM = imageLoad(io_extinction, voxel).r;
        if (all(lessThan(voxel, size))) {
            imageStore(io_extinction, voxel,
                       vec4(extinctionPerM, -log2(max(light, kDarkest)), 0.0, 0.0));
        }
    }
}
