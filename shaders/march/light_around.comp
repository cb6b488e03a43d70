// light_around.comp: what clouds change of the light that air around them scatters towards the eye,
// at nodes of a coarse grid: per scattering by molecules, and by haze. One invocation a node.
#version 450 core
#include "../shared/march_layout.glsl"
layout(local_size_x = kSourceGroup) in;
#include "../lib/harmonics.glsl"
#include "../sky/air.glsl"

layout(rgba16f, binding = kAroundMoleculesImage) writeonly uniform image3D o_molecules;
layout(rgba16f, binding = kAroundHazeImage) writeonly uniform image3D o_haze;
layout(std430, binding = kAroundMomentsBuffer) readonly buffer Moments {
    float moments_[];  // of each node, x fastest: kSkyMoments of the sun, the horizon, the zenith
};
layout(location = kAroundLowerLocation) uniform vec3 lowerM;
layout(location = kAroundSpacingLocation) uniform vec3 spacingM;

/// Legendre moments of l = 0 ... 2: of molecules; and of haze (Cornette-Shanks, 0.637) less what
/// goes on as if not scattered, as core/sky/atmosphere.cpp has it.
const vec3 kOfMolecules = vec3(1.0, 0.0, 0.1), kOfHaze = vec3(1.0, 0.700, 0.504) - 0.35;

void main() {
    ivec3 size = imageSize(o_molecules);
    int i = int(gl_GlobalInvocationID.x);
    if (i >= size.x * size.y * size.z) return;
    ivec3 node = ivec3(i % size.x, i / size.x % size.y, i / (size.x * size.y));
    vec3 positionM = lowerM + vec3(node) * spacingM;
    vec3 towards = u_.eyeM.xyz - positionM;
    vec3 travel = towards / max(length(towards), 1e-6);
    DirectionHarmonics y = directionHarmonics(travel, -u_.towardsSun.xyz);
    float atM = altitudeM(positionM);
    vec3 sun = sunAt(atM);
    sun *= 4.0 * kPi * u_.sunRadiance.rgb / max(dot(sun, kLuminance), 1e-12);
    vec3 colours[3] = vec3[](sun, skyPartAt(atM, 0), skyPartAt(atM, 1));
    vec3 molecules = vec3(0.0), haze = vec3(0.0);
    for (int part = 0; part < 3; ++part) {
        vec3 ofDegree = vec3(0.0);
        for (int q = 0; q < kSkyMoments; ++q) {
            int degree = q == 0 ? 0 : q < 4 ? 1 : 2;
            ofDegree[degree] += moments_[(3 * i + part) * kSkyMoments + q] * y.value[q];
        }
        molecules += dot(kOfMolecules, ofDegree) * colours[part];
        haze += dot(kOfHaze, ofDegree) * colours[part];
    }
    imageStore(o_molecules, node, vec4(molecules, 0.0));
    imageStore(o_haze, node, vec4(haze, 0.0));
}
