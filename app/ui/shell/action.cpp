// action.cpp: how an action is shown.
#include "app/ui/shell/action.h"

#include <array>

namespace neph::ui {

std::string_view menuName(Menu menu) {
    constexpr std::array<std::string_view, kMenuCount> kNames{
        "File", "Edit", "View", "Presets", "Camera", "Time", "Ask", "Compare", "Output", "Help"};
    return kNames.at(static_cast<std::size_t>(menu));
}

std::string tooltipOf(const Action& action) {
    const std::string chord = chordText(action.chord);
    return std::string(action.label) + ": " + std::string(action.help) +
           (chord.empty() ? "" : "  " + chord);
}

std::string helpOf(const Action& action, const Ui& ui) {
    const bool needs = !action.needs.empty() && !isEnabled(action, ui);
    return std::string(action.help) + (needs ? "\nNeeds " + std::string(action.needs) : "");
}

bool isEnabled(const Action& action, const Ui& ui) {
    return !action.enabled || action.enabled(ui);
}

bool isChecked(const Action& action, const Ui& ui) {
    return action.checked && action.checked(ui);
}

}  // namespace neph::ui
