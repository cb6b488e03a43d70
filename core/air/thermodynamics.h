// thermodynamics.h: moist air: potential temperatures, dew point, condensation and the
// pseudoadiabat. Pressures are in Pa, temperatures in K, vapour ratios in kg per kg of dry air.
#pragma once

namespace neph {

inline constexpr double kFreezingK = 273.15;
inline constexpr double kGravityMPerS2 = 9.81;
/// Gas constant over specific heat of dry air [Bolton80].
inline constexpr double kPoissonDry = 0.2854;

double potentialTemperatureK(double pressurePa, double temperatureK);

/// Temperature of dry air of the same density and pressure.
double virtualTemperatureK(double temperatureK, double vapourRatio);

/// Mixing ratio of saturated vapour over water; over 1 where the pressure is below that of vapour.
double saturationRatio(double pressurePa, double temperatureK);

/// The inverse of saturationPressurePa, of the vapour in the air; 0 K where there is none.
double dewPointK(double pressurePa, double vapourRatio);

/// At which unsaturated air condenses when lifted. [Bolton80] eq. 21, within 0.1 K
double condensationTemperatureK(double pressurePa, double temperatureK, double vapourRatio);

/// Pressure there, on the dry adiabat. Never above that of the air.
double condensationPressurePa(double pressurePa, double temperatureK, double vapourRatio);

/// Of pseudoadiabatic ascent. [Bolton80] eq. 39, within 0.02 K
double equivalentPotentialTemperatureK(double pressurePa, double temperatureK, double vapourRatio);

/// Temperature at `toPa` of saturated air that was at `temperatureK` at `fromPa`, all water that
/// condenses falling out: where its equivalent potential temperature is the same, within 0.01 K.
double pseudoadiabatK(double fromPa, double temperatureK, double toPa);

}  // namespace neph
