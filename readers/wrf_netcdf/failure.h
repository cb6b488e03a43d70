// failure.h: names of readers/netcdf that this reader uses as its own.
#pragma once
#include "readers/netcdf/cf_times.h"
#include "readers/netcdf/nc_file.h"

namespace wrf {

using nc::Cancelled;
using nc::Container;
using nc::containerOf;
using nc::Failure;
using nc::FileTimes;
using nc::joined;
using nc::listOf;
using nc::NcDimension;
using nc::NcFile;
using nc::NcVariable;

}  // namespace wrf
