// frame.glsl: what every pass of slicing knows of the frame: the pixel's ray, the ground, the place
// in the light buffer.
#pragma once
#include "../lib/sky_table.glsl"
#include "frame_block.glsl"

layout(std140, binding = kFrameBinding) uniform FrameUniforms {
    FrameBlock u_;
};

struct Ray {
    vec3 originM;
    vec3 dir;
};

/// `place`: in pixels of the whole image.
Ray rayThroughPlace(vec2 place) {
    vec2 ndc = 2.0 * place / vec2(u_.whole.xy) - 1.0;
    return Ray(u_.eyeM.xyz, normalize(u_.forward.xyz + ndc.x * u_.right.xyz + ndc.y * u_.up.xyz));
}

Ray rayThrough(ivec2 pixel) {
    return rayThroughPlace(vec2(pixel + u_.whole.zw) + 0.5);
}

/// Gain in height of a ray from the eye over a plane, per square of the distance, 1/m: the Earth is
/// round, and the grid is level.
float bendOf(vec3 dir) {
    return u_.sky.z * dot(dir.xy, dir.xy);
}

/// The point of grid space that a ray from the eye passes at a distance.
vec3 pointAlong(Ray ray, float atM) {
    vec3 positionM = ray.originM + atM * ray.dir;
    positionM.z += bendOf(ray.dir) * atM * atM;
    return positionM;
}

/// Where in the grid the medium at a point is: there, or between periodic sides in the one of the
/// repeats that is the grid.
vec3 repeated(vec3 positionM) {
#if PERIODIC
    vec2 widthM = u_.gridExtentM.xy;
    positionM.xy = clamp(positionM.xy - widthM * floor(positionM.xy / widthM), vec2(0.0), widthM);
#endif
    return positionM;
}

/// Distance at which a ray from the eye meets the ground, if there is one; else -1. An eye below it
/// sees it with an atmosphere as if it stood on it, so that there is a horizon; else not at all.
float groundDistanceM(Ray ray) {
    const float kStandingM = 2.0;
    if (u_.ground.w < 0.5) return -1.0;
    float heightM = u_.eyeM.w + ray.originM.z;
    if (u_.sky.x > 0.5) heightM = max(heightM, kStandingM);
    return groundAlongM(heightM, ray.dir, u_.sky.z);
}

/// Where a ray from the eye meets the ground, at that distance.
vec3 groundPoint(Ray ray, float distanceM) {
    vec3 positionM = pointAlong(ray, distanceM);
    positionM.z = -u_.eyeM.w;
    return positionM;
}

/// Place of a point of grid space in the light buffer, in [0, 1] where the buffer covers it.
vec2 lightCoordinate(vec3 positionM) {
    vec2 across = vec2(dot(u_.lightU.xyz, positionM), dot(u_.lightV.xyz, positionM));
    return (across - vec2(u_.lightU.w, u_.lightV.w)) * u_.lightScale.xy;
}
