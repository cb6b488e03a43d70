// sky_table.glsl: where things lie in the tables of sky and air, and the round Earth.
//
// Shares are in [0, 1], from the middle of a table's first texel to that of its last. Angles are
// finer near the sun and the horizon, distances and altitudes near 0.
#pragma once
#include "constants.glsl"

const float kPlanetRadiusM = 6371e3f;
const float kThinAirM = 60e3f;        ///< altitude above which air shows no haze
const float kAirRangeM = 400e3f;      ///< last distance of the table of air
const float kHighestM = 40e3f;        ///< last altitude of the table by altitude
const float kHighestAroundM = 20e3f;  ///< last altitude of the table of the sky around

// Texels: azimuths from the sun, elevations, then distances or altitudes.
const int kEyeSkyAzimuths = 64, kEyeSkyElevations = 80;
const int kAirAzimuths = 24, kAirElevations = 48, kAirDistances = 24;
const int kAroundAzimuths = 24, kAroundElevations = 24, kAroundAltitudes = 6;
const int kAltitudes = 64;
/// Of the table by altitude: the sun, and the two patterns of the sky.
const int kSunRow = 0, kFirstPatternRow = 1, kAltitudeRows = 3;

/// Texture coordinate of a share of a table of `count` texels.
float tableCoordinate(float share, int count) {
    return (clamp(share, 0.0f, 1.0f) * float(count - 1) + 0.5f) / float(count);
}

/// Sine of the elevation of the horizon.
float horizonSine(float altitudeM) {
    float h = max(altitudeM, 0.0f);
    return -sqrt(h * (2.0f * kPlanetRadiusM + h)) / (kPlanetRadiusM + h);
}

/// Of the angle between the azimuths of two directions, of unit length or less; 0 where one of
/// them is vertical.
float azimuthShare(vec3 a, vec3 b) {
    float across = sqrt((a.x * a.x + a.y * a.y) * (b.x * b.x + b.y * b.y));
    float cosine = across > 1e-6f ? (a.x * b.x + a.y * b.y) / across : 1.0f;
    return sqrt(acos(clamp(cosine, -1.0f, 1.0f)) / kPi);
}

float azimuthOfShare(float share) {
    return kPi * share * share;
}

/// Of directions above the horizon, whose elevation has the sine `up`.
float skyShare(float up, float horizon) {
    float lowest = asin(horizon);
    float above = asin(clamp(up, -1.0f, 1.0f)) - lowest;
    return sqrt(clamp(above / (0.5f * kPi - lowest), 0.0f, 1.0f));
}

float skyUpOfShare(float share, float horizon) {
    float lowest = asin(horizon);
    return sin(lowest + share * share * (0.5f * kPi - lowest));
}

/// Of all directions.
float airShare(float up, float horizon) {
    float lowest = asin(horizon);
    float above = asin(clamp(up, -1.0f, 1.0f)) - lowest;
    return above >= 0.0f ? 0.5f + 0.5f * sqrt(above / (0.5f * kPi - lowest))
                         : 0.5f - 0.5f * sqrt(-above / (0.5f * kPi + lowest));
}

float airUpOfShare(float share, float horizon) {
    float lowest = asin(horizon);
    float x = 2.0f * share - 1.0f;
    return x >= 0.0f ? sin(lowest + x * x * (0.5f * kPi - lowest))
                     : sin(lowest - x * x * (0.5f * kPi + lowest));
}

/// Of a distance or an altitude, of which a table has those up to `last`.
float lengthShare(float lengthM, float lastM) {
    return sqrt(clamp(lengthM / lastM, 0.0f, 1.0f));
}

float lengthOfShare(float share, float lastM) {
    return share * share * lastM;
}

/// Texture coordinate at which a table over such lengths is interpolated evenly in length, so that
/// thin air is right from 0 on.
float lengthCoordinate(float share, int count) {
    float place = share * float(count - 1);
    float texel = min(floor(place), float(count - 2));
    float beyond = (place * place - texel * texel) / (2.0f * texel + 1.0f);
    return (texel + beyond + 0.5f) / float(count);
}

/// Distance at which a ray from above the thin air enters it; 0 from within, or where it does not.
float thinAirM(float altitudeM, float up) {
    if (altitudeM <= kThinAirM) return 0.0f;
    float r = kPlanetRadiusM + altitudeM;
    // (r up)² - (r² - top²), without the difference of large numbers.
    float inside = r * r * up * up - (altitudeM - kThinAirM) * (r + kPlanetRadiusM + kThinAirM);
    if (up >= 0.0f || inside <= 0.0f) return 0.0f;
    return -r * up - sqrt(inside);
}

/// How much faster than along a plane a ray gains height, per square of the distance covered
/// across, 1/m: parabolas instead of circles, exact at the eye and where rays graze the ground.
float bendPerM(float altitudeM) {
    return (1.0f + max(altitudeM, 0.0f) / (2.0f * kPlanetRadiusM)) / (2.0f * kPlanetRadiusM);
}

/// Distance at which such a ray from `altitudeM` meets the ground; -1 where it does not. `bend` is
/// the above, or 0 for a flat ground.
float groundAlongM(float altitudeM, vec3 dir, float bend) {
    if (dir.z >= 0.0f || altitudeM <= 0.0f) return -1.0f;
    float a = bend * (dir.x * dir.x + dir.y * dir.y);
    float inside = dir.z * dir.z - 4.0f * a * altitudeM;
    if (inside < 0.0f) return -1.0f;
    return 2.0f * altitudeM / (sqrt(inside) - dir.z);
}
