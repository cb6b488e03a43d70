// solar_position.cpp: the sun's ecliptic longitude, and from it what an observer sees.
#include "core/sky/solar_position.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace neph {
namespace {

constexpr double kRad = std::numbers::pi / 180.0;
constexpr double kSecondsPerDay = 86400.0;

double sinDeg(double degrees) {
    return std::sin(degrees * kRad);
}
double cosDeg(double degrees) {
    return std::cos(degrees * kRad);
}

/// The same angle in [0, 360).
double turned(double degrees) {
    const double rest = std::fmod(degrees, 360.0);
    return rest < 0.0 ? rest + 360.0 : rest;
}

/// What does not depend on the observer.
struct Sun {
    double declinationDeg, equationOfTimeMin, distanceAu;
};

/// [Meeus98] ch. 25, 28; the names of its quantities are those of docs/physics.md.
Sun sunAt(UtcTime time) {
    constexpr double kJ2000Seconds = 946728000.0;  // 2000-01-01 12:00 from 1970
    const double t = (time.time_since_epoch().count() - kJ2000Seconds) / (36525.0 * kSecondsPerDay);
    const double meanLongitude = turned(280.46646 + t * (36000.76983 + t * 0.0003032));
    const double anomaly = turned(357.52911 + t * (35999.05029 - t * 0.0001537));
    const double eccentricity = 0.016708634 - t * (0.000042037 + t * 1.267e-7);
    const double centre = (1.914602 - t * (0.004817 + t * 0.000014)) * sinDeg(anomaly) +
                          (0.019993 - t * 0.000101) * sinDeg(2.0 * anomaly) +
                          0.000289 * sinDeg(3.0 * anomaly);
    const double node = 125.04 - 1934.136 * t;
    const double longitude = meanLongitude + centre - 0.00569 - 0.00478 * sinDeg(node);
    const double seconds = 21.448 - t * (46.815 + t * (0.00059 - t * 0.001813));
    const double obliquity = 23.0 + (26.0 + seconds / 60.0) / 60.0 + 0.00256 * cosDeg(node);

    const double halfTan = std::tan(0.5 * obliquity * kRad);
    const double y = halfTan * halfTan;
    const double equation = y * sinDeg(2.0 * meanLongitude) - 2.0 * eccentricity * sinDeg(anomaly) +
                            4.0 * eccentricity * y * sinDeg(anomaly) * cosDeg(2.0 * meanLongitude) -
                            0.5 * y * y * sinDeg(4.0 * meanLongitude) -
                            1.25 * eccentricity * eccentricity * sinDeg(2.0 * anomaly);
    const double distance = 1.000001018 * (1.0 - eccentricity * eccentricity) /
                            (1.0 + eccentricity * cosDeg(anomaly + centre));
    return {std::asin(sinDeg(obliquity) * sinDeg(longitude)) / kRad, 4.0 * equation / kRad,
            distance};
}

/// Degrees from the meridian, west positive, -180 to 180.
double hourAngleDeg(UtcTime time, const Sun& sun, double longitudeDeg) {
    const double days = time.time_since_epoch().count() / kSecondsPerDay;
    const double minutes = 1440.0 * (days - std::floor(days)) + sun.equationOfTimeMin;
    return turned(minutes / 4.0 + longitudeDeg) - 180.0;
}

}  // namespace

double refractionDeg(double elevationDeg, const ObserverAir& air) {
    // SPA's limit: the sun's radius below the refraction at the horizon.
    constexpr double kUpperRimSetsDeg = -(0.26667 + 0.5667);
    const double seen = std::clamp(elevationDeg, kUpperRimSetsDeg, 90.0);
    const double angle = (seen + 10.3 / (seen + 5.11)) * kRad;
    const double raised =
        air.pressurePa / 101000.0 * (283.0 / air.temperatureK) * 1.02 / (60.0 * std::tan(angle));
    if (elevationDeg >= kUpperRimSetsDeg) return std::max(raised, 0.0);
    if (elevationDeg <= -90.0) return 0.0;
    return raised * std::tan(kUpperRimSetsDeg * kRad) / std::tan(elevationDeg * kRad);
}

SolarPosition solarPosition(UtcTime time, double latitudeDeg, double longitudeDeg,
                            const ObserverAir& air) {
    const Sun sun = sunAt(time);
    const double hour = hourAngleDeg(time, sun, longitudeDeg);
    // Towards the sun: east, north and up, of length 1 and seen from the middle of the earth.
    const double east = -cosDeg(sun.declinationDeg) * sinDeg(hour);
    const double north = cosDeg(latitudeDeg) * sinDeg(sun.declinationDeg) -
                         sinDeg(latitudeDeg) * cosDeg(sun.declinationDeg) * cosDeg(hour);
    const double up = sinDeg(latitudeDeg) * sinDeg(sun.declinationDeg) +
                      cosDeg(latitudeDeg) * cosDeg(sun.declinationDeg) * cosDeg(hour);
    constexpr double kParallaxRad = 8.794 / 3600.0 * kRad;  // at 1 au [Meeus98] ch. 40
    const double fromGround = up - kParallaxRad / sun.distanceAu;
    SolarPosition seen;
    seen.elevationDeg = std::atan2(fromGround, std::hypot(east, north)) / kRad;
    seen.apparentElevationDeg = seen.elevationDeg + refractionDeg(seen.elevationDeg, air);
    seen.azimuthDeg = turned(std::atan2(east, north) / kRad);
    seen.declinationDeg = sun.declinationDeg;
    seen.equationOfTimeMin = sun.equationOfTimeMin;
    seen.distanceAu = sun.distanceAu;
    return seen;
}

UtcTime nearestNoon(UtcTime time, double longitudeDeg) {
    constexpr double kSecondsPerDegree = 240.0;
    // The second round takes the equation of time at noon itself.
    for (int round = 0; round < 2; ++round) {
        const double hour = hourAngleDeg(time, sunAt(time), longitudeDeg);
        time -= std::chrono::duration<double>(kSecondsPerDegree * hour);
    }
    return time;
}

}  // namespace neph
