// sun.h: where the sun of a look stands: by its angles, or by date and place.
//
// Engines draw looks whose sun stands by angles in the frame of the grid. `withSun` makes such a
// look; whoever hands a look to a renderer calls lookAsDrawn(), which does.
#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/base/utc_time.h"
#include "core/geo/map_grid.h"
#include "core/look/look.h"

namespace neph {

/// The sun of one image.
struct SunState {
    float azimuthDeg = 0.0f;    ///< in the frame of the grid, clockwise from its y axis, 0 to 360
    float elevationDeg = 0.0f;  ///< as seen, with refraction where it follows from a date
    bool moon = false;          ///< the moon in the sun's place
    float moonPhaseDeg = 0.0f, moonLimbDeg = 0.0f;
    // Where it follows from a date: what it follows from.
    bool byDate = false;
    GeoPoint place{};
    UtcTime utc{};
    double convergenceDeg = 0.0;  ///< azimuth in the grid less true azimuth
    bool placeOfData = false;     ///< else sun.latitude and sun.longitude
    bool dateOfData = false;      ///< else sun.day and sun.hour
};

/// Where the sun stands over `where`; with SunSource::date, what the data do not state comes from
/// the look.
SunState sunStateOf(const Look& look, const Whereabouts& where);

/// The same look with the sun by angles, as it stands over `where`; date and place are the
/// defaults.
Look withSun(const Look& look, const Whereabouts& where);

/// "azimuth 110.9, elevation 2.3 deg at 2010-03-15T06:30:00Z, 78.22 N 15.65 E"; the angles alone of
/// a sun by angles.
std::string sunText(const SunState& state);

/// Whether the moon stands in the sun's place; a sky of two colours is one of day.
bool showsMoon(const Look& look);

/// Of the sun, or of the moon in its place: irradiance outside the air over 4 pi.
float shownIntensity(const Look& look);

/// From the moon, in world space, where the sun stands that lights it.
glm::dvec3 sunOfMoonWorld(const Look& look);

/// Unit vector towards the sun in world space, of a look whose sun stands by angles.
glm::dvec3 sunDirWorld(const Look& look);

/// Unit vector towards the middle of the disc as it is seen from an altitude: the air bends light
/// less on its way to what is high.
glm::dvec3 discDirWorld(const Look& look, double eyeAltitudeM);

/// Where the sun stands at an hour of the day, UTC.
struct SunPathPoint {
    double hour = 0.0;  ///< 0 to 24
    double azimuthDeg = 0.0, elevationDeg = 0.0;
};

/// The sun's path over `where` on the day of the look or of the data, every quarter of an hour from
/// 0 to 24 UTC. Empty where place or date is not known: of a sun by angles over data that lack one.
std::vector<SunPathPoint> sunPathOf(const Look& look, const Whereabouts& where);

/// The sun by angles from then on: any azimuth, and the nearest elevation that `sun.elevation`
/// takes.
void setSunAngles(Look& look, double azimuthDeg, double elevationDeg);

/// The same so that the disc is seen from an altitude in a direction, of unit length.
void setDiscSeen(Look& look, const glm::dvec3& direction, double eyeAltitudeM);

/// The sun at 6 degrees, in the azimuth in which it is: from then on by angles.
void setGoldenHour(Look& look, const Whereabouts& where);

/// Noon: of a look by date the sun's passage of the meridian at that place on that day. Where the
/// date is that of the data, which cannot be changed, by angles from then on. Of a look by angles
/// azimuth 180 and elevation 60 degrees.
void setNoon(Look& look, const Whereabouts& where);

/// The sun at 10 degrees behind what a camera sees that stands in the direction
/// `cameraAzimuthDeg` of its target: from then on by angles.
void setBacklit(Look& look, float cameraAzimuthDeg);

}  // namespace neph
