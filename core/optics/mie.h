// mie.h: scattering of a plane wave by one homogeneous sphere. [BH83] ch. 4
//
// The size parameter is x = 2π r / wavelength; the refractive index is n + ik relative to the
// medium, k >= 0 for absorption.
#pragma once
#include <complex>
#include <vector>

namespace neph {

/// Coefficients of the scattered field; entry i is order n = i + 1.
struct MieCoefficients {
    std::vector<std::complex<double>> a, b;
};

/// Efficiencies are cross-sections over π r²; `back` is the radar backscattering efficiency, 4π
/// times the differential efficiency at 180°.
struct MieEfficiencies {
    double extinction = 0.0;
    double scattering = 0.0;
    double back = 0.0;
    double asymmetry = 0.0;  ///< mean cosine of the scattering angle
};

/// Valid for any x > 0; checked up to x = 10⁴ (docs/physics.md §6).
MieCoefficients mieCoefficients(double sizeParameter, std::complex<double> index);
MieEfficiencies mieEfficiencies(double sizeParameter, const MieCoefficients& coefficients);

}  // namespace neph
