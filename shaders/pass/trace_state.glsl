// trace_state.glsl: a path of light on its way, as it is kept between two dispatches.
#pragma once

struct Path {
    vec3 positionM;    ///< in grid space
    vec3 dir;          ///< unit, away from the eye
    ivec3 cell;        ///< that the position is in
    float depth;       ///< optical depth, by the bound, to what may be the next particle
    bool toSun;        ///< this stretch asks how much sunlight arrives
    float sunlight;    ///< share of it that is left so far
    vec3 sunlit;       ///< radiance that it would add if all of it arrived
    vec3 vertexM;      ///< where the path goes on afterwards,
    vec3 nextDir;      ///< and which way; zero where it ends
    float density;     ///< with which `dir` was drawn, per steradian, where that is into the sun
    float firstM;      ///< distance to the first particle; -1 before
    vec3 weight;       ///< of light that arrives along the path
    vec3 wavelengths;  ///< chances that the path was drawn at each; they add to 1
    int hero;          ///< wavelength at which it is drawn
    int scatterings;
    vec3 radiance;  ///< that has arrived
    uint ticket;    ///< number of the path
    uint draws;     ///< of random numbers
    bool direct;    ///< sunlight that arrives at the next turn at once counts
    int stage;
};

// Stages, in the order in which main() asks for them. From kParticle on the path turns; at a
// surface, or a detector inside the medium, `nextDir` is the axis around which it does.
const int kIdle = 0, kWaiting = 1, kAiming = 2, kFlying = 3, kLeft = 4, kDone = 5;
const int kParticle = 6, kSurface = 7, kInside = 8;
const int kPathWords =
    9;  // of four, in the buffer; word after word, so that lanes lie side by side

layout(std430, binding = 3) buffer Lanes {
    uvec4 lanes_[];
};
layout(location = 0) uniform int laneCount;

uvec4 bitsOf(vec3 v, uint w) {
    return uvec4(floatBitsToUint(v), w);
}

void savePath(Path p, uint lane) {
    uint n = uint(laneCount);
    uint flags = uint(p.stage) | (p.toSun ? 16u : 0u) | (p.direct ? 32u : 0u) | uint(p.hero) << 6u;
    lanes_[lane] = bitsOf(p.positionM, floatBitsToUint(p.depth));
    lanes_[lane + n] = bitsOf(p.dir, floatBitsToUint(p.sunlight));
    lanes_[lane + 2u * n] = bitsOf(p.vertexM, floatBitsToUint(p.density));
    lanes_[lane + 3u * n] = bitsOf(p.nextDir, floatBitsToUint(p.firstM));
    lanes_[lane + 4u * n] = bitsOf(p.weight, flags);
    lanes_[lane + 5u * n] = bitsOf(p.wavelengths, uint(p.scatterings));
    lanes_[lane + 6u * n] = bitsOf(p.radiance, p.ticket);
    lanes_[lane + 7u * n] = bitsOf(p.sunlit, p.draws);
    lanes_[lane + 8u * n] = uvec4(p.cell, 0u);
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
    p.nextDir = uintBitsToFloat(words[3].xyz);
    p.firstM = uintBitsToFloat(words[3].w);
    p.weight = uintBitsToFloat(words[4].xyz);
    p.stage = int(flags & 15u);
    p.toSun = (flags & 16u) != 0u;
    p.direct = (flags & 32u) != 0u;
    p.hero = int(flags >> 6u);
    p.wavelengths = uintBitsToFloat(words[5].xyz);
    p.scatterings = int(words[5].w);
    p.radiance = uintBitsToFloat(words[6].xyz);
    p.ticket = words[6].w;
    p.sunlit = uintBitsToFloat(words[7].xyz);
    p.draws = words[7].w;
    p.cell = ivec3(words[8].xyz);
    return p;
}
