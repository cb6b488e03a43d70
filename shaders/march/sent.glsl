// sent.glsl: the colours of what voxels of light send towards the eye, and air towards it.
#pragma once
#include "../lib/constants.glsl"
#include "../sky/air.glsl"

/// Colour of sunlight that arrives with a luminance of 1.
vec3 colourOfSun(vec3 sun) {
    return hasAir() ? sun / max(dot(sun, kLuminance), 1e-12) : vec3(1.0);
}

/// Of a sun of irradiance 1; `sun`: sunAt() there. Light of a sun of this radiance:
/// shaders/medium/phases.glsl. Sunlight arrives with the luminance that it has at each altitude;
/// its colour is taken to be that of where it is scattered last.
vec3 sunSent(float sent, vec3 sun) {
    return 4.0 * kPi * sent * colourOfSun(sun) * u_.sunRadiance.rgb;
}

/// Of the two parts of the sky.
vec3 skySent(float first, float second, float atM) {
    return max(first * skyPartAt(atM, 0) + second * skyPartAt(atM, 1), 0.0);
}

/// Legendre moments of l = 0 ... 2: of molecules; and of haze (Cornette-Shanks, 0.637) less what
/// goes on as if not scattered, as core/sky/atmosphere.cpp has it.
const vec3 kOfMolecules = vec3(1.0, 0.0, 0.1), kOfHaze = vec3(1.0, 0.700, 0.504) - 0.35;

int degreeOfMoment(int q) {
    return q == 0 ? 0 : q < 4 ? 1 : 2;
}

/// What each of kAroundParts is multiplied by: sun, horizon, zenith.
vec3 colourAround(int part, float atM) {
    return part == 0 ? sunSent(1.0, sunAt(atM)) : skyPartAt(atM, part - 1);
}
