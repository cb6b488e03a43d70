// grads_time.h: the time axis of a GrADS descriptor, and the file names that are derived from it.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace les {

/// A date and time of the proleptic Gregorian calendar.
struct CalendarTime {
    int year = 1, month = 1, day = 1, hour = 0, minute = 0;
};

/// A time axis with a constant step in minutes, hours or days, or in calendar months or years.
struct TimeAxis {
    std::size_t count = 0;
    CalendarTime start;
    int step = 1;
    enum class Unit { minute, hour, day, month, year } unit = Unit::hour;

    /// Time number `i`. Throws Error beyond the year 9999, the last that a descriptor can express,
    /// and for dates that do not exist, such as one month after 31 January.
    CalendarTime at(std::size_t i) const;
};

/// Minutes since 00:00 on 1 January of the year 1.
std::int64_t minutesOf(const CalendarTime& time);

/// As GrADS writes it, for example 00:00Z01JAN0001.
std::string labelOf(const CalendarTime& time);

/// `start` and `step` are the words that follow `tdef n linear`. Throws Error.
TimeAxis parseTimeAxis(std::size_t count, std::string_view start, std::string_view step);

/// The name of the data file of time `i`. Replaces %y4 %m2 %d2 %h2 %n2 (date and time), %f2 %f3
/// %fn2 (since the start), %t1 to %t6 (number from 1) and similar codes; %iy4 and the like stand
/// for the start of the axis. Throws Error for an unknown code.
std::string expandTemplate(std::string_view pattern, const TimeAxis& axis, std::size_t i);

}  // namespace les
