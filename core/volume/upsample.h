// upsample.h: interpolates a volume to a finer grid over the same domain, for measurements at sizes
// that no sample has.
#pragma once
#include "core/grid/species.h"

namespace neph {

/// Interpolates every species of `volume` to `size` cells, along no axis fewer than before,
/// trilinearly between cell centres; constant beyond the outermost centres. Works species by
/// species, so that besides the result little more than one species of the old volume is in memory.
/// Uses several threads.
void upsample(SpeciesVolume& volume, glm::ivec3 size);

}  // namespace neph
