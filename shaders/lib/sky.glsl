// sky.glsl: the background, L_bg of [Riley03] eq. 5: a vertical gradient, and a ground plane that
// fades into the haze.
#pragma once

const float kHazeLengthM =
    90e3f;  ///< distance over which the ground fades into the horizon; tuned by eye

/// Beyond, less than 1 % of what lies in the haze is seen: rays that never leave a domain which
/// repeats end there.
const float kSeenM = 5.0f * kHazeLengthM;

/// Radiance of the sky in a direction whose vertical component is `up`. Below the horizon it is
/// that of the horizon.
vec3 skyRadiance(float up, vec3 zenith, vec3 horizon) {
    float height = clamp(up, 0.0f, 1.0f);
    return mix(horizon, zenith, pow(height, 0.55f));  // exponent tuned by eye
}

/// Radiance of the ground, or of clouds that repeat, seen from a distance: it fades into the
/// horizon.
vec3 hazyGround(vec3 ground, vec3 horizon, float distanceM) {
    return mix(horizon, ground, exp(-distanceM / kHazeLengthM));
}
