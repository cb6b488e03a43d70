// grid_text.h: lengths, widths of cells and steps of time as they are written for people.
#pragma once
#include <string>
#include <string_view>

#include "core/plugin/dataset_info.h"

namespace neph {

/// Three digits, metres below 1 km: "66.7 m", "1 km", "1.25 km".
std::string lengthText(double metres);

/// Width of the native cells: "66.7 m", "1 km x 2 km" where x and y differ, "1 to 5 km" where cells
/// do. `times` stands between x and y.
std::string cellWidthText(const DatasetInfo& info, std::string_view times = " x ");

/// "10 min", or "20 s" below a minute.
std::string minutesText(double seconds);

/// How far apart the times are: "every 10 min", or "5 to 10 min apart"; empty for a single time.
std::string timeStepText(const DatasetInfo& info);

}  // namespace neph
