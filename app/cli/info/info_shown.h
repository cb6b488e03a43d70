// info_shown.h: how much of a domain an image on this machine shows.
#pragma once
#include <string>

#include "core/dataset/dataset.h"
#include "core/volume/read_plan.h"

namespace neph {

/// "at full resolution", or the sentence of the plan that `budget` and the renderer of this machine
/// allow. Asks for the renderer only where the domain is so large that it matters. Throws Error.
std::string shownHere(Dataset& dataset, int time, MemoryBudget budget);

}  // namespace neph
