// wishes.cpp: from requests to the rooms that they are meant for.
#include "app/ui/shell/wishes.h"

#include <optional>
#include <utility>

#include "app/ui/presets/preset_commands.h"
#include "app/ui/shell/context.h"

namespace neph::ui {

void carryOutWishes(Ui& ui) {
    const std::optional<std::string> preset = std::exchange(ui.requests.preset, {});
    if (preset) applyPreset(ui.session(), ui.presets, *preset);
}

void openFiles(Ui& ui, const std::vector<std::string>& names) {
    openFiles(contextOf(ui), ui.sessionDialogs, names);
    carryOutWishes(ui);
}

}  // namespace neph::ui
