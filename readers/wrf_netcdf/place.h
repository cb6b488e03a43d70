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

/// Whether a run states that it has no place: MAP_PROJ 0.
bool isIdealised(const NcFile& file);

}  // namespace wrf
