// directions.glsl: sampling of directions around an axis.
//
// An angle is given by its versine, 1 - cosine, which keeps full precision for small angles.
#pragma once
#include "constants.glsl"

/// 1 - cosine of the angle between two unit vectors.
float versineBetween(vec3 a, vec3 b) {
    vec3 d = a - b;
    return 0.5f * dot(d, d);
}

/// The direction at an angle from the unit vector `axis`; `turn` in [0, 1) is the azimuth around
/// it, in full circles. The two vectors perpendicular to the axis are those of [Duff17].
vec3 directionAround(vec3 axis, float versine, float turn) {
    float sign_ = axis.z < 0.0f ? -1.0f : 1.0f;
    float a = -1.0f / (sign_ + axis.z);
    float b = axis.x * axis.y * a;
    vec3 u = vec3(1.0f + sign_ * axis.x * axis.x * a, sign_ * b, -sign_ * axis.x);
    vec3 v = vec3(b, sign_ + axis.y * axis.y * a, -axis.y);
    float sine = sqrt(max(0.0f, versine * (2.0f - versine)));
    float phi = 2.0f * kPi * turn;
    return normalize((1.0f - versine) * axis + sine * (cos(phi) * u + sin(phi) * v));
}

/// Versine of a direction in a hemisphere, sampled with a density proportional to the cosine; `u`
/// is uniform in [0, 1).
float versineByCosine(float u) {
    float root = sqrt(1.0f - u);
    return u / (1.0f + root);  // 1 - root, without cancellation
}
