// frame.glsl: what every pass of slicing knows of the frame: the pixel's ray, the ground, the place
// in the light buffer.
#pragma once
#include "frame_block.glsl"

layout(std140, binding = kFrameBinding) uniform FrameUniforms {
    FrameBlock u_;
};

struct Ray {
    vec3 originM;
    vec3 dir;
};

Ray rayThrough(ivec2 pixel) {
    vec2 ndc = 2.0 * (vec2(pixel + u_.whole.zw) + 0.5) / vec2(u_.whole.xy) - 1.0;
    return Ray(u_.eyeM.xyz, normalize(u_.forward.xyz + ndc.x * u_.right.xyz + ndc.y * u_.up.xyz));
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

/// Distance at which the ray meets the ground, if there is one and the eye is above it; else -1.
float groundDistanceM(Ray ray) {
    float eyeHeightM = u_.eyeM.w + ray.originM.z;
    bool meets = u_.ground.w > 0.5 && ray.dir.z < 0.0 && eyeHeightM > 0.0;
    return meets ? -eyeHeightM / ray.dir.z : -1.0;
}

/// Place of a point of grid space in the light buffer, in [0, 1] where the buffer covers it.
vec2 lightCoordinate(vec3 positionM) {
    vec2 across = vec2(dot(u_.lightU.xyz, positionM), dot(u_.lightV.xyz, positionM));
    return (across - vec2(u_.lightU.w, u_.lightV.w)) * u_.lightScale.xy;
}
