// phase_moments.h: Legendre moments of phase functions, by which the solver of multiple scattering
// knows them.
//
// chi_l is the integral of P(cosTheta) P_l(cosTheta) over the sphere, so that chi_0 = 1 and chi_1
// is the asymmetry parameter; Henyey-Greenstein has chi_l = g^l.
#pragma once
#include <array>
#include <functional>

namespace neph {

inline constexpr int kPhaseMomentCount = 10;  ///< l = 0 ... 9

using PhaseMoments = std::array<double, kPhaseMomentCount>;

/// Of `phase`, which takes the cosine of the scattering angle and need not be normalised. The
/// points lie at angles pi x², dense enough for the peak of water droplets.
PhaseMoments phaseMomentsOf(const std::function<float(float cosTheta)>& phase);

}  // namespace neph
