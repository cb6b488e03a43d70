// scattering_table.glsl: drawing scattering angles from a table of equally probable intervals.
//
// Between two entries of the table lies the same share of the light; entries are versines, 1 -
// cos Theta, from straight on (0) to straight back (2). Within an interval the versine is uniform,
// so that the density is known exactly, and the function that is drawn from can be weighted for.
#pragma once
#include "constants.glsl"

/// Interval, with the place in it, for a uniform number in [0, 1).
float scatteringInterval(float u, int intervals) {
    return min(u, 0.99999994f) * float(intervals);
}

/// Density per steradian within an interval of this width in versine.
float scatteringDensity(float width, int intervals) {
    return 1.0f / (2.0f * kPi * float(intervals) * max(width, 1e-12f));
}

/// Entry, with its fraction, of a phase table (phase_table.glsl) for a versine; in [0, size - 1].
float phaseTableIndexOfVersine(float versine, int size) {
    // Mesa's asin and acos are right to 1e-4, which a path adds up over all its scatterings.
    float theta = 2.0f * atan(sqrt(versine), sqrt(max(2.0f - versine, 0.0f)));
    return min(sqrt(theta / kPi), 1.0f) * float(size - 1);
}
