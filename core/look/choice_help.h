// choice_help.h: what each choice of a parameter means, one line each.
#pragma once
#include <string_view>

#include "core/look/look.h"

namespace neph {

/// Help of the choice of that index; empty where the row is no choice.
std::string_view choiceHelp(const Parameter& row, int choice);

}  // namespace neph
