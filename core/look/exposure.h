// exposure.h: how bright an image of a look is shown.
#pragma once
#include <memory>

#include "core/look/look.h"
#include "core/sky/atmosphere.h"

namespace neph {

/// The air of a look whose sky is an atmosphere; made once for looks that share it.
std::shared_ptr<const Atmosphere> atmosphereOf(const Look& look);

/// Light that falls on a cloud in mid-air, from sun and sky: 1 from a sun without air.
double meteredLight(const Look& look);

/// What radiances are multiplied by before tone mapping.
float exposureGain(const Look& look);

}  // namespace neph
