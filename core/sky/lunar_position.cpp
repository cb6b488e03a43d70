// lunar_position.cpp: the moon's ecliptic place, and from it what an observer sees.
#include "core/sky/lunar_position.h"

#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "core/sky/solar_position.h"

namespace neph {
namespace {

using glm::dvec3;

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kEarthRadiusKm = 6378.14, kAuKm = 149597870.7;

/// Multiples of elongation, the sun's and the moon's anomaly and the argument of latitude, and what
/// the sine of their sum adds to the longitude, 1e-6 degrees, and its cosine to the distance, m.
struct Term {
    int elongation, solar, lunar, latitude;
    double sine, cosine;
};

/// [Meeus98] table 47.A, down to 0.004 degrees.
constexpr std::array kLongitude{
    Term{0, 0, 1, 0, 6288774, -20905355}, Term{2, 0, -1, 0, 1274027, -3699111},
    Term{2, 0, 0, 0, 658314, -2955968},   Term{0, 0, 2, 0, 213618, -569925},
    Term{0, 1, 0, 0, -185116, 48888},     Term{0, 0, 0, 2, -114332, -3149},
    Term{2, 0, -2, 0, 58793, 246158},     Term{2, -1, -1, 0, 57066, -152138},
    Term{2, 0, 1, 0, 53322, -170733},     Term{2, -1, 0, 0, 45758, -204586},
    Term{0, 1, -1, 0, -40923, -129620},   Term{1, 0, 0, 0, -34720, 108743},
    Term{0, 1, 1, 0, -30383, 104755},     Term{2, 0, 0, -2, 15327, 10321},
    Term{0, 0, 1, 2, -12528, 0},          Term{0, 0, 1, -2, 10980, 79661},
    Term{4, 0, -1, 0, 10675, -34782},     Term{0, 0, 3, 0, 10034, -23210},
    Term{4, 0, -2, 0, 8548, -21636},      Term{2, 1, -1, 0, -7888, 24208},
    Term{2, 1, 0, 0, -6766, 30824},       Term{1, 0, -1, 0, -5163, -8379},
    Term{1, 1, 0, 0, 4987, -16675},       Term{2, -1, 1, 0, 4036, -12831}};

/// Table 47.B, likewise.
constexpr std::array kLatitude{
    Term{0, 0, 0, 1, 5128122, 0}, Term{0, 0, 1, 1, 280602, 0}, Term{0, 0, 1, -1, 277693, 0},
    Term{2, 0, 0, -1, 173237, 0}, Term{2, 0, -1, 1, 55413, 0}, Term{2, 0, -1, -1, 46271, 0},
    Term{2, 0, 0, 1, 32573, 0},   Term{0, 0, 2, 1, 17198, 0},  Term{2, 0, 1, -1, 9266, 0},
    Term{0, 0, 2, -1, 8822, 0},   Term{2, -1, 0, -1, 8216, 0}, Term{2, 0, -2, -1, 4324, 0},
    Term{2, 0, 1, 1, 4200, 0}};

/// Towards east, north and up.
dvec3 towards(double azimuthDeg, double elevationDeg) {
    return {std::cos(elevationDeg * kDegree) * std::sin(azimuthDeg * kDegree),
            std::cos(elevationDeg * kDegree) * std::cos(azimuthDeg * kDegree),
            std::sin(elevationDeg * kDegree)};
}

/// From the middle of the Earth in km, equator of date, x towards the equinox.
dvec3 moonFromEarth(double centuries) {
    const double t = centuries;
    const double longitude = 218.3164477 + t * (481267.88123421 - 0.0015786 * t);
    const double elongation = 297.8501921 + t * (445267.1114034 - 0.0018819 * t);
    const double solar = 357.5291092 + t * (35999.0502909 - 0.0001536 * t);
    const double lunar = 134.9633964 + t * (477198.8675055 + 0.0087414 * t);
    const double latitude = 93.2720950 + t * (483202.0175233 - 0.0036539 * t);
    const auto angleOf = [&](const Term& term) {
        return kDegree * (term.elongation * elongation + term.solar * solar + term.lunar * lunar +
                          term.latitude * latitude);
    };
    double lambda = longitude, beta = 0.0, distanceKm = 385000.56;
    for (const Term& term : kLongitude) {
        lambda += 1e-6 * term.sine * std::sin(angleOf(term));
        distanceKm += 1e-3 * term.cosine * std::cos(angleOf(term));
    }
    for (const Term& term : kLatitude) beta += 1e-6 * term.sine * std::sin(angleOf(term));
    const double obliquity = (23.4393 - 0.0130 * t) * kDegree;
    const dvec3 ecliptic(std::cos(beta * kDegree) * std::cos(lambda * kDegree),
                         std::cos(beta * kDegree) * std::sin(lambda * kDegree),
                         std::sin(beta * kDegree));
    return distanceKm * dvec3(ecliptic.x,
                              ecliptic.y * std::cos(obliquity) - ecliptic.z * std::sin(obliquity),
                              ecliptic.y * std::sin(obliquity) + ecliptic.z * std::cos(obliquity));
}

double turnedOnce(double degrees) {
    const double rest = std::fmod(degrees, 360.0);
    return rest < 0.0 ? rest + 360.0 : rest;
}

}  // namespace

LunarPosition lunarPosition(UtcTime time, double latitudeDeg, double longitudeDeg) {
    const double days = (time.time_since_epoch().count() - 946728000.0) / 86400.0;  // from J2000
    const dvec3 moonKm = moonFromEarth(days / 36525.0);
    // Sidereal time [Meeus98] ch. 12.
    const double meridian = (280.46061837 + 360.98564736629 * days + longitudeDeg) * kDegree;
    const double latitude = latitudeDeg * kDegree;
    const dvec3 east(-std::sin(meridian), std::cos(meridian), 0.0);
    const dvec3 up(std::cos(latitude) * std::cos(meridian), std::cos(latitude) * std::sin(meridian),
                   std::sin(latitude));
    const dvec3 fromGroundKm = moonKm - kEarthRadiusKm * up;
    const dvec3 seen = glm::normalize(dvec3(glm::dot(fromGroundKm, east),
                                            glm::dot(fromGroundKm, glm::cross(up, east)),
                                            glm::dot(fromGroundKm, up)));
    const SolarPosition sun = solarPosition(time, latitudeDeg, longitudeDeg);
    const dvec3 towardsSun = towards(sun.azimuthDeg, sun.elevationDeg);
    LunarPosition moon;
    const double elevationDeg = std::asin(seen.z) / kDegree;
    moon.apparentElevationDeg = elevationDeg + refractionDeg(elevationDeg);
    moon.azimuthDeg = turnedOnce(std::atan2(seen.x, seen.y) / kDegree);
    moon.distanceKm = glm::length(moonKm);
    // As from the middle of the Earth, which almanacs state.
    const dvec3 level = glm::normalize(dvec3(
        glm::dot(moonKm, east), glm::dot(moonKm, glm::cross(up, east)), glm::dot(moonKm, up)));
    const double apart = std::acos(glm::clamp(glm::dot(level, towardsSun), -1.0, 1.0));
    const double sunKm = sun.distanceAu * kAuKm;
    moon.phaseDeg =
        std::atan2(sunKm * std::sin(apart), moon.distanceKm - sunKm * std::cos(apart)) / kDegree;
    // Of what is above the moon, and right of it.
    const dvec3 above = dvec3(0.0, 0.0, 1.0) - seen.z * seen;
    moon.limbDeg = turnedOnce(
        std::atan2(glm::dot(towardsSun, glm::cross(seen, above)), glm::dot(towardsSun, above)) /
        kDegree);
    return moon;
}

double moonShare(double phaseDeg) {
    constexpr double kFullMagnitudes = 26.74 - 12.73;  // fainter than the sun
    const double i = std::abs(phaseDeg);
    return std::pow(10.0, -0.4 * (kFullMagnitudes + 0.026 * i + 4e-9 * i * i * i * i));
}

}  // namespace neph
