// phases.glsl: the phase functions of the classes as the image shows them, looked up.
#pragma once
#include "../lib/phase_table.glsl"
#include "../shared/frame.glsl"
#include "../shared/medium_layout.glsl"

layout(binding = kPhasesUnit) uniform sampler2D t_phases;  // one row per class, or more

vec3 displayPhase(int row, float cosTheta) {
    float at = phaseTableIndex(cosTheta, kPhaseTableSize);
    int entry = min(int(at), kPhaseTableSize - 2);
    return mix(texelFetch(t_phases, ivec2(entry, row), 0).rgb,
               texelFetch(t_phases, ivec2(entry + 1, row), 0).rgb, at - float(entry));
}

/// Radiance that a class scatters along the ray for a unit of light, per unit of optical depth, by
/// the phase function in a row of its own.
vec3 sunlitBy(int index, int row, vec3 dir) {
    float cosTheta = dot(u_.towardsSun.xyz, dir);
    return u_.classes[index].colourAlbedo.rgb * u_.sunRadiance.rgb * displayPhase(row, cosTheta);
}
