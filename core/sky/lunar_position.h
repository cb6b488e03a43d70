// lunar_position.h: where the moon stands in the sky, and how it is lit, by date, UTC and place.
//
// The largest terms of [Meeus98] ch. 47: within 0.1 degrees for the years 1900 to 2100.
#pragma once
#include "core/base/utc_time.h"

namespace neph {

/// The middle of the moon's disc as it stands for an observer on the ground. Degrees.
struct LunarPosition {
    double apparentElevationDeg = 0.0;  ///< as seen, raised by refraction
    double azimuthDeg = 0.0;            ///< clockwise from true north, 0 to below 360
    double distanceKm = 384400.0;       ///< from the middle of the Earth
    double phaseDeg = 0.0;  ///< between sun and Earth as the moon sees them: 0 full, 180 new
    double limbDeg = 0.0;   ///< of its bright side, clockwise from the vertical, 0 to below 360
};

/// Latitude north and longitude east, degrees.
LunarPosition lunarPosition(UtcTime time, double latitudeDeg, double longitudeDeg);

/// Light of the moon outside the air as a share of the sun's, by its phase: 2.5e-6 when it is full.
/// [Allen76]
double moonShare(double phaseDeg);

}  // namespace neph
