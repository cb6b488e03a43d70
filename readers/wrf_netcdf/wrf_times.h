// wrf_times.h: WRF's own spelling of time.
#pragma once
#include <optional>
#include <string_view>

namespace wrf {

/// Seconds since 0001-01-01_00:00:00 in the Gregorian calendar of "YYYY-MM-DD_hh:mm:ss"; nothing
/// when it is not such a text.
std::optional<double> secondsOf(std::string_view text);

}  // namespace wrf
