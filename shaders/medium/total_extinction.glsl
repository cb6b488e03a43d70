// total_extinction.glsl: the sum over the classes of a sample of either engine's medium, which
// comes before.
#pragma once

float totalExtinctionPerM(MediumSample s) {
    float sum = 0.0;
    for (int i = 0; i < CLASSES; ++i) sum += s.extinctionPerM[i];
    return sum;
}
