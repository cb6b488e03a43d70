// grads_time.h: the time axis of a GrADS descriptor and the file names that are made from it.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace raw {

struct CalendarTime {
    int year = 1, month = 1, day = 1, hour = 0, minute = 0;
};

/// Linear in minutes, hours and days, or in calendar months and years.
struct TimeAxis {
    std::size_t count = 0;
    CalendarTime start;
    int step = 1;
    enum class Unit { minute, hour, day, month, year } unit = Unit::hour;

    /// Throws Error beyond the year 9999, which no descriptor can write.
    CalendarTime at(std::size_t i) const;
};

/// Minutes since the first day of the year 1.
std::int64_t minutesOf(const CalendarTime& time);

/// As GrADS writes it, for example 00:00Z01JAN0001.
std::string labelOf(const CalendarTime& time);

/// `words` follow `tdef n linear`: start and step. Throws Error.
TimeAxis parseTimeAxis(std::size_t count, std::string_view start, std::string_view step);

/// The name of the data file of time `i`: %y4 %m2 %d2 %h2 %n2, %f2 %f3 %fn2 (since the start), %t1
/// to %t6 (counted from 1) and their like, each also with i for the start of the axis. Throws
/// Error.
std::string expandTemplate(std::string_view pattern, const TimeAxis& axis, std::size_t i);

}  // namespace raw
