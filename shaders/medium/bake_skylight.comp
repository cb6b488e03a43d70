// bake_skylight.comp: how much diffuse light reaches each voxel of a column, from above and,
// weaker, from the ground.
//
// One invocation a column; writes the last channel of the medium. docs/physics.md §5
#version 450 core
layout(local_size_x = 8, local_size_y = 8) in;
#include "../lib/optics.glsl"
#include "../shared/medium_layout.glsl"

layout(rgba32f, binding = kSkylightImage) uniform image3D io_last;  // the medium's last texture
#if CLASS_TEXTURES > 1
layout(binding = kMedium0Unit) uniform sampler3D t_first;
#endif
layout(location = kSkylightLayerLocation) uniform float layerM;
layout(location = kSkylightAsymmetryLocation) uniform float asymmetry;
layout(location = kSkylightGroundLocation) uniform float groundShare;

float extinctionAt(ivec3 voxel) {
    vec4 last = imageLoad(io_last, voxel);
    float sum = last.x + last.y + last.z;
#if CLASS_TEXTURES > 1
    sum += dot(texelFetch(t_first, voxel, 0), vec4(1.0));
#endif
    return sum;
}

void main() {
    ivec3 size = imageSize(io_last);
    ivec2 column = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(column, size.xy))) return;
    float total = 0.0;
    for (int z = 0; z < size.z; ++z) total += extinctionAt(ivec3(column, z)) * layerM;
    float above = total;
    for (int z = 0; z < size.z; ++z) {
        ivec3 voxel = ivec3(column, z);
        float half_ = 0.5 * extinctionAt(voxel) * layerM;
        above -= half_;
        float fromSky = skyTransmittance(max(above, 0.0), asymmetry);
        float fromGround = skyTransmittance(max(total - above, 0.0), asymmetry);
        above -= half_;
        vec4 last = imageLoad(io_last, voxel);
        last.w = (fromSky + groundShare * fromGround) / (1.0 + groundShare);
        imageStore(io_last, voxel, last);
    }
}
