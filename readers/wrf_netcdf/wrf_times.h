// wrf_times.h: the times of a file, from whatever states them.
#pragma once
#include "readers/wrf_netcdf/axes.h"
#include "readers/wrf_netcdf/failure.h"

namespace wrf {

/// Reads Times (characters or strings; a blank, T or _ before the hour), or a CF time such as XTIME
/// where Times is gone. Entries that state no time are left out with a note. Throws Failure if
/// there is no time at all, or no entry that can be read.
FileTimes readTimes(const NcFile& file, const Axes& axes);

}  // namespace wrf
