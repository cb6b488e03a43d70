// failure.h: what this reader throws: Failure for bad input, Cancelled when the host cancels.
#pragma once
#include "core/plugin/reader_plugin.h"

namespace wrf {

using Failure = neph::plugin::Error;
using neph::plugin::Cancelled;

}  // namespace wrf
