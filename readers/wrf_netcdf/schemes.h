// schemes.h: names of WRF's microphysics schemes.
#pragma once
#include <string>

namespace wrf {

/// For example "Thompson (MP_PHYSICS 8)"; an unknown number is given as a number.
std::string schemeName(int mpPhysics);

}  // namespace wrf
