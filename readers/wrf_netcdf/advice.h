// advice.h: what a NetCDF file is that cannot be read as WRF output, and what its owner can do.
#pragma once
#include <string>

#include "readers/wrf_netcdf/failure.h"

namespace wrf {

/// Whether the file is that of another known model or program, or input of WRF.
bool isForeign(const NcFile& file);

/// Whether a file has names that only WRF and what processes its output use.
bool hasWrfNames(const NcFile& file);

/// The error for a file without the fields of WRF output.
Failure adviceFor(const NcFile& file);

/// A sentence about a file of WRF that is read but is no history file; empty for those.
std::string kindNote(const NcFile& file);

}  // namespace wrf
