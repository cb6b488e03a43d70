// grads_time.cpp: calendar arithmetic in whole minutes, and substitution into file names.
#include "readers/raw_les/grads_time.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>

#include "readers/les/text.h"

namespace les {
namespace {

constexpr std::array<std::string_view, 12> kMonths{"jan", "feb", "mar", "apr", "may", "jun",
                                                   "jul", "aug", "sep", "oct", "nov", "dec"};
constexpr std::int64_t kMinutesPerDay = 1440;
constexpr int kLastYear = 9999;

/// Day 0 of minutesOf().
std::chrono::sys_days firstDay() {
    return std::chrono::sys_days{std::chrono::year{1} / 1 / 1};
}

/// Inverse of minutesOf().
CalendarTime calendarOf(std::int64_t minutes) {
    const auto days = static_cast<int>(minutes / kMinutesPerDay);
    const auto rest = static_cast<int>(minutes % kMinutesPerDay);
    const std::chrono::year_month_day date{firstDay() + std::chrono::days{days}};
    return {static_cast<int>(date.year()), static_cast<int>(static_cast<unsigned>(date.month())),
            static_cast<int>(static_cast<unsigned>(date.day())), rest / 60, rest % 60};
}

/// Whether the calendar has this date and a descriptor can express it.
bool exists(const CalendarTime& time) {
    const std::chrono::year_month_day date{std::chrono::year{time.year},
                                           std::chrono::month{static_cast<unsigned>(time.month)},
                                           std::chrono::day{static_cast<unsigned>(time.day)}};
    return time.year >= 1 && time.year <= kLastYear && date.ok() && time.hour <= 23 &&
           time.minute <= 59;
}

/// Accepts [hh[:mm]Z][dd]mmmyyyy and nothing else.
std::optional<CalendarTime> parseCalendarTime(std::string_view text) {
    CalendarTime time;
    const std::string all = toLower(text);
    std::string_view rest = all;
    const auto number = [](std::string_view digits) -> std::optional<int> {
        const auto value = digits.size() > 4 ? std::nullopt : parseInteger(digits);
        if (!value || *value < 0) return {};
        return static_cast<int>(*value);
    };
    if (const std::size_t z = rest.find('z'); z != std::string_view::npos) {
        const std::string_view clock = rest.substr(0, z);
        const std::size_t colon = std::min(clock.find(':'), clock.size());
        const auto hour = number(clock.substr(0, colon));
        const auto minute =
            colon < clock.size() ? number(clock.substr(colon + 1)) : std::optional<int>{0};
        if (!hour || !minute) return {};
        time.hour = *hour;
        time.minute = *minute;
        rest.remove_prefix(z + 1);
    }
    const std::size_t letters = rest.find_first_not_of("0123456789");
    if (letters == std::string_view::npos || rest.size() < letters + 3) return {};
    const auto month = std::ranges::find(kMonths, rest.substr(letters, 3));
    const auto day = letters == 0 ? std::optional<int>{1} : number(rest.substr(0, letters));
    const auto year = number(rest.substr(letters + 3));
    if (month == kMonths.end() || !day || !year) return {};
    time.month = static_cast<int>(month - kMonths.begin()) + 1;
    time.day = *day;
    time.year = *year;
    return exists(time) ? std::optional{time} : std::nullopt;
}

/// Replacement of `code` (without %); nothing for an unknown one.
std::optional<std::string> substitute(std::string_view code, const TimeAxis& axis, std::size_t i) {
    const bool initial = code.starts_with('i');
    if (initial) code.remove_prefix(1);
    const CalendarTime t = initial ? axis.start : axis.at(i);
    if (code == "y4") return fmt::format("{:04}", t.year);
    if (code == "y2") return fmt::format("{:02}", t.year % 100);
    if (code == "m1") return fmt::format("{}", t.month);
    if (code == "m2") return fmt::format("{:02}", t.month);
    if (code == "mc") return std::string(kMonths[static_cast<std::size_t>(t.month - 1)]);
    if (code == "d1") return fmt::format("{}", t.day);
    if (code == "d2") return fmt::format("{:02}", t.day);
    if (code == "h1") return fmt::format("{}", t.hour);
    if (code == "h2") return fmt::format("{:02}", t.hour);
    if (code == "h3") return fmt::format("{:03}", t.hour);
    if (code == "n2") return fmt::format("{:02}", t.minute);
    if (initial) return {};
    const std::int64_t forecast = minutesOf(t) - minutesOf(axis.start);
    if (code == "f2") return fmt::format("{:02}", forecast / 60);
    if (code == "f3") return fmt::format("{:03}", forecast / 60);
    if (code == "fn2") return fmt::format("{:02}", forecast);
    if (code == "fhn") return fmt::format("{:02}{:02}", forecast / 60, forecast % 60);
    if (code.size() == 2 && code[0] == 't' && code[1] >= '1' && code[1] <= '6') {
        return fmt::format("{:0{}}", i + 1, code[1] - '0');
    }
    return {};
}

}  // namespace

CalendarTime TimeAxis::at(std::size_t i) const {
    const std::int64_t steps = static_cast<std::int64_t>(i) * step;
    CalendarTime time = start;
    if (unit == Unit::month || unit == Unit::year) {
        const std::int64_t months =
            std::int64_t{start.year} * 12 + start.month - 1 + steps * (unit == Unit::year ? 12 : 1);
        time.year = static_cast<int>(std::min<std::int64_t>(months / 12, kLastYear + 1));
        time.month = static_cast<int>(months % 12) + 1;
    } else {
        const std::int64_t scale = unit == Unit::day ? kMinutesPerDay : unit == Unit::hour ? 60 : 1;
        const std::int64_t minutes = minutesOf(start) + steps * scale;
        // Clamped just beyond the last year, so that the arithmetic below cannot overflow.
        constexpr std::int64_t kMaxMinutes = std::int64_t{kLastYear} * 366 * kMinutesPerDay;
        time = calendarOf(std::min(minutes, kMaxMinutes));
    }
    if (exists(time)) return time;
    throw Error{fmt::format("time {} of tdef is not a calendar date", i + 1),
                fmt::format("from {} in steps of {}", labelOf(start), step),
                "existing dates up to the year 9999",
                {}};
}

std::int64_t minutesOf(const CalendarTime& time) {
    const std::chrono::sys_days day{std::chrono::year{time.year} /
                                    std::chrono::month{static_cast<unsigned>(time.month)} /
                                    std::chrono::day{static_cast<unsigned>(time.day)}};
    return std::int64_t{(day - firstDay()).count()} * kMinutesPerDay + time.hour * 60 + time.minute;
}

std::string labelOf(const CalendarTime& time) {
    std::string month(kMonths[static_cast<std::size_t>(time.month - 1)]);
    for (char& c : month) c = static_cast<char>(c - 'a' + 'A');
    return fmt::format("{:02}:{:02}Z{:02}{}{:04}", time.hour, time.minute, time.day, month,
                       time.year);
}

TimeAxis parseTimeAxis(std::size_t count, std::string_view start, std::string_view step) {
    constexpr std::int64_t kMaxSteps = 1'000'000;
    TimeAxis axis;
    axis.count = count;
    const auto first = parseCalendarTime(start);
    if (!first) {
        throw Error{"the start of tdef is not a time",
                    inQuotes(start),
                    "hh:mmZddmmmyyyy, for example 00:00Z01JAN0001",
                    {}};
    }
    axis.start = *first;
    const std::string text = toLower(step);
    const std::size_t letters = std::min(text.find_first_not_of("0123456789"), text.size());
    const auto amount = parseInteger(std::string_view(text).substr(0, letters));
    const std::string unit = text.substr(letters);
    constexpr std::array<std::string_view, 5> kUnits{"mn", "hr", "dy", "mo", "yr"};
    const auto known = std::ranges::find(kUnits, unit);
    if (!amount || *amount < 1 || *amount > kMaxSteps || known == kUnits.end()) {
        throw Error{"the step of tdef is not a length of time",
                    inQuotes(step),
                    "a whole number and mn, hr, dy, mo or yr, for example 5mn",
                    {}};
    }
    axis.step = static_cast<int>(*amount);
    axis.unit = static_cast<TimeAxis::Unit>(known - kUnits.begin());
    axis.at(count - 1);  // throws if the axis runs past the last year
    return axis;
}

std::string expandTemplate(std::string_view pattern, const TimeAxis& axis, std::size_t i) {
    std::string name;
    while (!pattern.empty()) {
        if (pattern.front() != '%') {
            name += pattern.front();
            pattern.remove_prefix(1);
            continue;
        }
        // Codes have two or three characters after the %.
        std::optional<std::string> text;
        std::size_t length = 3;
        for (; length <= 4 && !text; ++length) {
            if (length <= pattern.size()) text = substitute(pattern.substr(1, length - 1), axis, i);
        }
        if (!text) {
            throw Error{"dset contains a template that is not supported",
                        inQuotes(pattern.substr(0, std::min<std::size_t>(4, pattern.size()))),
                        "%y4 %m2 %d2 %h2 %n2 %f2 %f3 %fn2 %fhn %t1 to %t6 and similar codes",
                        "write one file for all times, or rename the files"};
        }
        name += *text;
        pattern.remove_prefix(length - 1);
    }
    return name;
}

}  // namespace les
