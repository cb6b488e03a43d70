// box_air.glsl: molecules and haze within the grid's box, as paths meet them there.
//
// Both thin out exponentially with height, so that their depth along a straight way, and where on
// it light meets the next of them, have closed forms. A path is drawn at its hero's wavelength; its
// `wavelengths` take up how likely the others were to come as far.
#pragma once
#include "../lib/directions.glsl"
#include "scattering.glsl"
#include "state.glsl"

// Extinction at sea level, 1/m.
layout(location = kTraceMoleculesLocation) uniform vec3 moleculesPerM;
layout(location = kTraceHazeLocation) uniform vec3 hazePerM;
layout(location = kTraceMoleculesHeightLocation) uniform float moleculesHeightM;  // scale height
layout(location = kTraceHazeHeightLocation) uniform float hazeHeightM;
layout(location = kTraceHazeAlbedoLocation) uniform float hazeAlbedo;

const int kMoleculesRow = CLASSES, kHazeRow = CLASSES + 1;  // of the tables of phase functions

float densityAt(float atM, float heightM) {
    return exp(-atM / heightM);
}

/// Air at a point, 1/m.
struct BoxAir {
    vec3 molecules;   ///< scattering and extinction
    vec3 haze;        ///< scattering
    vec3 extinction;  ///< of both
};

BoxAir boxAirAt(float atM) {
    vec3 haze = densityAt(atM, hazeHeightM) * hazePerM;
    vec3 molecules = densityAt(atM, moleculesHeightM) * moleculesPerM;
    return BoxAir(molecules, hazeAlbedo * haze, molecules + haze);
}

/// Chances of haze to be what light of each wavelength is scattered by.
vec3 chancesOfHaze(BoxAir air) {
    return air.haze / max(air.molecules + air.haze, vec3(1e-30));
}

/// Metres of air as dense as at sea level on a straight way to an altitude, which has come so far
/// with a slope `up`.
float columnM(float atM, float up, float lengthM, float heightM) {
    float x = up * lengthM / heightM;
    float grown = abs(x) < 1e-3 ? 1.0 + 0.5 * x : (exp(x) - 1.0) / x;
    return densityAt(atM, heightM) * lengthM * grown;
}

/// What is left of light at the end of such a way.
vec3 clearOfBox(float atM, float up, float lengthM) {
    return exp(-columnM(atM, up, lengthM, moleculesHeightM) * moleculesPerM -
               columnM(atM, up, lengthM, hazeHeightM) * hazePerM);
}

const float kNoAirM = 1e30;

/// Distance at which a way from an altitude has an optical depth of one constituent.
float distanceToDepthM(float depth, float perM, float atM, float up, float heightM) {
    float herePerM = perM * densityAt(atM, heightM);
    if (herePerM * kNoAirM <= depth) return kNoAirM;
    float levelM = depth / herePerM;
    float x = up * levelM / heightM;
    if (x >= 1.0) return kNoAirM;  // the way ends in space before
    return levelM * (abs(x) < 1e-3 ? 1.0 + 0.5 * x : -log(1.0 - x) / x);
}

/// Where air scatters or absorbs light next; `u` are uniform.
float drawAirM(float atM, float up, int hero, vec2 u) {
    vec2 depth = -log(1.0 - u);
    return min(distanceToDepthM(depth.x, moleculesPerM[hero], atM, up, moleculesHeightM),
               distanceToDepthM(depth.y, hazePerM[hero], atM, up, hazeHeightM));
}

/// What air sends into a direction; as sentInto() of a mixture.
Sent sentByAir(BoxAir air, float versine, vec3 wavelengths) {
    vec3 molecules = phaseOf(kMoleculesRow, versine), haze = phaseOf(kHazeRow, versine);
    vec3 density = mix(molecules, haze, chancesOfHaze(air));
    return Sent((air.molecules * molecules + air.haze * haze) / max(air.extinction, vec3(1e-30)),
                dot(wavelengths, density));
}

/// Weighs the wavelengths of a path by how likely each was to come to its end, through air.
void weighByAir(inout Path p, float atM) {
    vec3 chance = clearOfBox(atM, p.dir.z, p.flownM);
    if (p.stage == kMet && p.kind == kAir) chance *= boxAirAt(atM).extinction;
    p.wavelengths *= chance;
    p.wavelengths /= max(p.wavelengths.r + p.wavelengths.g + p.wavelengths.b, 1e-30);
}

/// The path has left the box and goes down to the ground, which is not the sky of the tables: air
/// beside the box is as that within. True where it meets that before the ground; else it is there.
bool meetsAirBelow(inout Path p, float atM, vec2 u) {
    float groundM = max(atM, 0.0) / -p.dir.z;
    float airM = drawAirM(atM, p.dir.z, p.hero, u);
    p.flownM = min(airM, groundM);
    p.positionM += p.flownM * p.dir;
    if (airM < groundM) {
        p.axis = p.dir;
        p.kind = kAir;
        p.stage = kMet;
    }
    weighByAir(p, atM + p.flownM * p.dir.z);
    return airM < groundM;
}
