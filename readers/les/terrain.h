// terrain.h: heights of levels that follow terrain.
#pragma once
#include <optional>

#include "readers/les/contents.h"

namespace les {

/// Variables of a descriptor from which heights are computed, metres above sea level.
struct Terrain {
    std::optional<std::size_t> ground;      ///< a plane
    std::optional<std::size_t> cellHeight;  ///< of the middle of every cell
};

/// Whether the stored heights are those of the nominal levels everywhere. Reads a plane or two.
bool isFlat(const Contents& contents, const Terrain& terrain);

/// Adds interface heights in every column. contents.interfacesM are the nominal heights, those of a
/// column at sea level.
///
/// With heights of cells, an interface divides the distance between two centres as the nominal
/// interface does, and beyond them the line through the nearest two is continued; the ground is the
/// lowest interface where it is known. Otherwise levels are those of Gal-Chen and Somerville:
/// z = zs + ζ (top − zs) / top, zs the ground and ζ the nominal height. [GalChen75]
void addTerrainHeights(Contents& contents, const Terrain& terrain);

}  // namespace les
