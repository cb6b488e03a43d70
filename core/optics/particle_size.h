// particle_size.h: effective radius and extinction of an assumed size distribution, from mass
// content and number concentration or intercept.
//
// SI units. The gamma distribution is N(D) = N λ^(μ+1)/Γ(μ+1) D^μ e^(-λD) in the diameter D; μ = 0
// is the exponential one, N0 e^(-λD) with N0 = N λ. The effective radius is half the third moment
// over the second; the extinction efficiency is 2. docs/physics.md §7
#pragma once

namespace neph {

/// Slope λ, 1/m, of `numberPerM3` spheres of `densityKgPerM3` with a total mass of
/// `contentKgPerM3`; all > 0.
double gammaSlopePerM(double contentKgPerM3, double numberPerM3, double densityKgPerM3, double mu);

/// Slope λ, 1/m, of the exponential distribution with intercept N0, 1/m⁴; all > 0.
double interceptSlopePerM(double contentKgPerM3, double interceptPerM4, double densityKgPerM3);

/// Effective radius (μ + 3) / (2 λ), m.
double effectiveRadiusM(double slopePerM, double mu);

/// Radius of spheres of one size, m.
double equalSpheresRadiusM(double contentKgPerM3, double numberPerM3, double densityKgPerM3);

/// Extinction coefficient, 1/m: 3 Q / (4 ρ_p r_e) times the content, with Q = 2. `densityKgPerM3`
/// is the one for which the radius was derived.
double geometricExtinctionPerM(double contentKgPerM3, double radiusM, double densityKgPerM3);

/// Third moment of snow diameters, m³ per m³, from the second (m² per m³). [Field05]
double snowThirdMoment(double secondMoment, double temperatureK);

}  // namespace neph
