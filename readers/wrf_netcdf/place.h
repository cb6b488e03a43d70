// place.h: where on the earth a domain lies, by the map projection of its attributes and by XLAT
// and XLONG.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "readers/wrf_netcdf/tiles.h"

namespace wrf {

/// In the terms of NephDescription.
struct Place {
    std::string projection;
    std::array<double, 2> mapOriginM{};
    std::array<double, 2> mapPerGrid{1.0, 1.0};
};

/// The place of the first time; nothing if the file states none, and a note says why. `spacingM`
/// are the widths of cells that the description gives.
std::optional<Place> placeOf(const Tiles& tiles, const std::array<double, 2>& spacingM,
                             std::vector<std::string>& notes);

/// How far the grid lies, at each of `records`, from where it is at the first time: metres along
/// its x and y; 0 for a domain that stands still. Moves of whole cells are exact.
std::vector<std::array<double, 2>> offsetsOf(const Tiles& tiles, const Place& place,
                                             const std::array<double, 2>& spacingM,
                                             const std::vector<std::size_t>& records);

/// Whether a run states that it has no place: MAP_PROJ 0.
bool isIdealised(const NcFile& file);

}  // namespace wrf
