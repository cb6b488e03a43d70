// grid.h: the widths of cells on the earth, and which domain they belong to.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "core/plugin/reader_plugin.h"
#include "readers/wrf_netcdf/tiles.h"

namespace wrf {

inline constexpr double kEarthRadiusM = 6370000.0;  // reradius of WRF's module_model_constants.F
inline constexpr int kLatitudeLongitude = 6;        // of MAP_PROJ

/// All values of a variable on the horizontal grid at the first time, x fastest; none if it is not
/// there.
std::vector<float> flatField(const Tiles& tiles, const char* name);

/// Widths in x and y, metres: DX and DY (degrees, for latitude-longitude grids) divided by the mean
/// map scale factor; without DX, from coordinates. Notes say what was applied. Throws Failure.
std::array<double, 2> spacingOf(const Tiles& tiles, std::vector<std::string>& notes);

/// A sentence if the domain moves between two records; empty otherwise. `placed`: whether its
/// place is known at each time.
std::string motionNote(const Tiles& tiles, std::size_t first, std::size_t last, bool placed);

/// A text that differs between domains: number, centre, and corner; empty if the file states none.
/// Of a nest that `mayMove`, as its place or its corner in its parent is described, the number and
/// the start of the run.
std::string domainOf(const Tiles& tiles, bool mayMove);

/// Which domain of a nested run a file has, in the terms of NephDescription; numbers are 0 where
/// the file states none.
void numberDomain(const NcFile& file, neph::plugin::Description& description);

}  // namespace wrf
