// failure.h: what the readers of NetCDF throw: Failure for bad input, Cancelled when the host
// cancels.
#pragma once
#include "core/plugin/reader_plugin.h"

namespace nc {

using Failure = neph::plugin::Error;
using neph::plugin::Cancelled;

}  // namespace nc
