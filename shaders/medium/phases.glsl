// phases.glsl: the phase functions of the classes as the image shows them, looked up.
#pragma once
#include "../lib/phase_table.glsl"
#include "../shared/frame.glsl"
#include "../shared/medium_layout.glsl"

layout(binding = kPhasesUnit) uniform sampler2D t_phases;  // one row per class

vec3 displayPhase(int index, float cosTheta) {
    float at = phaseTableIndex(cosTheta, kPhaseTableSize);
    int entry = min(int(at), kPhaseTableSize - 2);
    return mix(texelFetch(t_phases, ivec2(entry, index), 0).rgb,
               texelFetch(t_phases, ivec2(entry + 1, index), 0).rgb, at - float(entry));
}

/// Radiance that a class scatters along the ray for a unit of light, per unit of optical depth.
vec3 sunlitBy(int index, vec3 dir) {
    float cosTheta = dot(u_.towardsSun.xyz, dir);
    return u_.classes[index].colourAlbedo.rgb * u_.sunRadiance.rgb * displayPhase(index, cosTheta);
}
