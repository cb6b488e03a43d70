// options.h: widths of cells that a file states without positions.
#pragma once
#include <optional>

#include "readers/netcdf/nc_file.h"

namespace cf {

/// Width of cells in x (0) or y (1), metres: of the global attribute dx or dy, or of MONC's
/// options_database (dxx, dyy). Nothing if neither states a positive one.
std::optional<double> statedSpacing(const nc::NcFile& file, std::size_t axis);

}  // namespace cf
