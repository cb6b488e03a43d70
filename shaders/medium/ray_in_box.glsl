// ray_in_box.glsl: the part of a pixel's ray that can meet anything.
#pragma once
#include "../lib/ray_box.glsl"
#include "../lib/sky.glsl"
#include "../shared/frame.glsl"

/// Part of a ray from the eye that is below a height, of which `overM` is the eye's excess.
vec2 belowM(float overM, float slope, float bend) {
    float inside = slope * slope - 4.0 * bend * overM;
    if (inside < 0.0) return vec2(1.0, 0.0);
    float q = -0.5 * (slope + (slope < 0.0 ? -1.0 : 1.0) * sqrt(inside));
    vec2 ends = vec2(q / max(bend, 1e-20), overM / (abs(q) > 1e-20 ? q : 1e-20));
    return vec2(min(ends.x, ends.y), max(ends.x, ends.y));
}

/// Distances at which a ray from the eye enters and leaves a box, no further than the ground;
/// nothing is inside where the first is not less than the second.
vec2 partInBoxM(Ray ray, vec3 lowerM, vec3 upperM) {
    float bend = bendOf(ray.dir);
    vec2 inside = rayBox(ray.originM, ray.dir, lowerM, upperM);
    if (bend > 0.0) {
        // Of the box between its walls, without floor and top.
        vec3 level = vec3(ray.dir.xy, 0.0);
        inside =
            rayBox(vec3(ray.originM.xy, 0.5), level, vec3(lowerM.xy, 0.0), vec3(upperM.xy, 1.0));
        vec2 under = belowM(ray.originM.z - upperM.z, ray.dir.z, bend);
        vec2 tooLow = belowM(ray.originM.z - lowerM.z, ray.dir.z, bend);
        inside = vec2(max(inside.x, under.x), min(inside.y, under.y));
        if (tooLow.x < max(inside.x, 0.0)) inside.x = max(inside.x, tooLow.y);
        if (tooLow.y > inside.y) inside.y = min(inside.y, tooLow.x);
    }
    inside.x = max(inside.x, 0.0);
    float groundM = groundDistanceM(ray);
    if (groundM > 0.0) inside.y = min(inside.y, groundM);
    return inside;
}

/// The same between two corners of the grid: where it repeats, between their heights. A ray that
/// never leaves them is followed as far as haze lets it be seen; air bends all others out.
vec2 partSeenM(Ray ray, vec3 lowerM, vec3 upperM) {
#if PERIODIC
    const float kFarM = 1e20;
    vec2 insideM = partInBoxM(ray, vec3(vec2(-kFarM), lowerM.z), vec3(vec2(kFarM), upperM.z));
    // Without a ground there is nothing behind the Earth either.
    float bend = bendOf(ray.dir);
    vec2 tooLowM = belowM(ray.originM.z - lowerM.z, ray.dir.z, bend);
    bool dips = bend > 0.0 && tooLowM.x < tooLowM.y && tooLowM.x > insideM.x;
    if (dips) insideM.y = min(insideM.y, tooLowM.x);
    if (u_.sky.x < 0.5) insideM.y = min(insideM.y, kSeenM);
    return insideM;
#else
    return partInBoxM(ray, lowerM, upperM);
#endif
}

/// The same of the occupied box.
vec2 insideBoxM(Ray ray) {
    return partSeenM(ray, u_.boxLowerM.xyz, u_.boxUpperM.xyz);
}
