// air.glsl: sky, sunlight and air as the tables have them. core/sky/sky_tables.h
#pragma once
#include "../lib/ground.glsl"
#include "../lib/sky.glsl"
#include "../lib/sky_table.glsl"
#include "../lib/sun_disc.glsl"
#include "../shared/frame.glsl"
#include "../shared/sky_layout.glsl"

layout(binding = kEyeSkyUnit) uniform sampler2D t_eyeSky;
layout(binding = kAirUnit) uniform sampler3D t_air;
layout(binding = kClearAirUnit) uniform sampler2D t_clearAir;
layout(binding = kAroundUnit) uniform sampler3D t_around;
layout(binding = kByAltitudeUnit) uniform sampler2D t_byAltitude;

bool hasAir() {
    return u_.sky.x > 0.5;
}

/// Altitude of a point of grid space.
float altitudeM(vec3 positionM) {
    return u_.eyeM.w + positionM.z;
}

vec3 byAltitude(float atM, int row) {
    return textureLod(t_byAltitude,
                      vec2(tableCoordinate(lengthShare(atM, kHighestM), kAltitudes),
                           (float(row) + 0.5) / float(kAltitudeRows)),
                      0.0)
        .rgb;
}

/// Colour of sunlight at an altitude, as a share of u_.sunRadiance.
vec3 sunAt(float atM) {
    return hasAir() ? byAltitude(atM, kSunRow) : vec3(1.0);
}

/// Radiance of the two parts of the sky that light the cloud, where theirs is 1.
vec3 skyPartAt(float atM, int part) {
    vec3 radiance = part == 0 ? u_.skyHorizon.rgb : u_.skyZenith.rgb;
    return hasAir() ? radiance * byAltitude(atM, kFirstPatternRow + part) : radiance;
}

/// Where the air along a ray from the eye lies in its tables.
struct AirRay {
    vec2 at;      // azimuth and elevation
    float fromM;  // where it begins
};

AirRay airRay(vec3 dir) {
    float azimuth = tableCoordinate(azimuthShare(dir, u_.towardsSun.xyz), kAirAzimuths);
    float elevation = tableCoordinate(airShare(dir.z, u_.sky.y), kAirElevations);
    return AirRay(vec2(azimuth, elevation), thinAirM(altitudeM(u_.eyeM.xyz), dir.z));
}

/// What is left of the radiance at a distance from the eye, and what the air before it adds, of
/// which the share `covered` counts.
vec3 throughAir(AirRay ray, float distanceM, vec3 radiance, float covered) {
    float at = lengthCoordinate(lengthShare(distanceM - ray.fromM, kAirRangeM), kAirDistances);
    return textureLod(t_clearAir, vec2(ray.at.y, at), 0.0).rgb * radiance +
           covered * u_.sky.w * textureLod(t_air, vec3(ray.at, at), 0.0).rgb;
}

/// Angle of a pixel, about.
float pixelAngle() {
    return 2.0 * length(u_.up.xyz) / float(u_.whole.y);
}

/// How many pixels a ray from the eye passes above the horizon.
float pixelsAboveHorizon(vec3 dir) {
    return (dir.z - u_.sky.y) / (sqrt(max(1.0 - u_.sky.y * u_.sky.y, 1e-6)) * pixelAngle());
}

/// How much of a pixel lies above the horizon, where there is ground.
float skyShareOf(vec3 dir) {
    return hasAir() && u_.ground.w > 0.5 ? clamp(pixelsAboveHorizon(dir) + 0.5, 0.0, 1.0) : 1.0;
}

/// The same direction with half a pixel of sky or of ground between it and the horizon.
vec3 besideHorizon(vec3 dir, float side) {
    float elevation = asin(u_.sky.y) + 0.5 * side * pixelAngle();
    return vec3(cos(elevation) * normalize(dir.xy), sin(elevation));
}

/// The sky as the eye sees it.
vec3 eyeSky(vec3 dir) {
    if (!hasAir()) return skyRadiance(dir.z, u_.skyZenith.rgb, u_.skyHorizon.rgb);
    vec2 at = vec2(tableCoordinate(azimuthShare(dir, u_.towardsSun.xyz), kEyeSkyAzimuths),
                   tableCoordinate(skyShare(dir.z, u_.sky.y), kEyeSkyElevations));
    return u_.sky.w * textureLod(t_eyeSky, at, 0.0).rgb;
}

/// The disc of the sun, or of the moon, as the eye sees it through the air.
vec3 sunDisc(vec3 dir) {
    if (u_.discLight.g <= 0.0) return vec3(0.0);
    float pixel = pixelAngle();
    float angle = length(cross(dir, u_.disc.xyz));
    if (dot(dir, u_.disc.xyz) < 0.0 || angle > kSunRadius + pixel) return vec3(0.0);
    if (u_.moon.w < 0.5) return u_.discLight.rgb * sunDiscShare(angle, pixel);
    vec3 across = dir - dot(dir, u_.disc.xyz) * u_.disc.xyz;
    vec3 offset = across / max(kSunRadius, 0.6 * pixel);
    return u_.discLight.rgb * moonDiscShare(offset, u_.disc.xyz, u_.moon.xyz, pixel);
}

/// What the ground's colour is multiplied by where a ray from the eye meets it.
vec3 groundSeen(Ray ray, float distanceM) {
    if (!hasAir()) return vec3(1.0);
    // A pixel is longer the flatter the ray; what it covers is taken to be as wide as long.
    float pixelM = distanceM * pixelAngle();
    int kind = int(u_.skyZenith.w);
    vec3 pattern = groundPattern(kind, groundPoint(ray, distanceM).xy + u_.moved.xy + u_.shifted.xy,
                                 pixelM / sqrt(max(abs(ray.dir.z), 1e-3)));
    return kind == kSeaGround ? (1.0 - seaMirrors(-min(ray.dir.z, 0.0))) * pattern : pattern;
}

/// The sky as it is seen from a point of grid space.
vec3 skyFrom(vec3 positionM, vec3 dir) {
    if (!hasAir()) return skyRadiance(dir.z, u_.skyZenith.rgb, u_.skyHorizon.rgb);
    float atM = max(altitudeM(positionM), 0.0);
    vec3 at = vec3(tableCoordinate(azimuthShare(dir, u_.towardsSun.xyz), kAroundAzimuths),
                   tableCoordinate(skyShare(dir.z, horizonSine(atM)), kAroundElevations),
                   tableCoordinate(lengthShare(atM, kHighestAroundM), kAroundAltitudes));
    return u_.sky.w * textureLod(t_around, at, 0.0).rgb;
}

/// What the sea mirrors of the sky towards the eye. There is no glint: the sun's disc, and the
/// brightness close around it, are not of the sky's table.
vec3 groundMirrors(Ray ray, vec3 positionM) {
    if (!hasAir() || int(u_.skyZenith.w) != kSeaGround) return vec3(0.0);
    return seaMirrors(-min(ray.dir.z, 0.0)) * skyFrom(positionM, seaMirrorsFrom(ray.dir));
}
