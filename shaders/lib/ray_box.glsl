// ray_box.glsl: where a ray is inside a box, and how far it is to the wall.
#pragma once

/// The direction with components too small to divide by made small and positive.
vec3 divisible(vec3 dir) {
    const float kTiny = 1e-9f;
    return vec3(abs(dir.x) < kTiny ? kTiny : dir.x, abs(dir.y) < kTiny ? kTiny : dir.y,
                abs(dir.z) < kTiny ? kTiny : dir.z);
}

/// Distances (in units of `dir`) at which the ray enters (x) and leaves (y) the box; x > y when it
/// misses.
vec2 rayBox(vec3 origin, vec3 dir, vec3 lower, vec3 upper) {
    vec3 inverse = 1.0f / divisible(dir);
    vec3 a = (lower - origin) * inverse;
    vec3 b = (upper - origin) * inverse;
    vec3 near = min(a, b);
    vec3 far = max(a, b);
    return vec2(max(max(near.x, near.y), near.z), min(min(far.x, far.y), far.z));
}
