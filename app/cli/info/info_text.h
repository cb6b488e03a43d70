// info_text.h: the summary of a series as text.
#pragma once
#include <optional>
#include <string>

#include "app/cli/common/scene.h"
#include "core/dataset/dataset.h"
#include "core/volume/read_plan.h"

namespace neph {

/// Reads the times asked for, or those that take seconds. Throws Error.
std::string infoText(Dataset& dataset, const std::optional<TimeRange>& times,
                     const MemoryBudget& budget);

}  // namespace neph
