// sun_depth.comp: about how much optical depth lies between each place and the sun. Paths
// only use it to choose where to spend work, so that coarse steps will do.
#version 450 core
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
#include "../lib/ray_box.glsl"
#include "../medium/sample.glsl"
#include "../medium/total_extinction.glsl"
#include "../shared/reference_layout.glsl"

layout(r16f, binding = kSunDepthImage) writeonly uniform image3D o_depth;

void main() {
    ivec3 texel = ivec3(gl_GlobalInvocationID);
    ivec3 size = imageSize(o_depth);
    if (any(greaterThanEqual(texel, size))) return;
    const float kEnough = 100.0;  // no light gets through
    vec3 texelM = u_.gridExtentM.xyz / vec3(size);
    vec3 positionM = (vec3(texel) + 0.5) * texelM;
    float stepM = min(min(texelM.x, texelM.y), texelM.z);
#if PERIODIC
    const float kFarM = 1e20, kMostSteps = 256.0;
    vec3 farM = vec3(kFarM, kFarM, u_.gridExtentM.z);
    float leaveM = rayBox(positionM, u_.towardsSun.xyz, vec3(-farM.xy, 0.0), farM).y;
    stepM = max(stepM, leaveM / kMostSteps);
#else
    float leaveM = rayBox(positionM, u_.towardsSun.xyz, vec3(0.0), u_.gridExtentM.xyz).y;
#endif
    float depth = 0.0;
    for (float atM = 0.0; atM < leaveM && depth < kEnough; atM += stepM) {
        float lengthM = min(stepM, leaveM - atM);
        vec3 at = positionM + (atM + 0.5 * lengthM) * u_.towardsSun.xyz;
        depth += totalExtinctionPerM(sampleMedium(repeated(at))) * lengthM;
    }
    imageStore(o_depth, texel, vec4(min(depth, kEnough), 0.0, 0.0, 0.0));
}
