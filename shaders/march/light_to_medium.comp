// light_to_medium.comp: the share of sunlight that arrives at each voxel of the march's medium. One
// work group a block that may hold anything.
//
// Layer k of the light lies on the plane between slices k - 1 and k. The layers of one batch of
// slices are held; voxels before or behind are left to other batches.
#version 450 core
layout(local_size_x = 8, local_size_y = 8, local_size_z = 1) in;
#include "../shared/frame.glsl"

layout(binding = 4) uniform sampler2DArray t_light;
layout(rg16f, binding = 0) uniform image3D io_extinction;
layout(std430, binding = 1) readonly buffer Blocks {
    ivec4 blocks[];
};
layout(location = 20) uniform int firstGroup;

/// Layer of the light at a point, with its fraction.
float layerAt(vec3 positionM) {
    float layer = (dot(u_.normal.xyz, positionM) - u_.normal.w) / u_.lightScale.z;
    return clamp(layer, 0.0, float(u_.slices.x));
}

/// `layer` counts within the batch.
float lightAt(vec3 positionM, float layer) {
    float below = min(floor(layer), float(u_.slices.z - 1));
    vec2 at = lightCoordinate(positionM);
    return mix(textureLod(t_light, vec3(at, below), 0.0).r,
               textureLod(t_light, vec3(at, below + 1.0), 0.0).r, layer - below);
}

void main() {
    ivec3 voxel = 8 * blocks[firstGroup + int(gl_WorkGroupID.x)].xyz + ivec3(gl_LocalInvocationID);
    ivec3 size = imageSize(io_extinction);
    vec3 cellM = u_.gridExtentM.xyz / vec3(size);
    for (int z = 0; z < 8; ++z, ++voxel.z) {
        vec3 positionM = (vec3(voxel) + 0.5) * cellM;
        float layer = layerAt(positionM) - float(u_.slices.y);
        bool held = layer >= 0.0 && layer <= float(u_.slices.z);
        if (held && all(lessThan(voxel, size))) {
            float extinctionPerM = imageLoad(io_extinction, voxel).r;
            imageStore(io_extinction, voxel,
                       vec4(extinctionPerM, lightAt(positionM, layer), 0.0, 0.0));
        }
    }
}
