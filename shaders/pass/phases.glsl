// phases.glsl: the phase functions of the classes as the picture shows them, looked up.
#pragma once
#include "../lib/phase_table.glsl"
#include "frame.glsl"

layout(std430, binding = 0) readonly buffer PhaseTables {
    vec4 phaseTables[];
};

vec3 displayPhase(int index, float cosTheta) {
    float at = phaseTableIndex(cosTheta, PHASE_TABLE_SIZE);
    int entry = min(int(at), PHASE_TABLE_SIZE - 2);
    int base = index * PHASE_TABLE_SIZE + entry;
    return mix(phaseTables[base].rgb, phaseTables[base + 1].rgb, at - float(entry));
}

/// Radiance that a class scatters along the ray for a unit of light, per unit of optical depth.
vec3 sunlitBy(int index, vec3 dir) {
    float cosTheta = dot(u_.towardsSun.xyz, dir);
    return u_.classes[index].colourAlbedo.rgb * u_.sunRadiance.rgb * displayPhase(index, cosTheta);
}
