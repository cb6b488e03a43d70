// scattering_table.glsl: sampling of scattering angles from a table of equally probable intervals.
//
// The same share of the light is scattered between any two neighbouring entries. Entries are
// versines, 1 - cos Θ, from forward (0) to backward (2). Within an interval the versine is sampled
// uniformly, so the density is known exactly and can be divided out.
#pragma once
#include "constants.glsl"

/// Interval, and position within it, for a uniform number in [0, 1).
float scatteringInterval(float u, int intervals) {
    return min(u, 0.99999994f) * float(intervals);
}

/// Density, 1/sr, within an interval of this width in versine.
float scatteringDensity(float width, int intervals) {
    return 1.0f / (2.0f * kPi * float(intervals) * max(width, 1e-12f));
}

/// Fractional index into a phase table (phase_table.glsl) for a versine; in [0, size - 1].
float phaseTableIndexOfVersine(float versine, int size) {
    // Mesa's asin and acos are accurate only to 1e-4, an error that adds up over a path.
    float theta = 2.0f * atan(sqrt(versine), sqrt(max(2.0f - versine, 0.0f)));
    return min(sqrt(theta / kPi), 1.0f) * float(size - 1);
}
