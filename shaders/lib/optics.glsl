// optics.glsl: extinction from the mass of particles, and transmittance from extinction.
//
// SI units: lengths in m, densities in kg/m³, extinction in 1/m; optical depth has none. Particles
// are spheres much larger than the wavelength, so the extinction efficiency is 2. Equation numbers
// are those of [Riley03]; docs/physics.md has the derivations.
#pragma once
#include "constants.glsl"

const float kExtinctionEfficiency =
    2.0f;  ///< large-particle limit: half shadow, half diffraction. [BH83] §4.4

/// Volume of a sphere, m³. Eq. 2
float volumeOfSphere(float radiusM) {
    return 4.0f / 3.0f * kPi * radiusM * radiusM * radiusM;
}

/// Particles per m³ of air; `contentKgPerM3` is air density times mixing ratio. Eq. 4
float numberConcentration(float contentKgPerM3, float radiusM, float densityKgPerM3) {
    return contentKgPerM3 / (volumeOfSphere(radiusM) * densityKgPerM3);
}

/// Extinction cross-section of one particle, Q π r², m².
float extinctionCrossSection(float radiusM) {
    return kExtinctionEfficiency * kPi * radiusM * radiusM;
}

/// Extinction coefficient, 1/m. Eq. 9
float extinctionPerM(float crossSectionM2, float concentrationPerM3) {
    return crossSectionM2 * concentrationPerM3;
}

/// Mass extinction 3 Q / (4 ρ r), m²/kg: eq. 2, 4 and 9 for 1 kg of particles per m³ of air.
/// Extinction is this times the mass content.
float massExtinctionM2PerKg(float radiusM, float densityKgPerM3) {
    return 3.0f * kExtinctionEfficiency / (4.0f * densityKgPerM3 * radiusM);
}

/// Share of light that passes an optical depth. Eq. 6
float transmittance(float opticalDepth) {
    return exp(-opticalDepth);
}

/// Update of the light buffer by one slice, eq. 14 to 17 as printed: weights of the centre (x) and
/// of the mean of the four ring taps (y) in the light passed on. `cpInner` and `cpOuter` are the
/// cumulative phase function at a quarter and at half of the forward arc. The result depends on the
/// number of slices; see lightWeightsConsistent.
vec2 lightWeightsPrinted(float opticalDepth, float cpInner, float cpOuter) {
    float through = transmittance(opticalDepth);
    float scattered = 1.0f - through;
    return vec2(through + scattered * cpInner, scattered * (cpOuter - cpInner));
}

/// (e^y - 1) / y for y >= 0; 1 at 0. The series is accurate to 1e-7 where it is used.
float expm1Ratio(float y) {
    if (y < 0.05f) return 1.0f + y * (0.5f + y * (1.0f / 6.0f + y / 24.0f));
    return (exp(y) - 1.0f) / y;
}

/// The same weights in a form that does not depend on the number of slices: light scattered within
/// the forward arc (the share `cpOuter`) counts as still in the beam, so that uniform light
/// decreases as e^-((1 - albedo cpOuter) τ) for any slicing. docs/physics.md §3. Converges to the
/// printed form as the optical depth of a slice goes to zero.
vec2 lightWeightsConsistent(float opticalDepth, float albedo, float cpInner, float cpOuter) {
    float through = transmittance(opticalDepth);
    float kept = albedo * cpOuter * opticalDepth;
    // (e^-(τ - kept) - e^-τ) / cpOuter: the first form avoids 0/0, the second overflow.
    float gain = kept < 1.0f ? through * albedo * opticalDepth * expm1Ratio(kept)
                             : (exp(kept - opticalDepth) - through) / cpOuter;
    return vec2(through + gain * cpInner, gain * (cpOuter - cpInner));
}

/// Light after one slice, printed form.
float lightStepPrinted(float centre, float ring, float opticalDepth, float cpInner, float cpOuter) {
    vec2 weights = lightWeightsPrinted(opticalDepth, cpInner, cpOuter);
    return weights.x * centre + weights.y * ring;
}

/// Light after one slice, step-consistent form.
float lightStepConsistent(float centre, float ring, float opticalDepth, float albedo, float cpInner,
                          float cpOuter) {
    vec2 weights = lightWeightsConsistent(opticalDepth, albedo, cpInner, cpOuter);
    return weights.x * centre + weights.y * ring;
}

/// Diffuse transmittance of a conservative layer for skylight: 1 / (1 + (1 - g) τ / 1.4209).
/// In diffusion theory the flux between two faces is inversely proportional to the scaled depth (1
/// - g) τ plus one extrapolation length of 0.7104 mean free paths (Milne) at each face, 1.4209
/// together [Chandrasekhar60]. The exact share is 4/3 / ((1 - g) τ + 1.4209) for thick layers; here
/// it is scaled to be 1 where there is no cloud (6 % more when thick).
float skyTransmittance(float opticalDepth, float g) {
    const float kTwoExtrapolationLengths = 1.4209f;
    return kTwoExtrapolationLengths / ((1.0f - g) * opticalDepth + kTwoExtrapolationLengths);
}
