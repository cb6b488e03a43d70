// humidity.h: relative humidity of air, and how far one sees through haze that grows with it.
#pragma once

namespace neph {

/// Pressure of saturated vapour over water, Pa; within 0.3 % from -30 to 35 °C. [Bolton80] eq. 10
double saturationPressurePa(double temperatureK);

/// Of air with `vapourRatio` kg of vapour per kg of dry air, over water: 1 is saturated; never
/// below 0, and above 1 where the air is supersaturated.
double relativeHumidity(double pressurePa, double temperatureK, double vapourRatio);

/// Density of the dry part of such air, kg/m³.
double dryDensityKgPerM3(double pressurePa, double temperatureK, double vapourRatio);

/// Visibility in clear air, metres, at a contrast of 0.02 like AtmosphereSpec::visibilityM: that of
/// NCEP's post-processor, 90 km exp(-2.5 (humidity - 0.15)), even below a humidity of 15 and above
/// 95 %, which is at a contrast of 0.05. [UPP]
double visibilityOfHumidityM(double humidity);

}  // namespace neph
