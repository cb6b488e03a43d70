// wishes.h: what one room asks of another.
#pragma once
#include <string>
#include <vector>

#include "app/ui/shell/ui.h"

namespace neph::ui {

/// Carries out what panels have asked of one another since the last call.
void carryOutWishes(Ui& ui);

/// Opens what was named or dropped: one preset, one session, or data. Faults become messages.
void openFiles(Ui& ui, const std::vector<std::string>& names);

}  // namespace neph::ui
