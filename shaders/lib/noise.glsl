// noise.glsl: periodic gradient noise, and the two textures that are made from it: billow for
// liquid and wisp for ice. [Perlin02], [PH89]
//
// Positions are in tiles: every function has period 1 in each axis, so that it can be baked into a
// tiling texture. Hashes use integer arithmetic, so that every machine renders the same cloud.
// Shapes are tuned by eye; both textures are in [0, 1] and have the same mean, kDetailMean.
#pragma once

const float kDetailMean = 0.30f;            ///< of billow and wisp over a tile, within 0.005
const float kDetailFeaturesPerTile = 4.0f;  ///< the largest puffs are a quarter of a tile across

/// A lattice point times three odd constants, one per axis, so that the sum of the parts differs
/// between points. The first three primes of [Collet].
uvec3 scatterCell(vec3 cell) {
    return uvec3(cell) * uvec3(0x9E3779B1u, 0x85EBCA77u, 0xC2B2AE3Du);
}

/// Four well-mixed bits of the sum of the parts and a seed: the highest of a 32-bit hash, whose
/// constants were found by a search. [Wellons18]
uint mixBits(uint h) {
    h = (h ^ (h >> 15u)) * 0x2C1B3C6Du;
    h = (h ^ (h >> 12u)) * 0x297A2D39u;
    return h >> 28u;
}

/// Dot product of `offset` and one of the 12 edge directions of a cube (4 of them twice).
/// [Perlin02]
float gradientDot(uint hash, vec3 offset) {
    uint h = mixBits(hash);
    float u = h < 8u ? offset.x : offset.y;
    float v = h < 4u ? offset.y : ((h == 12u || h == 14u) ? offset.x : offset.z);
    return ((h & 1u) == 0u ? u : -u) + ((h & 2u) == 0u ? v : -v);
}

/// Gradient noise in [-1, 1], mean 0, with `cells` lattice cells along each axis of the tile.
float gradientNoise(vec3 tile, ivec3 cells, uint seed) {
    vec3 period = vec3(cells);
    vec3 p = tile * period;
    vec3 base = floor(p);
    vec3 f = p - base;
    vec3 g = f - 1.0f;
    vec3 w = f * f * f * (f * (f * 6.0f - 15.0f) + 10.0f);
    vec3 lower = base - period * floor((base + 0.5f) / period);  // in [0, period)
    vec3 upper = lower + 1.0f;
    upper = upper * (vec3(1.0f) - step(period, upper));  // the last cell meets the first
    uvec3 a = scatterCell(lower);
    uvec3 b = scatterCell(upper);
    uint ya = a.y + a.z + seed;
    uint yb = b.y + a.z + seed;
    uint za = a.y + b.z + seed;
    uint zb = b.y + b.z + seed;
    float x00 = mix(gradientDot(a.x + ya, f), gradientDot(b.x + ya, vec3(g.x, f.y, f.z)), w.x);
    float x10 = mix(gradientDot(a.x + yb, vec3(f.x, g.y, f.z)),
                    gradientDot(b.x + yb, vec3(g.x, g.y, f.z)), w.x);
    float x01 = mix(gradientDot(a.x + za, vec3(f.x, f.y, g.z)),
                    gradientDot(b.x + za, vec3(g.x, f.y, g.z)), w.x);
    float x11 = mix(gradientDot(a.x + zb, vec3(f.x, g.y, g.z)), gradientDot(b.x + zb, g), w.x);
    return mix(mix(x00, x10, w.y), mix(x01, x11, w.y), w.z);
}

/// Puffs with creases between them, in [0, 1]: turbulence, the sum of |noise| over octaves, whose
/// rounded crests meet in sharp valleys like the florets of a cauliflower.
float billow(vec3 tile) {
    float sum = 0.0f;
    float amplitude = 1.0f;
    int cells = 4;
    for (int octave = 0; octave < 4; ++octave) {
        sum += amplitude * abs(gradientNoise(tile, ivec3(cells), uint(octave) * 7919u));
        amplitude *= 0.5f;
        cells *= 2;
    }
    return clamp(sum * 0.7205f, 0.0f, 1.0f);
}

/// Fibres along x, in [0, 1]: noise that is stretched more in its finer octaves, sharpened to
/// threads, bent by a slow warp, and gathered into tufts by the same slow noise.
float wisp(vec3 tile) {
    float bend = gradientNoise(tile, ivec3(2, 2, 2), 11u);
    vec3 p = tile + vec3(0.0f, 0.10f, 0.14f) * bend;
    float threads = 0.0f;
    float amplitude = 0.6f;
    ivec3 cells = ivec3(2, 6, 6);
    for (int octave = 0; octave < 4; ++octave) {
        threads += amplitude * gradientNoise(p, cells, 21u + uint(octave) * 7919u);
        amplitude *= 0.95f;
        cells = ivec3(cells.x + 1, 2 * cells.y, 2 * cells.z);
    }
    threads = clamp(0.5025f + 0.9f * threads, 0.0f, 1.0f);
    return threads * threads * clamp(1.15f + 0.9f * bend, 0.0f, 1.0f);
}

/// Factor on the content of a voxel: 1 at amount 0, noise divided by its mean at amount 1. Up to
/// amount 1 the mean over a tile is 1, so that mass is conserved over regions larger than a tile.
/// Larger amounts cut holes where the factor would be negative, and mass increases: docs/physics.md
/// §8.
float detailFactor(float noise, float amount) {
    return max(0.0f, 1.0f + amount * (noise / kDetailMean - 1.0f));
}
