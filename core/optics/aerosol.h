// aerosol.h: what particles of a model's aerosol take out of light at 550 nm in humid air.
//
// Dry radii follow a lognormal distribution by number. Particles take up water by κ-Köhler theory
// [Petters07] without the Kelvin effect, are spheres, and have the index of their volumes of water
// and dry matter. docs/sky.md
#pragma once
#include <complex>
#include <vector>

namespace neph {

/// One kind of particles.
struct AerosolKind {
    double medianRadiusM;           ///< of the dry ones, by number
    double deviation;               ///< geometric standard deviation of radii
    double hygroscopicity;          ///< κ
    std::complex<double> dryIndex;  ///< refractive index at 550 nm
};

/// Of the water-friendly aerosol of Thompson's scheme: sizes of [Thompson14], p. 3638; radius and κ
/// with which `activ_ncloud` of [WRF] activates it; index of what is soluble in water in [Hess98].
inline constexpr AerosolKind kHygroscopicAerosol{0.04e-6, 1.8, 0.4, {1.53, 0.006}};
/// Of its ice-friendly aerosol: the sizes and the κ that bring the cross-sections of [WRF],
/// `gt_aod`, within 2 %; index of mineral in [Hess98].
inline constexpr AerosolKind kDustAerosol{0.4e-6, 1.8, 0.04, {1.53, 0.0055}};

/// Particles grow no further above this humidity, as in `gt_aod` of [WRF]: what is beyond is cloud.
inline constexpr double kMostAerosolHumidity = 0.98;

/// Radius over dry radius in air of a relative humidity, which is limited to 0 and
/// kMostAerosolHumidity: (1 + κ h / (1 - h))^(1/3). [Petters07] eq. 2
double radiusGrowth(double humidity, double hygroscopicity);

/// Mean extinction cross-section of a particle at 550 nm, m², by Mie's theory.
double meanExtinctionM2(const AerosolKind& kind, double humidity);

/// The same from a table, within 0.1 %.
class ExtinctionByHumidity {
  public:
    explicit ExtinctionByHumidity(const AerosolKind& kind);
    double atM2(double humidity) const;

  private:
    std::vector<double> logM2_;
};

}  // namespace neph
