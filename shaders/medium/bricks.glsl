// bricks.glsl: what is known of the medium brick by brick: emptiness, to skip it.
#pragma once
#include "../lib/ray_box.glsl"
#include "../shared/frame.glsl"
#include "../shared/medium_layout.glsl"

// Distance to the nearest occupied brick, in bricks.
layout(binding = kBricksUnit) uniform usampler3D t_bricks;

/// Bricks around the point that are certainly empty: 0 in an occupied brick.
int emptiness(vec3 positionM) {
    ivec3 brick = clamp(ivec3(positionM / u_.brickM.xyz), ivec3(0), textureSize(t_bricks, 0) - 1);
    return int(texelFetch(t_bricks, brick, 0).r);
}

/// Distance along the unit `dir` to the wall of the empty block of `bricks` around the point.
float emptyDistanceM(vec3 positionM, vec3 dir, int bricks) {
    vec3 brick = floor(positionM / u_.brickM.xyz);
    vec3 ahead = mix(brick - float(bricks - 1), brick + float(bricks),
                     greaterThan(divisible(dir), vec3(0.0)));
    vec3 distance = (ahead * u_.brickM.xyz - positionM) / divisible(dir);
    return min(min(distance.x, distance.y), distance.z);
}
