// framing.h: views that show all of a volume's cloud, for the window and the commands that render.
//
// Boxes are metres in world space (grid.h).
#pragma once
#include <vector>

#include "core/camera/camera_moves.h"
#include "core/grid/boxes.h"
#include "core/grid/species.h"
#include "core/look/look.h"
#include "core/volume/held_volume.h"

namespace neph {

/// Bounding boxes of what can be seen of each species, with particles of the default sizes, one for
/// each block of the volume that holds any, by block: a view that shows them all fits closer than
/// one that shows the box around them.
std::vector<SeenPart> seenParts(const SpeciesVolume& volume);

/// `pose` turned to a standard view of what was read, with all that is seen as large as possible in
/// an image of this aspect ratio. Fields that the look hides or scales to nothing do not count,
/// unless they are all that there is; where nothing is seen, it is the whole domain.
CameraPose framed(View view, const CameraPose& pose, const VolumeSummary& shown, const Look& look,
                  double aspect);

}  // namespace neph
