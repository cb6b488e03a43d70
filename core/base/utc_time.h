// utc_time.h: dates and times in UTC, in the Gregorian calendar.
#pragma once
#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace neph {

/// A date and time of day in UTC, Gregorian calendar, without leap seconds.
using UtcTime = std::chrono::sys_time<std::chrono::duration<double>>;

/// "2021-08-14T18:00:00Z"; with tenths of a second where they are not zero.
std::string utcText(UtcTime time);

/// The inverse: "YYYY-MM-DDThh:mm:ss" with Z, a fraction, or without seconds; nothing for any other
/// text, such as one with the offset of a time zone.
std::optional<UtcTime> utcOfText(std::string_view text);

/// Day of the year, 1 to 366, and hour of the day, 0 to below 24, in UTC.
struct YearTime {
    int year = 2000;
    int day = 1;
    double hour = 0.0;
};
YearTime yearTimeOf(UtcTime time);
UtcTime utcOf(const YearTime& time);

}  // namespace neph
