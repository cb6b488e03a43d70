// upsample.h: a volume on a finer grid over the same domain, for measurements at sizes that no
// sample has.
#pragma once
#include "core/grid/species.h"

namespace neph {

/// Brings every species of `volume` to `size` cells, none fewer along any axis than there are, by
/// trilinear interpolation between cell centres; beyond the outermost centres their value holds.
/// Goes species by species, so that beside the result little more than one species of the old
/// volume is held. Uses several threads.
void upsample(SpeciesVolume& volume, glm::ivec3 size);

}  // namespace neph
