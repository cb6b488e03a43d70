// sun_disc.glsl: the sun as it is seen, and what of its light strays in a lens.
#pragma once
#include "constants.glsl"

const float kSunRadius = 0.0046524f;  ///< angular, at 1 astronomical unit, rad
const float kSunSolidAngle = kPi * kSunRadius * kSunRadius;

/// Radiance at an angle from the middle of the sun as a share of its irradiance, 1/sr: darker
/// towards the limb, by a law of -0.023 + 292 nm / wavelength [Hestroffer98] at 610, 550 and 460
/// nm. A disc smaller than a pixel, of that many radians, is drawn as large as one, and dimmer.
vec3 sunDiscShare(float angle, float pixel) {
    const vec3 kLimb = vec3(0.456f, 0.508f, 0.612f);
    float radius = max(kSunRadius, 0.6f * pixel);
    float inside = clamp((radius - angle) / pixel + 0.5f, 0.0f, 1.0f);
    float x = min(angle / radius, 1.0f);
    vec3 dimmed = pow(vec3(sqrt(max(1.0f - x * x, 1e-4f))), kLimb);
    return inside * (0.5f * kLimb + 1.0f) * dimmed / (kPi * radius * radius);
}

/// The same of the moon, of which half is lit from `towardsSun`, about evenly, whose whole light is
/// 1. `offset`: from its middle, as a share of its radius, across the direction `towards` it.
float moonDiscShare(vec3 offset, vec3 towards, vec3 towardsSun, float pixel) {
    float radius = max(kSunRadius, 0.6f * pixel);
    float r = length(offset);
    float inside = clamp((1.0f - r) * radius / pixel + 0.5f, 0.0f, 1.0f);
    vec3 normal = offset - sqrt(max(1.0f - r * r, 0.0f)) * towards;
    float lit = clamp(dot(normal, towardsSun) * radius / pixel + 0.5f, 0.0f, 1.0f);
    float share = max(0.5f * (1.0f - dot(towards, towardsSun)), 0.01f);  // of the disc
    return inside * (kSunRadius > 0.6f * pixel ? lit / share : 1.0f) / (kPi * radius * radius);
}

/// Radiance of stray light at an angle from the sun, for an irradiance of 1 of which all strays,
/// 1/sr. It falls with the square of the angle, about as that of lenses does [Talvala07].
float glareAt(float angle) {
    const float kCore = 0.0052f;  // what lenses blur; tuned by eye
    const float kWhole = 34.7f;   // of the rest, over the half space ahead
    return 1.0f / (kWhole * (angle * angle + kCore * kCore));
}
