// panel_table.h: the panels of the window, a row each: where it stands and what draws it.
//
// A new panel is its own file and a row here: drawing, its entry in a menu, its keys, the palette
// and the sheet of keys follow from the row.
#pragma once
#include <span>
#include <string_view>

#include "app/ui/shell/action.h"

namespace neph::ui {

/// In the order in which they are drawn. Top, columns and bottom are there while panels are shown.
enum class PanelPlace : int { image, top, left, right, bottom, over };

struct Panel {
    std::string_view id = {};
    PanelPlace place = PanelPlace::over;
    void (*draw)(Ui&) = nullptr;

    // Of one that can be shown and hidden on its own.
    bool Ui::*shown = nullptr;
    Action toggle = {};              ///< its `run` and `checked` follow from `shown`
    std::string_view before = {};    ///< action that follows it in its menu; none: it is the last
    void (*toggled)(Ui&) = nullptr;  ///< what else is to be done then
};

/// Those of one place are drawn in this order.
std::span<const Panel> panels();

}  // namespace neph::ui
