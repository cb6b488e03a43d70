// info_json.h: the summary of a series as JSON (`type` nephoscope-info, version 1).
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "app/cli/common/scene.h"
#include "core/dataset/dataset.h"
#include "core/volume/read_plan.h"

namespace neph {

/// What a role is called in JSON and in tables: "mixing_ratio".
std::string_view roleId(VariableRole role);

/// As infoText(), and every time, variable and attribute. Throws Error.
std::string infoJson(Dataset& dataset, const std::optional<TimeRange>& times,
                     const MemoryBudget& budget);

}  // namespace neph
