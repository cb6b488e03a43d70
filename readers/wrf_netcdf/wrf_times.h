// wrf_times.h: the times of a file, from whatever states them.
#pragma once
#include <string>
#include <vector>

#include "core/plugin/reader_plugin.h"
#include "readers/wrf_netcdf/axes.h"
#include "readers/wrf_netcdf/nc_file.h"

namespace wrf {

/// The times that a file holds, and the record of each.
struct FileTimes {
    std::vector<neph::plugin::Time> times;  ///< seconds from 0001-01-01 in the calendar of the file
    std::vector<std::size_t> records;       ///< indices along the axis of time, one for each time
    std::vector<std::string> notes;
    bool gregorian = true;  ///< the calendar of the file
};

/// Reads Times (characters or strings; a blank, T or _ before the hour), or a CF time such as XTIME
/// where Times is gone. Entries that state no time are left out with a note. Throws Failure if
/// there is no time at all, or no entry that can be read.
FileTimes readTimes(const NcFile& file, const Axes& axes);

}  // namespace wrf
