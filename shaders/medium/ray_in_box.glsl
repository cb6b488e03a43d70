// ray_in_box.glsl: the part of a pixel's ray that can meet anything.
#pragma once
#include "../lib/ray_box.glsl"
#include "../shared/frame.glsl"

/// Distances at which the ray enters and leaves the occupied box, no further than the ground;
/// nothing is inside where the first is not less than the second.
vec2 insideBoxM(Ray ray) {
    vec2 inside = rayBox(ray.originM, ray.dir, u_.boxLowerM.xyz, u_.boxUpperM.xyz);
    inside.x = max(inside.x, 0.0);
    float groundM = groundDistanceM(ray);
    if (groundM > 0.0) inside.y = min(inside.y, groundM);
    return inside;
}
