// sun.cpp: date and place to the angles that engines draw by.
#include "core/look/sun.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>
#include <ratio>

#include "core/grid/grid.h"
#include "core/look/parameter.h"
#include "core/sky/air_columns.h"
#include "core/sky/atmosphere.h"
#include "core/sky/lunar_position.h"
#include "core/sky/solar_position.h"

namespace neph {
namespace {

/// Of the day and hour of a look, where data have no date: a leap year, so that all 366 days exist.
constexpr int kLookYear = 2024;

/// Sine of the elevation in which the disc is seen from an altitude, of that at the ground.
double seenUp(double up, double altitudeM) {
    return apparentSunUp(std::clamp(altitudeM, 0.0, kAtmosphereTopM), trueSunUp(up));
}

/// In [0, 360).
float azimuthFrom(double degrees) {
    const double rest = std::fmod(degrees, 360.0);
    const auto azimuth = static_cast<float>(rest < 0.0 ? rest + 360.0 : rest);
    return azimuth < 360.0f ? azimuth : 0.0f;
}

void setAngles(Look& look, float azimuthDeg, float elevationDeg) {
    look.sunSource = SunSource::angles;
    look.sunAzimuthDeg = azimuthDeg;
    look.sunElevationDeg = elevationDeg;
}

/// Midnight, UTC, before the time of a sun by date.
UtcTime dayOf(const Look& look, const Whereabouts& where) {
    if (where.utc) return std::chrono::floor<std::chrono::days>(*where.utc);
    return utcOf({.year = kLookYear, .day = look.sunDay, .hour = 0.0});
}

}  // namespace

SunState sunStateOf(const Look& look, const Whereabouts& where) {
    SunState state{.azimuthDeg = look.sunAzimuthDeg,
                   .elevationDeg = look.sunElevationDeg,
                   .moon = showsMoon(look),
                   .moonPhaseDeg = look.moonPhaseDeg,
                   .moonLimbDeg = look.moonLimbDeg};
    if (look.sunSource == SunSource::angles) return state;
    state.byDate = true;
    state.placeOfData = where.place.has_value();
    state.dateOfData = where.utc.has_value();
    state.place = {static_cast<double>(look.sunLatitudeDeg),
                   static_cast<double>(look.sunLongitudeDeg)};
    if (where.place) {
        state.place = where.place->geo;
        state.convergenceDeg = where.place->convergenceDeg;
    }
    state.utc = where.utc.value_or(
        utcOf({.year = kLookYear, .day = look.sunDay, .hour = static_cast<double>(look.sunHour)}));
    if (state.moon) {
        const LunarPosition moon =
            lunarPosition(state.utc, state.place.latitudeDeg, state.place.longitudeDeg);
        state.azimuthDeg = azimuthFrom(moon.azimuthDeg + state.convergenceDeg);
        state.elevationDeg = static_cast<float>(moon.apparentElevationDeg);
        state.moonPhaseDeg = static_cast<float>(moon.phaseDeg);
        state.moonLimbDeg = azimuthFrom(moon.limbDeg);
        return state;
    }
    const SolarPosition sun =
        solarPosition(state.utc, state.place.latitudeDeg, state.place.longitudeDeg);
    state.azimuthDeg = azimuthFrom(sun.azimuthDeg + state.convergenceDeg);
    state.elevationDeg = static_cast<float>(sun.apparentElevationDeg);
    return state;
}

Look withSun(const Look& look, const Whereabouts& where) {
    Look drawn = look;
    const SunState state = sunStateOf(look, where);
    setAngles(drawn, state.azimuthDeg, state.elevationDeg);
    drawn.moonPhaseDeg = state.moonPhaseDeg;
    drawn.moonLimbDeg = state.moonLimbDeg;
    // No air keeps the sun of a gradient from shining through the Earth.
    constexpr float kNightDeg = -12.0f;
    if (look.skyModel == SkyModel::gradient && state.elevationDeg < kNightDeg) {
        drawn.sunIntensity = 0.0f;
    }
    // What no longer acts must not make images differ.
    const Look standard;
    drawn.sunLatitudeDeg = standard.sunLatitudeDeg;
    drawn.sunLongitudeDeg = standard.sunLongitudeDeg;
    drawn.sunDay = standard.sunDay;
    drawn.sunHour = standard.sunHour;
    return drawn;
}

std::string sunText(const SunState& state) {
    std::string angles =
        fmt::format("azimuth {:.1f}, elevation {:.1f} deg", state.azimuthDeg, state.elevationDeg);
    if (state.moon) angles += fmt::format(", moon, phase angle {:.0f} deg", state.moonPhaseDeg);
    if (!state.byDate) return angles;
    return fmt::format("{} at {}, {}", angles, utcText(state.utc), geoText(state.place));
}

bool showsMoon(const Look& look) {
    return look.sunBody == LightBody::moon && look.skyModel == SkyModel::atmosphere;
}

float shownIntensity(const Look& look) {
    if (!showsMoon(look)) return look.sunIntensity;
    return look.sunIntensity *
           static_cast<float>(moonShare(static_cast<double>(look.moonPhaseDeg)));
}

glm::dvec3 sunOfMoonWorld(const Look& look) {
    const glm::dvec3 moon = sunDirWorld(look);
    const glm::dvec3 above =
        glm::normalize(std::abs(moon.z) < 0.9999 ? glm::dvec3(0.0, 0.0, 1.0) - moon.z * moon
                                                 : glm::dvec3(0.0, 1.0, 0.0) - moon.y * moon);
    const double limb = glm::radians(static_cast<double>(look.moonLimbDeg));
    const double phase = glm::radians(static_cast<double>(look.moonPhaseDeg));
    const glm::dvec3 side = std::cos(limb) * above + std::sin(limb) * glm::cross(moon, above);
    return std::sin(phase) * side - std::cos(phase) * moon;
}

glm::dvec3 sunDirWorld(const Look& look) {
    assert(look.sunSource == SunSource::angles && "withSun() makes the look that is drawn");
    float elevationDeg = look.sunElevationDeg;
    if (sidesRepeat(look) && std::abs(elevationDeg) < kLowestPeriodicSunDeg) {
        elevationDeg = elevationDeg < 0.0f ? -kLowestPeriodicSunDeg : kLowestPeriodicSunDeg;
    }
    return compassDirWorld(look.sunAzimuthDeg, elevationDeg);
}

glm::dvec3 discDirWorld(const Look& look, double eyeAltitudeM) {
    const glm::dvec3 towardsSun = sunDirWorld(look);
    if (look.skyModel != SkyModel::atmosphere) return towardsSun;
    const double up = seenUp(towardsSun.z, eyeAltitudeM);
    const double across = std::hypot(towardsSun.x, towardsSun.y);
    if (across <= 0.0) return towardsSun;
    const double scale = std::sqrt(std::max(1.0 - up * up, 0.0)) / across;
    return {scale * towardsSun.x, scale * towardsSun.y, up};
}

std::vector<SunPathPoint> sunPathOf(const Look& look, const Whereabouts& where) {
    if (look.sunSource == SunSource::angles && !(where.place && where.utc)) return {};
    constexpr int kPerHour = 4, kSteps = 24 * kPerHour;
    Look dated = look;
    dated.sunSource = SunSource::date;
    Whereabouts then = where;
    std::vector<SunPathPoint> path;
    for (int i = 0; i <= kSteps; ++i) {
        const double hour = static_cast<double>(i) / kPerHour;
        then.utc = dayOf(look, where) + std::chrono::duration<double, std::ratio<3600>>(hour);
        const SunState sun = sunStateOf(dated, then);
        path.push_back(
            {hour, static_cast<double>(sun.azimuthDeg), static_cast<double>(sun.elevationDeg)});
    }
    return path;
}

void setSunAngles(Look& look, double azimuthDeg, double elevationDeg) {
    const ParameterRange& range = parameter("sun.elevation").range;
    setAngles(look, azimuthFrom(azimuthDeg),
              static_cast<float>(std::clamp(elevationDeg, range.lo, range.hi)));
}

void setDiscSeen(Look& look, const glm::dvec3& direction, double eyeAltitudeM) {
    const double wanted = std::asin(std::clamp(direction.z, -1.0, 1.0));
    double elevation = wanted;
    if (look.skyModel == SkyModel::atmosphere) {
        constexpr int kRounds = 8;  // bending changes slowly
        for (int i = 0; i < kRounds; ++i) {
            elevation += wanted - std::asin(seenUp(std::sin(elevation), eyeAltitudeM));
        }
    }
    setSunAngles(look, glm::degrees(std::atan2(direction.x, direction.y)), glm::degrees(elevation));
}

void setGoldenHour(Look& look, const Whereabouts& where) {
    setAngles(look, sunStateOf(look, where).azimuthDeg, 6.0f);
}

void setNoon(Look& look, const Whereabouts& where) {
    if (look.sunSource == SunSource::angles) return setAngles(look, 180.0f, 60.0f);
    const SunState state = sunStateOf(look, where);
    const UtcTime noon = nearestNoon(state.utc, state.place.longitudeDeg);
    if (!state.dateOfData) {
        const YearTime time = yearTimeOf(noon);
        look.sunDay = time.day;
        look.sunHour = static_cast<float>(time.hour);
        return;
    }
    Whereabouts then = where;
    then.utc = noon;
    const SunState passage = sunStateOf(look, then);
    setAngles(look, passage.azimuthDeg, passage.elevationDeg);
}

void setBacklit(Look& look, float cameraAzimuthDeg) {
    setAngles(look, azimuthFrom(static_cast<double>(cameraAzimuthDeg) + 180.0), 10.0f);
}

}  // namespace neph
