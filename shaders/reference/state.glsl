// state.glsl: a path of light on its way, as it is kept between two dispatches.
#pragma once
#include "../shared/reference_layout.glsl"

struct Path {
    vec3 positionM;    ///< in grid space
    vec3 dir;          ///< unit, away from the eye
    ivec3 cell;        ///< that the position is in
    float depth;       ///< optical depth, by the bound, to what may be the next particle
    float airM;        ///< length of this stretch at which air is met, where it may be
    float flownM;      ///< of it, so far
    bool toSun;        ///< this stretch asks how much sunlight arrives
    float sunlight;    ///< share of it that is left so far
    vec3 sunlit;       ///< radiance that it would add if all of it arrived
    vec3 vertexM;      ///< where the path goes on afterwards
    vec3 axis;         ///< at a vertex: the way in, or the normal
    float density;     ///< with which `dir` was drawn, per steradian, where that is into the sun
    float firstM;      ///< distance to the first particle; -1 before
    vec3 throughput;   ///< of light that arrives along the path
    vec3 wavelengths;  ///< chances that the path was drawn at each; they add to 1
    int hero;          ///< wavelength at which it is drawn
    int scatterings;
    vec3 radiance;  ///< that has arrived
    uint ticket;    ///< number of the path
    uvec2 key;      ///< of its random numbers: where it begins, and its pass
    uint draws;     ///< of random numbers
    bool direct;    ///< sunlight that arrives at the next scatter directly counts
    bool veil;      ///< went on from air that the eye looks through
    int waiting;    ///< paths that wait until this, a branch of theirs, has ended
    int kind;       ///< of the vertex
    int stage;
};

// Stages. At a vertex a path first samples the sunlight (kMet), then scatters (kScattering).
const int kIdle = 0, kWaiting = 1, kAiming = 2, kFlying = 3, kLeft = 4, kDone = 5, kMet = 6,
          kScattering = 7;
// Kinds of vertex. kInside: a detector. kAir: molecules or haze.
const int kParticle = 0, kSurface = 1, kInside = 2, kAir = 3;

// Word after word, so that lanes lie side by side.
layout(std430, binding = kLanesBuffer) buffer Lanes {
    uvec4 lanes_[];
};
layout(location = kTraceLanesLocation) uniform int laneCount;

uvec4 bitsOf(vec3 v, uint w) {
    return uvec4(floatBitsToUint(v), w);
}

void savePath(Path p, uint lane) {
    uint n = uint(laneCount);
    uint flags = uint(p.stage) | (p.toSun ? 16u : 0u) | (p.direct ? 32u : 0u) |
                 uint(p.waiting) << 6u | uint(p.hero) << 10u | uint(p.kind) << 12u |
                 (p.veil ? 1u << 14u : 0u);
    lanes_[lane] = bitsOf(p.positionM, floatBitsToUint(p.depth));
    lanes_[lane + n] = bitsOf(p.dir, floatBitsToUint(p.sunlight));
    lanes_[lane + 2u * n] = bitsOf(p.vertexM, floatBitsToUint(p.density));
    lanes_[lane + 3u * n] = bitsOf(p.axis, floatBitsToUint(p.firstM));
    lanes_[lane + 4u * n] = bitsOf(p.throughput, flags);
    lanes_[lane + 5u * n] = bitsOf(p.wavelengths, uint(p.scatterings));
    lanes_[lane + 6u * n] = bitsOf(p.radiance, p.ticket);
    lanes_[lane + 7u * n] = bitsOf(p.sunlit, p.draws);
    lanes_[lane + 8u * n] = uvec4(p.cell, floatBitsToUint(p.airM));
    lanes_[lane + 9u * n] = uvec4(p.key, floatBitsToUint(p.flownM), 0u);
}

Path loadPath(uint lane) {
    uvec4 words[kPathWords];
    for (int i = 0; i < kPathWords; ++i) words[i] = lanes_[lane + uint(i * laneCount)];
    uint flags = words[4].w;
    Path p;
    p.positionM = uintBitsToFloat(words[0].xyz);
    p.depth = uintBitsToFloat(words[0].w);
    p.dir = uintBitsToFloat(words[1].xyz);
    p.sunlight = uintBitsToFloat(words[1].w);
    p.vertexM = uintBitsToFloat(words[2].xyz);
    p.density = uintBitsToFloat(words[2].w);
    p.axis = uintBitsToFloat(words[3].xyz);
    p.firstM = uintBitsToFloat(words[3].w);
    p.throughput = uintBitsToFloat(words[4].xyz);
    p.stage = int(flags & 15u);
    p.toSun = (flags & 16u) != 0u;
    p.direct = (flags & 32u) != 0u;
    p.waiting = int(flags >> 6u & 15u);
    p.hero = int(flags >> 10u & 3u);
    p.kind = int(flags >> 12u & 3u);
    p.veil = (flags >> 14u & 1u) != 0u;
    p.wavelengths = uintBitsToFloat(words[5].xyz);
    p.scatterings = int(words[5].w);
    p.radiance = uintBitsToFloat(words[6].xyz);
    p.ticket = words[6].w;
    p.sunlit = uintBitsToFloat(words[7].xyz);
    p.draws = words[7].w;
    p.cell = ivec3(words[8].xyz);
    p.airM = uintBitsToFloat(words[8].w);
    p.key = words[9].xy;
    p.flownM = uintBitsToFloat(words[9].z);
    return p;
}

uint waitingWord(int place, uint lane) {
    return lane + uint((kPathWords + kWaitingWords * place) * laneCount);
}

/// Lets the path wait, which would go on: fly on, or with the light at its vertex.
void suspend(inout Path p, uint lane) {
    uint n = uint(laneCount);
    uint at = waitingWord(p.waiting, lane);
    lanes_[at] = bitsOf(p.positionM, floatBitsToUint(p.density));
    lanes_[at + n] = bitsOf(p.stage == kMet ? p.axis : p.dir, uint(p.scatterings));
    lanes_[at + 2u * n] = bitsOf(p.throughput, uint(p.stage));
    lanes_[at + 3u * n] = bitsOf(p.wavelengths, uint(p.kind) | (p.veil ? 4u : 0u));
    ++p.waiting;
}

/// Goes on with the path that waits for the end of this.
void takeUp(inout Path p, uint lane) {
    uint n = uint(laneCount);
    --p.waiting;
    uint at = waitingWord(p.waiting, lane);
    uvec4 words[kWaitingWords];
    for (int i = 0; i < kWaitingWords; ++i) words[i] = lanes_[at + uint(i) * n];
    p.positionM = p.vertexM = uintBitsToFloat(words[0].xyz);
    p.density = uintBitsToFloat(words[0].w);
    p.dir = p.axis = uintBitsToFloat(words[1].xyz);
    p.scatterings = int(words[1].w);
    p.throughput = uintBitsToFloat(words[2].xyz);
    p.stage = int(words[2].w);
    p.wavelengths = uintBitsToFloat(words[3].xyz);
    p.kind = int(words[3].w & 3u);
    p.veil = (words[3].w & 4u) != 0u;
}
