// ground.glsl: a plain of fields, so that ground has a scale.
#pragma once
#include "random.glsl"

const float kFieldM = 805.0f;  ///< half a mile, as farmland is divided in the Great Plains

/// In [0, 1): the same for every point of a square of ground.
float squareOfGround(vec2 square, uint kind) {
    ivec2 cell = ivec2(floor(square));
    return unitsOf(randomWords(uvec4(uint(cell.x), uint(cell.y), kind, 0u))).x;
}

/// Smooth noise about 0, within 1/2, with bumps of one unit.
float bumpsOfGround(vec2 at, uint kind) {
    vec2 f = at - floor(at);
    vec2 s = f * f * (3.0f - 2.0f * f);
    float lower = mix(squareOfGround(at, kind), squareOfGround(at + vec2(1.0f, 0.0f), kind), s.x);
    float upper = mix(squareOfGround(at + vec2(0.0f, 1.0f), kind),
                      squareOfGround(at + vec2(1.0f, 1.0f), kind), s.x);
    return mix(lower, upper, s.y) - 0.5f;
}

/// How much of a pattern is left where a pixel covers so much ground.
float seenOfGround(float patternM, float pixelM) {
    return 1.0f / (1.0f + 4.0f * pixelM * pixelM / (patternM * patternM));
}

/// What the albedo of the ground is multiplied by; its mean is 1. `pixelM`: what a pixel covers.
float groundPattern(vec2 positionM, float pixelM) {
    float fields = squareOfGround(positionM / kFieldM, 1u) - 0.5f;
    float hills = bumpsOfGround(positionM / 9000.0f, 2u);
    float regions = bumpsOfGround(positionM / 41000.0f, 3u);
    return 1.0f + 0.4f * fields * seenOfGround(kFieldM, pixelM) +
           0.2f * hills * seenOfGround(9000.0f, pixelM) +
           0.2f * regions * seenOfGround(41000.0f, pixelM);
}
