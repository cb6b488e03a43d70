// air.h: the air that hydrometeors float in: temperature and density from what a model wrote, or a
// standard atmosphere where it wrote nothing.
#pragma once

namespace raw {

/// Thermodynamic constants of the model that wrote the data; SI.
struct GasConstants {
    double dryGas = 287.04;            ///< J/(kg K), CM1 constants.F
    double vapour = 461.5;             ///< J/(kg K), CM1 constants.F
    double heatCapacity = 1005.7;      ///< J/(kg K) at constant pressure, CM1 constants.F
    double referencePressure = 1.0e5;  ///< Pa, of potential temperature
};

double temperatureK(double thetaK, double pressurePa, const GasConstants& gas = {});

/// Of dry air, kg/m³, where `vapourRatio` kg of vapour come with each kg of it.
double dryDensity(double temperatureK, double pressurePa, double vapourRatio,
                  const GasConstants& gas = {});

struct Air {
    double temperatureK, pressurePa, densityKgPerM3;
};

/// The U.S. Standard Atmosphere 1976, which is the ICAO one below 32 km: dry air. [USSA76]
/// From 0 to 47 km above sea level; what lies outside is taken from the nearest layer.
Air standardAtmosphere(double heightM);

}  // namespace raw
