// probe_text.h: a column as text for people and as JSON for programs.
#pragma once
#include <string>

#include "core/analysis/column.h"

namespace neph {

std::string probeText(const Dataset& dataset, const ColumnReport& report);
std::string probeJson(const Dataset& dataset, const ColumnReport& report);

}  // namespace neph
