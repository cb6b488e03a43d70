// framing.h: views that show all of a volume's cloud, for the window and the commands that render.
//
// Boxes are metres in world space (grid.h).
#pragma once
#include <vector>

#include "core/camera/camera_moves.h"
#include "core/grid/boxes.h"
#include "core/grid/species.h"
#include "core/volume/held_volume.h"

namespace neph {

/// Bounding boxes of what can be seen, one for each block of the volume that holds any: a view that
/// shows them all fits closer than one that shows the box around them.
std::vector<BoxM> seenParts(const SpeciesVolume& volume);

/// `pose` turned to a standard view of what was read, with all that is seen as large as possible in
/// an image of this aspect ratio; where nothing is seen, with the whole domain.
CameraPose framed(View view, const CameraPose& pose, const VolumeSummary& shown, double aspect);

}  // namespace neph
