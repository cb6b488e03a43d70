// info_members.h: the members of an ensemble, told.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/dataset/dataset.h"

namespace neph {

/// Name, times and files of each member, and what of the ensemble the rest of the summary is about;
/// empty for a single run.
std::string membersLines(const Dataset& dataset);

/// The same as a list; null for a single run.
nlohmann::ordered_json membersJson(const Dataset& dataset);

}  // namespace neph
