// key_table.h: the table of actions as text, for docs/workbench.md.
#pragma once
#include <string>

namespace neph::ui {

/// Markdown, a row an action, menu by menu; ends with a line break.
std::string keyTable();

}  // namespace neph::ui
