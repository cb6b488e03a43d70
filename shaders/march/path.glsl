// path.glsl: a pixel's ray through the medium of the march: where its samples lie, and how it skips
// what is empty.
#pragma once
#include "../lib/ray_box.glsl"
#include "../medium/bricks.glsl"
#include "../shared/frame.glsl"
#include "../shared/march_layout.glsl"
#include "../sky/air.glsl"
#include "sunlight.glsl"

layout(binding = kMarchBlueNoiseUnit) uniform sampler2D t_blueNoise;

const int kRun = 4;
// Transmittance below which a ray ends, and one towards the sun's disc, which outshines clouds.
const float kOpaque = 0.005, kOpaqueToSun = 1e-7;
const float kLongest = ADAPTIVE == 1 ? 2.0 : 1.0;  // step, in the shortest

/// A ray in the units in which it is used.
struct Path {
    Ray ray;
    vec3 at, atPerM;          // in the medium's texture
    vec3 brick, brickPerM;    // in bricks
    float bendM, bendBricks;  // upwards, per square of the distance
    AirRay air;
    float startM, endM;  // of the part that can meet anything
    float stepM;         // the shortest
    bool sunwards;       // what is scattered forward is seen
    float place;         // of the samples on the ray, in shortest steps, less than the longest
    float opaque;        // transmittance below which it ends
};

/// In [0, 1): a different place for each pixel and each image. The golden ratio's fraction
/// spreads the images evenly.
float placeInStep(ivec2 pixel) {
    float pattern = texelFetch(t_blueNoise, (pixel + u_.whole.zw) & (kBlueNoiseSize - 1), 0).r;
    return fract(pattern + 0.61803399 * float(u_.sampling.x));
}

Path pathOf(ivec2 pixel, Ray ray, vec2 insideM) {
    Path path;
    path.ray = ray;
    path.at = ray.originM / u_.gridExtentM.xyz;
    path.atPerM = ray.dir / u_.gridExtentM.xyz;
    path.brick = ray.originM / u_.brickM.xyz;
    path.brickPerM = divisible(ray.dir) / u_.brickM.xyz;
    path.bendM = bendOf(ray.dir);
    path.bendBricks = path.bendM / u_.brickM.z;
    if (hasAir()) path.air = airRay(ray.dir);
    path.startM = insideM.x;
    path.endM = insideM.y;
    path.stepM = 1.0 / length(ray.dir * u_.march.xyz);
    path.sunwards = dot(u_.towardsSun.xyz, ray.dir) > kPeakEndCos;
    path.place = kLongest * placeInStep(pixel);
    path.opaque = sunDisc(ray.dir).g > 0.0 ? kOpaqueToSun : kOpaque;
    return path;
}

/// Samples lie at the same distances from the eye whatever was skipped before, so that no brick
/// shows in an image. The first and the last lie at the ends of the path.
float stationM(Path path, float index) {
    return clamp((index + path.place) * path.stepM, path.startM, path.endM);
}

/// The last sample that begins a longest step and does not lie beyond.
float stationBefore(Path path, float atM) {
    return kLongest * floor((atM / path.stepM - path.place) / kLongest);
}

/// Leaps from empty brick to empty brick; returns where that ends.
float leap(Path path, float atM, inout uint skipped) {
    ivec3 last = textureSize(t_bricks, 0) - 1;
    while (true) {
        vec3 p = path.brick + atM * path.brickPerM;
        p.z += path.bendBricks * atM * atM;
        vec3 perM = path.brickPerM;
        perM.z = divisible(vec3(perM.z + 2.0 * path.bendBricks * atM)).z;
        vec3 ahead = step(0.0, perM);
#if PERIODIC
        vec2 bricks = u_.gridExtentM.xy / u_.brickM.xy;
        p.xy = clamp(p.xy - bricks * floor(p.xy / bricks), vec2(0.0), bricks);
#endif
        vec3 corner = floor(p);
        float reach = float(texelFetch(t_bricks, clamp(ivec3(corner), ivec3(0), last), 0).r);
        if (reach == 0.0 || atM >= path.endM) return atM;
        vec3 wall = corner + mix(vec3(1.0 - reach), vec3(reach), ahead);
#if PERIODIC
        // Bricks are counted to the sides, where the next begin: the last may be narrower.
        wall.xy = clamp(wall.xy, vec2(0.0), bricks);
#endif
        vec3 distanceM = (wall - p) / perM;
        // A thousandth of a brick over the wall, so that rounding cannot hold the ray at it.
        atM += min(min(distanceM.x, distanceM.y), distanceM.z) + 1e-3 * u_.brickM.x;
        ++skipped;
    }
}

vec3 inTexture(Path path, float atM) {
    vec3 at = path.at + atM * path.atPerM;
    at.z += path.bendM / u_.gridExtentM.z * atM * atM;
    return at;
}

vec3 positionOn(Path path, float atM) {
    vec3 positionM = path.ray.originM + atM * path.ray.dir;
    positionM.z += path.bendM * atM * atM;
    return positionM;
}
