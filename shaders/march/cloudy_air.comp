// cloudy_air.comp: what clouds change of the light that air sends between the eye and a distance.
// One invocation a ray; rays go through every so many pixels of the whole image, so that its parts
// agree.
//
// Clouds keep the sun from the air, and send it their own light; air scatters both once.
// docs/sky.md
#version 450 core
#include "../shared/march_layout.glsl"
layout(local_size_x = kCloudyAirGroup, local_size_y = kCloudyAirGroup) in;
#include "../lib/harmonics.glsl"
#include "../lib/random.glsl"
#include "../shared/light_layout.glsl"
#include "../sky/air.glsl"
#include "cloudy_air.glsl"
#include "sent.glsl"

layout(binding = kSunThroughUnit) uniform sampler3D t_through;
layout(binding = kSunnyAirUnit) uniform sampler3D t_sunnyAir;
layout(binding = kByMoleculesUnit) uniform sampler2D t_byMolecules;
layout(binding = kByHazeUnit) uniform sampler2D t_byHaze;
#if FULL
// Of light_around.comp.
layout(binding = kAroundMoleculesUnit) uniform sampler3D t_aroundMolecules;
layout(binding = kAroundHazeUnit) uniform sampler3D t_aroundHaze;
layout(location = kAroundLowerLocation) uniform vec3 lowerM;  // of node 0
layout(location = kAroundSpacingLocation) uniform vec3 spacingM;
#endif
layout(rgba16f, binding = kCloudyAirImage) writeonly uniform image3D o_change;

/// Share of sunlight that clouds leave at a point.
float sunThrough(vec3 positionM) {
    vec2 at = lightCoordinate(positionM);
#if !PERIODIC
    if (any(lessThan(at, vec2(0.0))) || any(greaterThan(at, vec2(1.0)))) return 1.0;
#endif
    float slice = (dot(u_.normal.xyz, positionM) - u_.normal.w) / u_.lightScale.z;
    float layers = float(textureSize(t_through, 0).z);
    float layer = clamp(slice, 0.0, float(u_.slices.x)) / float(kSlicesPerSunThrough);
    return textureLod(t_through, vec3(at, (layer + 0.5) / layers), 0.0).r;
}

/// What air up to a distance sends: of sunlight scattered once, and by each constituent where light
/// of radiance 1 comes from everywhere.
struct SentByAir {
    vec3 once, byMolecules, byHaze;
};

SentByAir sentBefore(AirRay air, float distanceM) {
    float at = lengthCoordinate(lengthShare(distanceM - air.fromM, kAirRangeM), kAirDistances);
    return SentByAir(u_.sky.w * textureLod(t_sunnyAir, vec3(air.at, at), 0.0).rgb,
                     textureLod(t_byMolecules, vec2(air.at.y, at), 0.0).rgb,
                     textureLod(t_byHaze, vec2(air.at.y, at), 0.0).rgb);
}

#if FULL && PERIODIC
DirectionHarmonics alongRay_;

/// What clouds change of the light that a stretch of air scatters along the ray, at a point of it.
vec3 changedBy(SentByAir before, SentByAir until, vec3 positionM) {
    vec3 size = vec3(textureSize(t_aroundMolecules, 0));
    float layer = size.z / float(kAroundLayers);
    vec3 at = (positionM - lowerM) / spacingM + 0.5;
    at = vec3(at.xy / size.xy, clamp(at.z, 0.5, layer - 0.5) / size.z);
    float of[4 * kAroundLayers];
    for (int j = 0; j < kAroundLayers; ++j) {
        vec3 place = vec3(at.xy, at.z + float(j) / float(kAroundLayers));
        vec4 four = textureLod(t_aroundMolecules, place, 0.0);
        for (int k = 0; k < 4; ++k) of[4 * j + k] = four[k];
    }
    vec3 byMolecules = max(until.byMolecules - before.byMolecules, 0.0);
    vec3 byHaze = max(until.byHaze - before.byHaze, 0.0);
    vec3 change = vec3(0.0);
    for (int part = 0; part < kAroundParts; ++part) {
        vec3 ofDegree = vec3(0.0);
        for (int q = 0; q < kSkyMoments; ++q) {
            ofDegree[degreeOfMoment(q)] += of[kSkyMoments * part + q] * alongRay_.value[q];
        }
        change += (dot(kOfMolecules, ofDegree) * byMolecules + dot(kOfHaze, ofDegree) * byHaze) *
                  colourAround(part, altitudeM(positionM));
    }
    return change;
}
#elif FULL
/// What clouds change of the light that a stretch of air scatters, at a point of it. Beyond what is
/// known of it, it is as much less as they look smaller from there.
vec3 changedBy(SentByAir before, SentByAir until, vec3 positionM) {
    vec3 size = vec3(textureSize(t_aroundMolecules, 0));
    vec3 upperM = lowerM + (size - 1.0) * spacingM;
    vec3 inside = clamp(positionM, lowerM, upperM);
    vec3 at = ((inside - lowerM) / spacingM + 0.5) / size;
    vec3 change = max(until.byMolecules - before.byMolecules, 0.0) *
                      textureLod(t_aroundMolecules, at, 0.0).rgb +
                  max(until.byHaze - before.byHaze, 0.0) * textureLod(t_aroundHaze, at, 0.0).rgb;
    float reachM = 0.25 * (upperM.x - lowerM.x + upperM.y - lowerM.y);
    float away = 1.0 + distance(inside, positionM) / reachM;
    return change / (away * away);
}
#endif

void main() {
    ivec2 node = ivec2(gl_GlobalInvocationID);
    ivec3 size = imageSize(o_change);
    if (any(greaterThanEqual(node, size.xy))) return;
    ivec2 pixel = int(u_.cloudyAir.z) * (node + firstCloudyAirNode());
    Ray ray = rayThroughPlace(vec2(pixel));
    // Rays right below the horizon go above it, so that pixels above have no part in the ground.
    float above = pixelsAboveHorizon(ray.dir);
    if (above < 0.5 && above > -u_.cloudyAir.z) ray.dir = besideHorizon(ray.dir, 1.0);
    AirRay air = airRay(ray.dir);
    // Another place in each step for each ray and image.
    float place =
        fract(unitsOf(randomWords(uvec4(pixel, 0u, 0u))).x + 0.61803399 * float(u_.sampling.x));
#if FULL && PERIODIC
    alongRay_ = directionHarmonics(-ray.dir, -u_.towardsSun.xyz);
#endif
    vec3 change = vec3(0.0);
    float fromM = cloudyAirDistanceM(0, size.z);
    SentByAir before = sentBefore(air, fromM);
    imageStore(o_change, ivec3(node, 0), vec4(0.0));
    for (int k = 1; k < size.z; ++k) {
        float untilM = cloudyAirDistanceM(k, size.z);
        SentByAir until = sentBefore(air, untilM);
        vec3 positionM = pointAlong(ray, mix(fromM, untilM, place));
        change -= (1.0 - sunThrough(positionM)) * max(until.once - before.once, 0.0);
#if FULL
        change += changedBy(before, until, positionM);
#endif
        imageStore(o_change, ivec3(node, k), vec4(change, 0.0));
        before = until;
        fromM = untilM;
    }
}
