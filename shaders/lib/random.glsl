// random.glsl: stateless random numbers: a hash of what a number is used for. [JO20]
//
// Integer arithmetic only, so that every machine gets the same numbers.
#pragma once

/// Four well-mixed words from four: pcg4d of [JO20].
uvec4 randomWords(uvec4 of) {
    uvec4 v = of * 1664525u + 1013904223u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    v ^= v >> 16u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    return v;
}

/// Uniform in [0, 1): the upper 24 bits, the precision of a float.
float unitOf(uint word) {
    return float(word >> 8u) * 5.9604644775390625e-8f;
}

vec4 unitsOf(uvec4 words) {
    return vec4(unitOf(words.x), unitOf(words.y), unitOf(words.z), unitOf(words.w));
}
