// calendar.h: dates as model output writes them, and CF times such as "minutes since 2021-08-14".
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace shared {

/// The calendars of CF. "standard" is taken as proleptic_gregorian, which is the same after 1582.
enum class Calendar { gregorian, julian, noLeap, allLeap, days360 };

/// By its CF name; nothing for an unknown one. Empty: gregorian.
std::optional<Calendar> calendarNamed(std::string_view name);

/// Seconds from 0001-01-01 00:00:00 to a date "YYYY-MM-DD", optionally followed by a blank, T or _
/// and "hh", "hh:mm" or "hh:mm:ss" (or with _ for :), with a fraction and a Z allowed; nothing for
/// any other text.
std::optional<double> secondsOfDate(std::string_view text, Calendar calendar = Calendar::gregorian);

/// The inverse, as WRF writes it: "YYYY-MM-DD_hh:mm:ss", to the nearest second.
std::string dateOfSeconds(double seconds, Calendar calendar = Calendar::gregorian);

/// "UNIT since DATE": seconds from 0001-01-01 = origin + perUnit · number.
struct TimeUnit {
    double originSeconds = 0.0, secondsPerUnit = 1.0;
    double secondsOf(double number) const { return originSeconds + secondsPerUnit * number; }
};
/// Nothing if `units` is no such text.
std::optional<TimeUnit> timeUnit(std::string_view units, Calendar calendar);

}  // namespace shared
