// noise.glsl: periodic gradient noise and the two textures made of it: billow for liquid, wisp for
// ice. [Perlin02], [PH89]
//
// Positions are in tiles: every function repeats with period 1 in each axis, so that it can be
// baked into a tiling texture. Hashes are integer arithmetic: every machine draws the same cloud.
// Shapes are tuned by eye; both textures lie in [0, 1] and have the same mean, kDetailMean.
#pragma once

const float kDetailMean = 0.30f;            ///< of billow and of wisp over a tile, within 0.005
const float kDetailFeaturesPerTile = 4.0f;  ///< the largest puffs are a quarter of a tile across

/// A well-mixed hash of a lattice point and a seed. Multipliers and shifts: the finaliser of
/// MurmurHash3 [Appleby].
uint hashLattice(ivec3 cell, uint seed) {
    uint h =
        seed + uint(cell.x) * 0x9E3779B1u + uint(cell.y) * 0x85EBCA77u + uint(cell.z) * 0xC2B2AE3Du;
    h = (h ^ (h >> 16u)) * 0x85EBCA6Bu;
    h = (h ^ (h >> 13u)) * 0xC2B2AE35u;
    return h ^ (h >> 16u);
}

/// Dot product of `offset` and one of the 12 edge directions of a cube (4 of them twice).
/// [Perlin02]
float gradientDot(uint hash, vec3 offset) {
    uint h = hash & 15u;
    float u = h < 8u ? offset.x : offset.y;
    float v = h < 4u ? offset.y : ((h == 12u || h == 14u) ? offset.x : offset.z);
    return ((h & 1u) == 0u ? u : -u) + ((h & 2u) == 0u ? v : -v);
}

/// Lattice point wrapped into [0, period); positions down to -64 tiles (GLSL leaves % of a negative
/// number undefined).
ivec3 wrapCell(ivec3 cell, ivec3 period) {
    return (cell + 64 * period) % period;
}

/// Gradient noise in [-1, 1], mean 0, with `cells` lattice cells along each axis of the tile.
float gradientNoise(vec3 tile, ivec3 cells, uint seed) {
    vec3 p = tile * vec3(cells);
    vec3 base = floor(p);
    vec3 f = p - base;
    vec3 w = f * f * f * (f * (f * 6.0f - 15.0f) + 10.0f);
    ivec3 a = wrapCell(ivec3(base), cells);
    ivec3 b = wrapCell(a + 1, cells);
    float x00 =
        mix(gradientDot(hashLattice(a, seed), f),
            gradientDot(hashLattice(ivec3(b.x, a.y, a.z), seed), f - vec3(1.0f, 0.0f, 0.0f)), w.x);
    float x10 =
        mix(gradientDot(hashLattice(ivec3(a.x, b.y, a.z), seed), f - vec3(0.0f, 1.0f, 0.0f)),
            gradientDot(hashLattice(ivec3(b.x, b.y, a.z), seed), f - vec3(1.0f, 1.0f, 0.0f)), w.x);
    float x01 =
        mix(gradientDot(hashLattice(ivec3(a.x, a.y, b.z), seed), f - vec3(0.0f, 0.0f, 1.0f)),
            gradientDot(hashLattice(ivec3(b.x, a.y, b.z), seed), f - vec3(1.0f, 0.0f, 1.0f)), w.x);
    float x11 =
        mix(gradientDot(hashLattice(ivec3(a.x, b.y, b.z), seed), f - vec3(0.0f, 1.0f, 1.0f)),
            gradientDot(hashLattice(b, seed), f - vec3(1.0f)), w.x);
    return mix(mix(x00, x10, w.y), mix(x01, x11, w.y), w.z);
}

/// Puffs with creases between them, in [0, 1]: turbulence, the sum of |noise| over octaves, whose
/// rounded crests meet in sharp valleys like the heads of a cauliflower.
float billow(vec3 tile) {
    float sum = 0.0f;
    float amplitude = 1.0f;
    int cells = 4;
    for (int octave = 0; octave < 4; ++octave) {
        sum += amplitude * abs(gradientNoise(tile, ivec3(cells), uint(octave)));
        amplitude *= 0.5f;
        cells *= 2;
    }
    return clamp(sum * 0.735f, 0.0f, 1.0f);
}

/// Fibres drawn out along x, in [0, 1]: noise stretched more and more the finer it gets, sharpened
/// to threads, bent by a slow warp, and gathered into tufts by the same slow noise.
float wisp(vec3 tile) {
    float bend = gradientNoise(tile, ivec3(2, 2, 2), 11u);
    vec3 p = tile + vec3(0.0f, 0.10f, 0.14f) * bend;
    float threads = 0.0f;
    float amplitude = 0.6f;
    ivec3 cells = ivec3(2, 6, 6);
    for (int octave = 0; octave < 4; ++octave) {
        threads += amplitude * gradientNoise(p, cells, 21u + uint(octave));
        amplitude *= 0.95f;
        cells = ivec3(cells.x + 1, 2 * cells.y, 2 * cells.z);
    }
    threads = clamp(0.495f + 0.9f * threads, 0.0f, 1.0f);
    return threads * threads * clamp(1.15f + 0.9f * bend, 0.0f, 1.0f);
}

/// What the content of a voxel is multiplied by: 1 at amount 0, noise over its mean at amount 1.
/// Its mean over a tile is 1, so that mass is kept over regions larger than a tile; never negative.
float detailFactor(float noise, float amount) {
    return max(0.0f, 1.0f + amount * (noise / kDetailMean - 1.0f));
}
