// exposure.h: how bright an image of a look is shown.
#pragma once
#include <memory>

#include "core/look/look.h"
#include "core/sky/atmosphere.h"

namespace neph {

/// The air of a look whose sky is an atmosphere; made once for looks that share it.
std::shared_ptr<const Atmosphere> atmosphereOf(const Look& look);

/// Irradiance of the sky on a level surface over 4 pi, of sunlight outside the atmosphere.
Spectrum skyOnLevel(const Atmosphere& air, double altitudeM, double sunUp);

/// Light that falls on a deep cloud from sun and sky, the mean of its heights: 1 from a sun without
/// air.
double meteredLight(const Look& look);

/// The same with its colour, linear sRGB; of the sun, also where the moon stands in its place.
glm::dvec3 meteredColour(const Look& look);

/// What radiances are multiplied by before tone mapping.
float exposureGain(const Look& look);

/// Exposure value at ISO 100 of a camera that shows them so.
double exposureValue(const Look& look);

/// Irradiance at an altitude of all of the disc, which neither cloud nor horizon hides, linear sRGB
/// in the units of images; 0 with a sky of two colours.
glm::dvec3 discIrradiance(const Look& look, double altitudeM);

/// Of the glare of the sun in the lens by shaders/lib/sun_disc.glsl: what glareAt() is multiplied
/// by where all of the disc is seen from an altitude.
glm::vec3 glareOf(const Look& look, double altitudeM);

/// From radiance to display.
struct DisplayTones {
    glm::mat3 exposure{1.0f};  ///< gain and white balance
    int curve = 0;             ///< of shaders/lib/tonemap.glsl
};
DisplayTones displayTones(const Look& look);

}  // namespace neph
