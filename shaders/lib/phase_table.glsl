// phase_table.glsl: position of an angle in a table of a phase function.
//
// Entry i of a table of `size` entries is for Θ = π (i / (size - 1))², which places half of the
// entries within 45° and resolves the forward peak of droplets. Values between entries are
// interpolated linearly in the index.
#pragma once
#include "constants.glsl"

/// Scattering angle of an entry, radians.
float phaseTableTheta(int index, int size) {
    float x = float(index) / float(size - 1);
    return kPi * x * x;
}

/// Fractional index of an angle given by its cosine; in [0, size - 1].
float phaseTableIndex(float cosTheta, int size) {
    float theta = acos(clamp(cosTheta, -1.0f, 1.0f));
    return min(sqrt(theta / kPi), 1.0f) * float(size - 1);
}
