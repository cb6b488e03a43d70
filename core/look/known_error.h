// known_error.h: how far the ways in which light is not followed to its end are known to be off.
#pragma once
#include <string>

#include "core/look/look.h"

namespace neph {

/// "light scattered once: 17 to 72 % too dark"; empty of what follows all light. As
/// measured against the reference, in the table of docs/accuracy.md. Says as well where light comes
/// in through open sides although the look has periodic ones.
std::string knownErrorText(const Look& look);

}  // namespace neph
