// air.h: state of the air around the hydrometeors: temperature and density from the variables that
// a model wrote, or a standard atmosphere where it wrote none.
#pragma once

namespace les {

/// Thermodynamic constants of the model that wrote the data; SI.
struct GasConstants {
    double dryGas = 287.04;            ///< J/(kg K), CM1 constants.F
    double vapour = 461.5;             ///< J/(kg K), CM1 constants.F
    double heatCapacity = 1005.7;      ///< J/(kg K) at constant pressure, CM1 constants.F
    double referencePressure = 1.0e5;  ///< Pa, of potential temperature
};

/// Temperature from potential temperature: T = θ (p / p₀)^(R_d / c_p), p₀ = gas.referencePressure.
/// NaN where the pressure is impossible (reader_abi.h).
double temperatureK(double thetaK, double pressurePa, const GasConstants& gas = {});

/// Density of dry air, kg/m³; `vapourRatio` is the water vapour mixing ratio, kg/kg. NaN
/// where pressure or temperature are impossible.
double dryDensity(double temperatureK, double pressurePa, double vapourRatio,
                  const GasConstants& gas = {});

/// One level of a standard atmosphere.
struct Air {
    double temperatureK, pressurePa, densityKgPerM3;
};

/// The U.S. Standard Atmosphere 1976, dry air, identical to the ICAO atmosphere below 32 km.
/// [USSA76] Defined here for heights of 0 to 47 km above sea level; beyond them the nearest layer
/// is extrapolated to -5 km, and held constant above 47 km.
Air standardAtmosphere(double heightM);

}  // namespace les
