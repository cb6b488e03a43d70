// light_nodes.comp: the mean extinction of each class around each voxel of light, one invocation a
// node. A linear fetch between voxels is the mean of those around it: as many of them along an axis
// as a node has voxels make the mean over the node's share of space.
#version 450 core
layout(local_size_x = 8, local_size_y = 4, local_size_z = 2) in;
#include "packed_sample.glsl"

layout(std430, binding = kNodesExtinctionBuffer) writeonly buffer Extinctions {
    float extinctionPerM_[];  // class after class, 1/m
};
layout(location = kNodesFirstVoxelLocation) uniform vec3 firstAt;  // in voxels, of node 0
layout(location = kNodesSpacingLocation) uniform vec3 spacing;     // in voxels, between nodes
layout(location = kNodesSamplesLocation) uniform ivec3 samples;    // of each node: voxels there are
layout(location = kNodesCountLocation) uniform ivec3 nodes;

/// Whether bricks say that nothing is within `voxels` of a voxel.
bool isEmptyAround(vec3 voxel, float voxels) {
    vec3 last = vec3(textureSize(t_extinction, 0) - 1);
    ivec3 brick = ivec3(clamp(voxel, vec3(0.0), last)) / kBrickVoxels;
    float empty = float(texelFetch(t_bricks, brick, 0).r);
    return (empty - 1.0) * float(kBrickVoxels) > voxels;
}

void main() {
    ivec3 node = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(node, nodes))) return;
    vec3 size = vec3(textureSize(t_extinction, 0));
    vec3 middle = firstAt + vec3(node) * spacing;
    float sum[CLASSES];
    for (int i = 0; i < CLASSES; ++i) sum[i] = 0.0;
    float reach = float(max(max(samples.x, samples.y), samples.z));
    ivec3 taken = isEmptyAround(middle, reach) ? ivec3(0) : samples;
    vec3 apart = spacing / vec3(samples);
    for (int z = 0; z < taken.z; ++z) {
        for (int y = 0; y < taken.y; ++y) {
            for (int x = 0; x < taken.x; ++x) {
                vec3 at = (middle + apart * (vec3(x, y, z) + 0.5) - 0.5 * spacing) / size;
                if (any(lessThan(at, vec3(0.0))) || any(greaterThan(at, vec3(1.0)))) continue;
                MediumSample s = sampleMedium(at * u_.gridExtentM.xyz);
                for (int i = 0; i < CLASSES; ++i) sum[i] += s.extinctionPerM[i];
            }
        }
    }
    int index = node.x + nodes.x * (node.y + nodes.y * node.z);
    int count = nodes.x * nodes.y * nodes.z;
    float share = 1.0 / float(samples.x * samples.y * samples.z);
    for (int i = 0; i < CLASSES; ++i) extinctionPerM_[i * count + index] = share * sum[i];
}
