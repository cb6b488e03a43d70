// light_to_medium.comp: the share of sunlight that arrives at each voxel of the march's medium. One
// work group a block that may hold anything.
//
// Layer k of the light lies on the plane between slices k - 1 and k. The layers of one batch of
// slices are held; voxels before or behind are left to other batches.
#version 450 core
#include "../shared/march_layout.glsl"
layout(local_size_x = kBlockVoxels, local_size_y = kBlockVoxels, local_size_z = 1) in;
#include "../shared/frame.glsl"
#include "../shared/groups_layout.glsl"
#include "../shared/light_layout.glsl"

layout(binding = kLightUnit) uniform sampler2DArray t_light;
layout(rg16f, binding = kMarchExtinctionImage) uniform image3D io_extinction;
layout(std430, binding = kMarchBlocksBuffer) readonly buffer Blocks {
    ivec4 blocks[];
};
layout(location = kFirstGroupLocation) uniform int firstGroup;

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
    ivec3 voxel =
        kBlockVoxels * blocks[firstGroup + int(gl_WorkGroupID.x)].xyz + ivec3(gl_LocalInvocationID);
    ivec3 size = imageSize(io_extinction);
    vec3 cellM = u_.gridExtentM.xyz / vec3(size);
    for (int z = 0; z < kBlockVoxels; ++z, ++voxel.z) {
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
