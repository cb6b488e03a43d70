// harmonics.glsl: the functions of direction in which radiance is kept: real orthonormal spherical
// harmonics to l = 2, then zonal ones of l = 3 and 4 about the direction in which sunlight travels.
// Their order is in core/transport/harmonics.h.
#pragma once
#include "constants.glsl"

struct DirectionHarmonics {
    float value[11];
};

/// `travel` and `sunTravel` are unit vectors in which light travels.
DirectionHarmonics directionHarmonics(vec3 travel, vec3 sunTravel) {
    float a = sqrt(1.0f / (4.0f * kPi));
    float b = sqrt(3.0f / (4.0f * kPi));
    float c = sqrt(15.0f / (4.0f * kPi));
    float d = sqrt(5.0f / (4.0f * kPi)) / 2.0f;
    DirectionHarmonics y;
    y.value[0] = a;
    y.value[1] = b * travel.y;
    y.value[2] = b * travel.z;
    y.value[3] = b * travel.x;
    y.value[4] = c * travel.x * travel.y;
    y.value[5] = c * travel.y * travel.z;
    y.value[6] = d * (3.0f * travel.z * travel.z - 1.0f);
    y.value[7] = c * travel.x * travel.z;
    y.value[8] = c * (travel.x * travel.x - travel.y * travel.y) / 2.0f;
    float t = dot(travel, sunTravel);
    float before = t;
    float legendre = 1.5f * t * t - 0.5f;
    for (int l = 3; l <= 4; ++l) {
        float n = float(l);
        float next = ((2.0f * n - 1.0f) * t * legendre - (n - 1.0f) * before) / n;
        before = legendre;
        legendre = next;
        y.value[l + 6] = sqrt((2.0f * n + 1.0f) / (4.0f * kPi)) * legendre;
    }
    return y;
}
