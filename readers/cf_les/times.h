// times.h: the times of a file, from a date, a unit of time or nothing at all.
#pragma once
#include "readers/cf_les/models.h"
#include "readers/netcdf/cf_times.h"

namespace cf {

struct Times : nc::FileTimes {
    bool dated = false;  ///< seconds count from 0001-01-01, in the Gregorian calendar if it says so
};

/// Times along the dimension `dimension`, empty for fields without one. A variable in a unit of
/// time that states no date counts from the start of the run. Throws Failure if there are several
/// records and no times.
Times timesOf(const nc::NcFile& file, const std::string& dimension);

}  // namespace cf
