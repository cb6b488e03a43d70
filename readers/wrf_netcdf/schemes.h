// schemes.h: WRF's microphysics schemes: their names, and which size distributions they use.
#pragma once
#include <string>

#include "core/plugin/reader_abi.h"

namespace wrf {

/// For example "Thompson (MP_PHYSICS 8)"; "MP_PHYSICS 777" for an unknown number.
std::string schemeName(int mpPhysics);

/// The scheme whose size distributions the hydrometeors follow; unknown if none is implemented.
NephMicrophysics microphysicsOf(int mpPhysics);

}  // namespace wrf
