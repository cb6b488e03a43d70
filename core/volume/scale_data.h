// scale_data.h: what of a volume and its data set decides whether an image of it is to scale.
#pragma once
#include "core/look/to_scale.h"
#include "core/plugin/dataset_info.h"
#include "core/volume/held_volume.h"

namespace neph {

/// Of the time and the region that `shown` is of.
ScaleData scaleDataOf(const DatasetInfo& info, const VolumeSummary& shown);

}  // namespace neph
