// whereabouts.h: where on the earth and when a scene of a data set is.
#pragma once
#include <glm/glm.hpp>

#include "core/geo/map_grid.h"
#include "core/grid/grid.h"
#include "core/plugin/dataset_info.h"

namespace neph {

/// Place of the position `atM` (metres from the grid's south-west corner, wherever the grid lies at
/// that time) and date of time `time`, each as far as the data state it.
Whereabouts whereaboutsOf(const DatasetInfo& info, int time, glm::dvec2 atM);
/// The same of the middle of a grid within the domain.
Whereabouts whereaboutsOf(const DatasetInfo& info, int time, const RegularGrid& grid);

}  // namespace neph
