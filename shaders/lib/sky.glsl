// sky.glsl: the background, L_bg of [Riley03] eq. 5: a vertical gradient, and a ground plane that
// fades into the haze.
#pragma once

const float kHazeLengthM =
    90e3f;  ///< distance over which the ground fades into the horizon; tuned by eye

/// Beyond, nothing of clouds is seen where there is no air: rays that never leave a domain which
/// repeats end there, where hazyCloud() leaves 0.2 %.
const float kSeenM = 2.5f * kHazeLengthM;

/// Radiance of the sky in a direction whose vertical component is `up`. Below the horizon it is
/// that of the horizon.
vec3 skyRadiance(float up, vec3 zenith, vec3 horizon) {
    float height = clamp(up, 0.0f, 1.0f);
    return mix(horizon, zenith, pow(height, 0.55f));  // exponent tuned by eye
}

/// Radiance of the ground seen from a distance: it fades into the horizon.
vec3 hazyGround(vec3 ground, vec3 horizon, float distanceM) {
    return mix(horizon, ground, exp(-distanceM / kHazeLengthM));
}

/// Radiance of clouds of a domain that repeats, at a distance across: far ones fade likewise, so
/// that there is no last one; those within a domain are what they are. Tuned by eye.
vec3 hazyCloud(vec3 cloud, vec3 horizon, float acrossM) {
    float far = acrossM / kHazeLengthM;
    return mix(horizon, cloud, exp(-far * far));
}
