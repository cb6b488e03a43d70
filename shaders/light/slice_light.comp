// slice_light.comp: one slice of the light buffer: light attenuated and forward-scattered by Eq.
// 14-17.
//
// Layer k of the array holds the irradiance that meets slice first + k; this pass reads layer k and
// writes layer k + 1. Either engine's medium is read, by the same names.
#version 450 core
#include "../shared/light_layout.glsl"
layout(local_size_x = kLightTile, local_size_y = kLightTile) in;
#include "../lib/optics.glsl"
// A file is included once, on whichever side of an #if: what both sides need comes before it.
#include "../lib/noise.glsl"
#include "../medium/bricks.glsl"
#include "../shared/groups_layout.glsl"
#if PACKED
#include "../march/packed_sample.glsl"
#else
#include "../medium/sample.glsl"
#endif
#include "../medium/total_extinction.glsl"

layout(binding = kLightUnit) uniform sampler2DArray t_light;
layout(LIGHT_FORMAT, binding = kLightImage) writeonly uniform image2DArray o_light;
layout(location = kLightLayerLocation) uniform int layer;
layout(location = kFirstGroupLocation) uniform int firstGroup;
layout(std430, binding = kLightTilesBuffer) readonly buffer Tiles {
    ivec2 tiles[];  // of the light buffer, that pass through anything
};

/// Where the light ray of a texel meets the slice.
vec3 positionOnSlice(vec2 across, float planeM) {
#if PERIODIC
    vec3 base = vec3(across, 0.0);
#else
    vec3 base = u_.lightU.xyz * across.x + u_.lightV.xyz * across.y;
#endif
    float along = (planeM - dot(u_.normal.xyz, base)) / dot(u_.normal.xyz, u_.towardsSun.xyz);
    return repeated(base + along * u_.towardsSun.xyz);
}

#if TRANSLUCENT
float ringMean(vec2 at) {
#if PERIODIC
    // The ring lies across the light, which carries it to the level slice: longer along the light.
    vec2 along = normalize(u_.towardsSun.xy + vec2(1e-6, 0.0));
    vec2 first = u_.lightScale.w / abs(u_.towardsSun.z) * along * u_.lightScale.xy;
    vec2 second = u_.lightScale.w * vec2(-along.y, along.x) * u_.lightScale.xy;
#else
    vec2 first = vec2(u_.lightScale.w * u_.lightScale.x, 0.0);
    vec2 second = vec2(0.0, u_.lightScale.w * u_.lightScale.y);
#endif
    return 0.25 * (textureLod(t_light, vec3(at + first, layer), 0.0).r +
                   textureLod(t_light, vec3(at - first, layer), 0.0).r +
                   textureLod(t_light, vec3(at + second, layer), 0.0).r +
                   textureLod(t_light, vec3(at - second, layer), 0.0).r);
}
#endif

#if TRANSLUCENT && CONSISTENT
float meanAlbedo(MediumSample s, float extinctionPerM) {
    float scattering = 0.0;
    for (int i = 0; i < CLASSES; ++i) {
        scattering += u_.classes[i].colourAlbedo.w * s.extinctionPerM[i];
    }
    return extinctionPerM > 0.0 ? scattering / extinctionPerM : 1.0;
}
#endif

float lightBeyond(vec2 at, float centre, vec3 positionM) {
    MediumSample s = sampleMedium(positionM);
#if FULL
    float thickness = thicknessAt(positionM);
    for (int i = 0; i < CLASSES; ++i) s.extinctionPerM[i] *= scaledShare(i, thickness);
#endif
    float extinctionPerM = totalExtinctionPerM(s);
    float opticalDepth = extinctionPerM * u_.towardsSun.w;
#if !TRANSLUCENT
    return centre * transmittance(opticalDepth);
#elif CONSISTENT
    return lightStepConsistent(centre, ringMean(at), opticalDepth, meanAlbedo(s, extinctionPerM),
                               u_.forwardShare.x, u_.forwardShare.y);
#else
    return lightStepPrinted(centre, ringMean(at), opticalDepth, u_.forwardShare.x,
                            u_.forwardShare.y);
#endif
}

void main() {
    ivec2 texel =
        kLightTile * tiles[firstGroup + int(gl_WorkGroupID.x)] + ivec2(gl_LocalInvocationID.xy);
    if (any(greaterThanEqual(texel, u_.image.zw))) return;
    vec2 at = (vec2(texel) + 0.5) / vec2(u_.image.zw);
    vec2 across = at / u_.lightScale.xy + vec2(u_.lightU.w, u_.lightV.w);
    float planeM = u_.normal.w + (float(u_.slices.y + layer) + 0.5) * u_.lightScale.z;
    vec3 positionM = positionOnSlice(across, planeM);

    float light = texelFetch(t_light, ivec3(texel, layer), 0).r;
    bool inside = all(greaterThanEqual(positionM, u_.boxLowerM.xyz)) &&
                  all(lessThanEqual(positionM, u_.boxUpperM.xyz));
    if (inside && emptiness(positionM) == 0) light = lightBeyond(at, light, positionM);
    imageStore(o_light, ivec3(texel, layer + 1), vec4(light, 0.0, 0.0, 0.0));
}
