// wrf_times.h: WRF's format of times.
#pragma once
#include <optional>
#include <string_view>

namespace wrf {

/// Seconds from 0001-01-01_00:00:00, in the proleptic Gregorian calendar, to a time given as
/// "YYYY-MM-DD_hh:mm:ss"; nothing for any other text. Idealised runs start in the year 1.
std::optional<double> secondsOf(std::string_view text);

}  // namespace wrf
