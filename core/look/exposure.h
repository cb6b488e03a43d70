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

/// Light that falls on a deep cloud from sun and sky, of its lower and its upper part the
/// one that has more: 1 from a sun without air.
double meteredLight(const Look& look);

/// What radiances are multiplied by before tone mapping.
float exposureGain(const Look& look);

}  // namespace neph
