// source_to_eye.comp: what each active voxel of light sends towards the eye by scattering diffuse
// light, per unit of scaled optical depth (rgb), and how much of it, times the sun's radiance, is
// sunlight scattered once (a). One invocation a node. PERIODIC: the eye stands in another direction
// from each repeat, and the moments themselves are taken over.
#version 450 core
#include "../shared/march_layout.glsl"
layout(local_size_x = kSourceGroup) in;
#include "../lib/harmonics.glsl"
#include "../shared/frame.glsl"
#include "../shared/groups_layout.glsl"
#include "sent.glsl"

layout(rgba16f, binding = kSourceImage) writeonly uniform image3D o_source;
layout(std430, binding = kSourceNodesBuffer) readonly buffer Nodes {
    uint nodes_[];  // by their index, x fastest
};
layout(std430, binding = kSourceMomentsBuffer) readonly buffer Moments {
    uint moments_[];  // kWordsOfNode of each
};
#if BALANCED
layout(std430, binding = kSourceBalancedBuffer) readonly buffer Balanced {
    uint balanced_[];  // kWordsOfBalanced of each
};
#endif
layout(location = kSourceCountLocation) uniform int count;
layout(location = kFirstGroupLocation) uniform int firstGroup;

#if BALANCED && !PERIODIC
/// How much sunlight that is scattered once, per irradiance, the moments of a node hold.
float heldOfBeam(int first, float cosTheta) {
    float held = 0.0;
    float before = 0.0;
    float legendre = 1.0;
    for (int l = 0; l < kBalancedDegrees; ++l) {
        vec2 pair = unpackHalf2x16(balanced_[first + l / 2]);
        held += pair[l % 2] * (2.0 * float(l) + 1.0) * kInverseFourPi * legendre;
        float next =
            ((2.0 * float(l) + 1.0) * cosTheta * legendre - float(l) * before) / float(l + 1);
        before = legendre;
        legendre = next;
    }
    return held;
}
#endif

// Nodes beside the first and the last that repeat others. docs/transport.md
#if PERIODIC
const int kBeside = 1;
#else
const int kBeside = 0;
#endif

#if PERIODIC
const int kLayers = BALANCED == 1 ? kMomentLayers : kMomentLayersUnbalanced;

uint wordOf(int i, int w) {
    if (w < kWordsOfNode) return moments_[kWordsOfNode * i + w];
#if BALANCED
    return balanced_[kWordsOfBalanced * i + w - kWordsOfNode];
#else
    return 0u;
#endif
}

/// Of node i, which lies at a texel.
void send(int i, ivec3 texel) {
    int layer = imageSize(o_source).z / kLayers;
    for (int j = 0; j < kLayers; ++j) {
        vec4 four = vec4(unpackHalf2x16(wordOf(i, 2 * j)), unpackHalf2x16(wordOf(i, 2 * j + 1)));
        imageStore(o_source, texel + ivec3(0, 0, j * layer), four);
    }
}
#else
const int kLayers = 1;

/// Of node i, which lies at a texel.
void send(int i, ivec3 texel) {
    vec3 at = (vec3(texel) + 0.5) / vec3(imageSize(o_source));
    vec3 positionM = (at - u_.sourceOffset.xyz) / u_.sourcePerM.xyz;
    vec3 towards = u_.eyeM.xyz - positionM;
    vec3 travel = towards / max(length(towards), 1e-6);
    DirectionHarmonics y = directionHarmonics(travel, -u_.towardsSun.xyz);
    int first = kWordsOfNode * i;
    float sun = 0.0;
    for (int w = 0; w < kWordsOfSun; ++w) {
        vec2 pair = unpackHalf2x16(moments_[first + w]);
        sun += pair.x * y.value[2 * w];
        if (2 * w + 1 < kSunMoments) sun += pair.y * y.value[2 * w + 1];
    }
    float sky[2] = float[](0.0, 0.0);
    for (int w = 0; w < kWordsOfSky; ++w) {
        vec2 pair = unpackHalf2x16(moments_[first + kWordsOfSun + w]);
        for (int half_ = 0; half_ < 2; ++half_) {
            int q = 2 * w + half_;
            sky[q / kSkyMoments] += pair[half_] * y.value[q % kSkyMoments];
        }
    }
    float atM = altitudeM(positionM);
    vec3 source = sunSent(sun, sunAt(atM)) + skySent(sky[0], sky[1], atM);
    float held = 0.0;
#if BALANCED
    held = 4.0 * kPi * heldOfBeam(kWordsOfBalanced * i, dot(travel, -u_.towardsSun.xyz));
#endif
    imageStore(o_source, texel, vec4(source, held));
}
#endif

void main() {
    int i = kSourceGroup * (firstGroup + int(gl_WorkGroupID.x)) + int(gl_LocalInvocationID.x);
    if (i >= count) return;
    ivec3 held = imageSize(o_source);
    held.z /= kLayers;
    ivec3 size = held - 2 * ivec3(kBeside, kBeside, 0);
    int index = int(nodes_[i]);
    ivec3 node = ivec3(index % size.x, index / size.x % size.y, index / (size.x * size.y));
    for (int y = -kBeside; y <= kBeside; ++y) {
        for (int x = -kBeside; x <= kBeside; ++x) {
            ivec3 texel = node + ivec3(x * size.x + kBeside, y * size.y + kBeside, 0);
            bool isHeld = all(greaterThanEqual(texel, ivec3(0))) && all(lessThan(texel, held));
            if (isHeld) send(i, texel);
        }
    }
}
