// command_search.h: actions and parameters by parts of their names.
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/ui/shell/actions.h"
#include "core/look/parameter.h"

namespace neph::ui {

/// One of the two.
struct Command {
    const Action* action = nullptr;
    const Parameter* parameter = nullptr;

    std::string_view id() const { return action != nullptr ? action->id : parameter->id; }
    std::string label() const;  ///< "Time after", "Cloud: Mixing scale"
    std::string where() const;  ///< menu or group
};

/// How well `text` names `label`: 0 is best. Every word of it must begin a word of label, place or
/// id, or else be a part of one; -1: not at all. Upper and lower case are the same.
int matchOf(std::string_view text, std::string_view label, std::string_view more);

/// All that `text` names, the best first, those of `recent` ids before others as good. Nothing
/// typed: those of `recent`, then all actions.
std::vector<Command> findCommands(std::string_view text, std::span<const std::string> recent);

}  // namespace neph::ui
