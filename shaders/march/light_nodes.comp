// light_nodes.comp: the mean extinction of each class around each voxel of light, one invocation a
// node, from samples spread evenly over the node's share of space. A linear fetch between voxels is
// the mean of those around it; detail is as fine as the distance of samples.
#version 450 core
layout(local_size_x = 8, local_size_y = 4, local_size_z = 2) in;
#include "detail.glsl"
#include "packed_sample.glsl"

layout(std430, binding = kNodesExtinctionBuffer) writeonly buffer Extinctions {
    float extinctionPerM_[];  // class after class, 1/m
};
layout(location = kNodesFirstVoxelLocation) uniform ivec3 firstVoxel;
layout(location = kNodesStrideLocation) uniform ivec3 stride;
layout(location = kNodesCountLocation) uniform ivec3 nodes;
layout(location = kNodesSamplesLocation) uniform ivec3 samplesOfNode;  // along each axis

/// Whether bricks say that nothing is within `voxels` of a voxel.
bool isEmptyAround(vec3 voxel, float voxels) {
    vec3 last = vec3(textureSize(t_extinction, 0) - 1);
    ivec3 brick = ivec3(clamp(voxel, vec3(0.0), last)) / kBrickVoxels;
    float empty = float(texelFetch(t_bricks, brick, 0).r);
    return (empty - 1.0) * float(kBrickVoxels) > voxels;
}

/// Adds the extinctions at a point, with detail as fine as the distance of samples.
void add(vec3 positionM, vec3 distanceM, inout float sum[CLASSES]) {
    float extinctionPerM = textureLod(t_extinction, positionM / u_.gridExtentM.xyz, 0.0).r;
    Mixture mixture = mixtureAt(positionM);
    float finestM = min(min(distanceM.x, distanceM.y), distanceM.z);
    for (int i = 0; i < CLASSES; ++i) {
        float part = extinctionPerM * mixture.share[i];
#if NOISE
        part *= detailOfClass(i, positionM, finestM);
#endif
        sum[i] += part;
    }
}

void main() {
    ivec3 node = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(node, nodes))) return;
    vec3 size = vec3(textureSize(t_extinction, 0));
    vec3 middle = vec3(firstVoxel + node * stride) + 0.5;
    float sum[CLASSES];
    for (int i = 0; i < CLASSES; ++i) sum[i] = 0.0;
    float reach = float(max(max(stride.x, stride.y), stride.z));
    ivec3 samples = isEmptyAround(middle, reach) ? ivec3(0) : samplesOfNode;
    vec3 spacing = vec3(stride) / vec3(samplesOfNode);  // in voxels
    for (int z = 0; z < samples.z; ++z) {
        for (int y = 0; y < samples.y; ++y) {
            for (int x = 0; x < samples.x; ++x) {
                vec3 at = middle + (vec3(x, y, z) + 0.5) * spacing - 0.5 * vec3(stride);
                if (any(lessThan(at, vec3(0.0))) || any(greaterThan(at, size))) continue;
                add(at / size * u_.gridExtentM.xyz, spacing * u_.gridExtentM.xyz / size, sum);
            }
        }
    }
    int index = node.x + nodes.x * (node.y + nodes.y * node.z);
    int count = nodes.x * nodes.y * nodes.z;
    float share = 1.0 / float(samplesOfNode.x * samplesOfNode.y * samplesOfNode.z);
    for (int i = 0; i < CLASSES; ++i) extinctionPerM_[i * count + index] = share * sum[i];
}
