// ray_box.glsl: intersection of a ray with a box.
#pragma once

/// The direction, with components that are too small to divide by replaced by a small positive one.
vec3 divisible(vec3 dir) {
    const float kTiny = 1e-9f;
    return vec3(abs(dir.x) < kTiny ? kTiny : dir.x, abs(dir.y) < kTiny ? kTiny : dir.y,
                abs(dir.z) < kTiny ? kTiny : dir.z);
}

/// Distances, in units of the length of `dir`, at which the ray enters (x) and leaves (y) the box;
/// x > y if it misses.
vec2 rayBox(vec3 origin, vec3 dir, vec3 lower, vec3 upper) {
    vec3 inverse = 1.0f / divisible(dir);
    vec3 a = (lower - origin) * inverse;
    vec3 b = (upper - origin) * inverse;
    vec3 near = min(a, b);
    vec3 far = max(a, b);
    return vec2(max(max(near.x, near.y), near.z), min(min(far.x, far.y), far.z));
}
