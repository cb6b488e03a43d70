// light_around.comp: what clouds change of the light that air around them scatters towards the eye,
// at nodes of a coarse grid: per scattering by molecules, and by haze. One invocation a node.
// PERIODIC: the moments themselves, of which a ray takes what goes its way.
#version 450 core
#include "../shared/march_layout.glsl"
layout(local_size_x = kSourceGroup) in;
#include "../lib/harmonics.glsl"
#include "sent.glsl"

layout(rgba16f, binding = kAroundMoleculesImage) writeonly uniform image3D o_molecules;
layout(rgba16f, binding = kAroundHazeImage) writeonly uniform image3D o_haze;
layout(std430, binding = kAroundMomentsBuffer) readonly buffer Moments {
    float moments_[];  // of each node, x fastest: kSkyMoments of the sun, the horizon, the zenith
};
layout(location = kAroundLowerLocation) uniform vec3 lowerM;
layout(location = kAroundSpacingLocation) uniform vec3 spacingM;

void main() {
    ivec3 size = imageSize(o_molecules);
#if PERIODIC
    size.z /= kAroundLayers;
#endif
    int i = int(gl_GlobalInvocationID.x);
    if (i >= size.x * size.y * size.z) return;
    ivec3 node = ivec3(i % size.x, i / size.x % size.y, i / (size.x * size.y));
#if PERIODIC
    const int kMoments = kAroundParts * kSkyMoments;
    for (int j = 0; j < kAroundLayers; ++j) {
        vec4 four = vec4(0.0);
        for (int k = 0; k < min(4, kMoments - 4 * j); ++k)
            four[k] = moments_[kMoments * i + 4 * j + k];
        imageStore(o_molecules, node + ivec3(0, 0, j * size.z), four);
    }
#else
    vec3 positionM = lowerM + vec3(node) * spacingM;
    vec3 towards = u_.eyeM.xyz - positionM;
    vec3 travel = towards / max(length(towards), 1e-6);
    DirectionHarmonics y = directionHarmonics(travel, -u_.towardsSun.xyz);
    float atM = altitudeM(positionM);
    vec3 molecules = vec3(0.0), haze = vec3(0.0);
    for (int part = 0; part < kAroundParts; ++part) {
        vec3 ofDegree = vec3(0.0);
        for (int q = 0; q < kSkyMoments; ++q) {
            ofDegree[degreeOfMoment(q)] +=
                moments_[(kAroundParts * i + part) * kSkyMoments + q] * y.value[q];
        }
        molecules += dot(kOfMolecules, ofDegree) * colourAround(part, atM);
        haze += dot(kOfHaze, ofDegree) * colourAround(part, atM);
    }
    imageStore(o_molecules, node, vec4(molecules, 0.0));
    imageStore(o_haze, node, vec4(haze, 0.0));
#endif
}
