// solar_position.h: where the sun stands in the sky, by date, UTC and place.
//
// Low-precision formulas of [Meeus98] ch. 25 as NOAA's solar calculator has them, with the sun's
// parallax: within 0.01 degrees of NREL's SPA for the years 1900 to 2100. UTC stands for UT1 and
// for terrestrial time, which moves the sun by less than 0.005 and 0.001 degrees.
#pragma once
#include "core/base/utc_time.h"

namespace neph {

/// Air at the observer, by which light is refracted.
struct ObserverAir {
    double pressurePa = 101000.0;
    double temperatureK = 283.15;
};

/// The centre of the sun's disc as it stands for an observer on the ground. Degrees.
struct SolarPosition {
    double elevationDeg = 0.0;          ///< above the horizon, without air
    double apparentElevationDeg = 0.0;  ///< as seen, raised by refraction
    double azimuthDeg = 0.0;            ///< clockwise from true north, 0 to below 360
    double declinationDeg = 0.0;
    double equationOfTimeMin = 0.0;  ///< apparent less mean solar time
    double distanceAu = 1.0;
};

/// Latitude north and longitude east, degrees. At a pole, north is along the meridian of
/// `longitudeDeg`.
SolarPosition solarPosition(UtcTime time, double latitudeDeg, double longitudeDeg,
                            const ObserverAir& air = {});

/// Degrees by which refraction raises what stands at `elevationDeg`. [Saemundsson86] as SPA has
/// it; of a sun wholly below the horizon it fades with depth, as in NOAA's calculator.
double refractionDeg(double elevationDeg, const ObserverAir& air = {});

/// The sun's passage of the meridian that is nearest to `time`: local noon.
UtcTime nearestNoon(UtcTime time, double longitudeDeg);

}  // namespace neph
