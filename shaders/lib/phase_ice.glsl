// phase_ice.glsl: ice crystals as a double Henyey-Greenstein fit in the effective radius, 0.5-0.6
// µm. [Key02]
//
// Two habits: rough aggregates and solid columns. Coefficients are those of libRadtran's "yang"
// tables [libRadtran]; the polynomial is used directly as g of the first lobe. Radii are in m,
// clamped to the fitted range. The fit is smooth and has no halos.
#pragma once
#include "phase_double_hg.glsl"

const float kIceBackwardG = -0.65f;
const float kRoughAggregateWeight = 0.990f;
const float kSolidColumnWeight = 0.976f;

/// g of the forward lobe of rough aggregates; fitted for 3.55-108.1 µm.
float roughAggregateG(float radiusM) {
    float r = clamp(1e6f * radiusM, 3.55f, 108.1f);
    return 0.755577f + r * (4.77827e-4f + r * (-7.4097e-6f + r * 3.66023e-8f));
}

/// g of the forward lobe of solid columns; fitted for 5.96-84.2 µm.
float solidColumnG(float radiusM) {
    float r = clamp(1e6f * radiusM, 5.96f, 84.2f);
    return 0.726759f + r * (2.8649e-3f + r * (-3.45189e-5f + r * 1.99615e-7f));
}

/// Phase function of rough aggregates, 1/sr.
float roughAggregateValue(float cosTheta, float radiusM) {
    return doubleHgValue(cosTheta, roughAggregateG(radiusM), kIceBackwardG, kRoughAggregateWeight);
}

/// Share of the light that rough aggregates scatter within `theta` radians of forward.
float roughAggregateCumulative(float theta, float radiusM) {
    return doubleHgCumulative(theta, roughAggregateG(radiusM), kIceBackwardG,
                              kRoughAggregateWeight);
}

/// Cosine of a direction sampled with density roughAggregateValue, from a uniform number in [0, 1).
float roughAggregateSample(float u, float radiusM) {
    return doubleHgSample(u, roughAggregateG(radiusM), kIceBackwardG, kRoughAggregateWeight);
}

/// Mean of cosTheta of rough aggregates.
float roughAggregateAsymmetry(float radiusM) {
    return doubleHgAsymmetry(roughAggregateG(radiusM), kIceBackwardG, kRoughAggregateWeight);
}

/// Phase function of solid columns, 1/sr.
float solidColumnValue(float cosTheta, float radiusM) {
    return doubleHgValue(cosTheta, solidColumnG(radiusM), kIceBackwardG, kSolidColumnWeight);
}

/// Share of the light that solid columns scatter within `theta` radians of forward.
float solidColumnCumulative(float theta, float radiusM) {
    return doubleHgCumulative(theta, solidColumnG(radiusM), kIceBackwardG, kSolidColumnWeight);
}

/// Cosine of a direction sampled with density solidColumnValue, from a uniform number in [0, 1).
float solidColumnSample(float u, float radiusM) {
    return doubleHgSample(u, solidColumnG(radiusM), kIceBackwardG, kSolidColumnWeight);
}

/// Mean of cosTheta of solid columns.
float solidColumnAsymmetry(float radiusM) {
    return doubleHgAsymmetry(solidColumnG(radiusM), kIceBackwardG, kSolidColumnWeight);
}
