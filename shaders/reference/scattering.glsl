// scattering.glsl: which way light goes on from a particle: the mixture of Eq. 18, at three
// wavelengths.
//
// A path is drawn at one wavelength, its hero, and counts for all three by the chance that they
// would have drawn it (`Wavelengths`), so that no weight exceeds 3. [Wilkie14]
#pragma once
#include "../lib/directions.glsl"
#include "../lib/scattering_table.glsl"
#include "../shared/reference_layout.glsl"
#include "medium.glsl"

layout(binding = kPhasesUnit) uniform sampler2D t_phases;  // rgb: P, 1/sr, one row per class
// Versines, one row per class and wavelength.
layout(binding = kScatteringUnit) uniform sampler2D t_scattering;

/// P at 650, 550 and 450 nm, 1/sr.
vec3 phaseOf(int index, float versine) {
    float at = phaseTableIndexOfVersine(versine, kPhaseTableSize);
    int entry = min(int(at), kPhaseTableSize - 2);
    return mix(texelFetch(t_phases, ivec2(entry, index), 0).rgb,
               texelFetch(t_phases, ivec2(entry + 1, index), 0).rgb, at - float(entry));
}

float largestOf(vec3 v) {
    return max(max(v.r, v.g), v.b);
}

/// Chances of the classes to be what light is scattered by. Colours take part by their largest
/// channel.
struct Mixture {
    float chance[CLASSES];
    float scatteringPerM;
    float extinctionPerM;
};

Mixture mixtureOf(MediumSample medium) {
    Mixture mixture;
    mixture.extinctionPerM = totalExtinctionPerM(medium);
    mixture.scatteringPerM = 0.0;
    for (int i = 0; i < CLASSES; ++i) {
        mixture.chance[i] = medium.extinctionPerM[i] * largestOf(u_.classes[i].colourAlbedo.rgb);
        mixture.scatteringPerM += mixture.chance[i];
    }
    for (int i = 0; i < CLASSES; ++i) mixture.chance[i] /= max(mixture.scatteringPerM, 1e-30);
    return mixture;
}

/// What the mixture sends into a direction: the share of a unit of light, per steradian, and the
/// density with which it is drawn for paths of these wavelengths.
struct Sent {
    vec3 share;
    float density;
};

Sent sentInto(MediumSample medium, Mixture mixture, float versine, vec3 wavelengths) {
    Sent sent = Sent(vec3(0.0), 0.0);
    for (int i = 0; i < CLASSES; ++i) {
        vec3 phase = phaseOf(i, versine);
        sent.share += medium.extinctionPerM[i] * u_.classes[i].colourAlbedo.rgb * phase;
        sent.density += mixture.chance[i] * dot(wavelengths, phase);
    }
    sent.share /= max(mixture.extinctionPerM, 1e-30);
    return sent;
}

/// What is absorbed, 1/m.
vec3 absorptionOf(MediumSample medium) {
    vec3 absorbed = vec3(0.0);
    for (int i = 0; i < CLASSES; ++i) {
        absorbed += medium.extinctionPerM[i] * (1.0 - u_.classes[i].colourAlbedo.rgb);
    }
    return absorbed;
}

int classBy(float u, Mixture mixture) {
    int chosen = 0;
    float sum = 0.0;
    for (int i = 0; i < CLASSES; ++i) {
        if (mixture.chance[i] > 0.0 && u >= sum) chosen = i;
        sum += mixture.chance[i];
    }
    return chosen;
}

/// Draws a scattering angle of a class at one wavelength: its versine (x) and its density per
/// steradian (y).
vec2 drawVersine(int index, int wavelength, float u) {
    float at = scatteringInterval(u, kScatteringIntervals);
    int i = int(at);
    int row = 3 * index + wavelength;
    float lower = texelFetch(t_scattering, ivec2(i, row), 0).r;
    float upper = texelFetch(t_scattering, ivec2(i + 1, row), 0).r;
    return vec2(mix(lower, upper, at - float(i)),
                scatteringDensity(upper - lower, kScatteringIntervals));
}
