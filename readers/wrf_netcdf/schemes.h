// schemes.h: WRF's microphysics schemes: names, and the size distributions that they share.
#pragma once
#include <string>

#include "core/plugin/reader_abi.h"

namespace wrf {

/// For example "Thompson (MP_PHYSICS 8)"; an unknown number is given as a number.
std::string schemeName(int mpPhysics);

/// Whose size distributions the scheme's hydrometeors follow.
NephMicrophysics microphysicsOf(int mpPhysics);

}  // namespace wrf
