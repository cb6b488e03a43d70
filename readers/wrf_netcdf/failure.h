// failure.h: what this reader throws for bad input and where the host asks it to stop.
#pragma once
#include "core/plugin/reader_plugin.h"

namespace wrf {

using Failure = neph::plugin::Error;
using neph::plugin::Cancelled;

}  // namespace wrf
