// utc_time.cpp: by the calendar of the standard library.
#include "core/base/utc_time.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace neph {
namespace {

constexpr double kDaySeconds = 86400.0;

/// Digits from the front of a text, exactly `count` of them.
std::optional<int> takeDigits(std::string_view& text, std::size_t count) {
    int value = 0;
    if (text.size() < count) return {};
    const char* end = text.data() + count;
    const auto [stop, code] = std::from_chars(text.data(), end, value);
    if (code != std::errc() || stop != end || value < 0) return {};
    text.remove_prefix(count);
    return value;
}

bool take(std::string_view& text, std::string_view any) {
    if (text.empty() || any.find(text.front()) == std::string_view::npos) return false;
    text.remove_prefix(1);
    return true;
}

/// Seconds with a fraction, if there are any.
std::optional<double> takeSeconds(std::string_view& text) {
    if (!take(text, ":")) return 0.0;
    const auto whole = takeDigits(text, 2);
    if (!whole || *whole > 59) return {};
    double seconds = *whole;
    if (!take(text, ".")) return seconds;
    for (double unit = 0.1; !text.empty() && text.front() >= '0' && text.front() <= '9';
         unit *= 0.1) {
        seconds += unit * (text.front() - '0');
        text.remove_prefix(1);
    }
    return seconds;
}

std::optional<double> takeTimeOfDay(std::string_view& text) {
    const auto hour = takeDigits(text, 2);
    if (!hour || *hour > 23 || !take(text, ":")) return {};
    const auto minute = takeDigits(text, 2);
    if (!minute || *minute > 59) return {};
    const auto seconds = takeSeconds(text);
    if (!seconds) return {};
    return 3600.0 * *hour + 60.0 * *minute + *seconds;
}

}  // namespace

std::string utcText(UtcTime time) {
    const double tenths = std::round(10.0 * time.time_since_epoch().count());
    const double day = std::floor(tenths / (10.0 * kDaySeconds));
    const std::chrono::year_month_day date{
        std::chrono::sys_days(std::chrono::days(static_cast<int>(day)))};
    const int rest = static_cast<int>(tenths - 10.0 * kDaySeconds * day);
    const int seconds = rest / 10;
    return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}{}Z", static_cast<int>(date.year()),
                       static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                       seconds / 3600, seconds / 60 % 60, seconds % 60,
                       rest % 10 == 0 ? "" : fmt::format(".{}", rest % 10));
}

std::optional<UtcTime> utcOfText(std::string_view text) {
    const auto year = takeDigits(text, 4);
    if (!year || !take(text, "-")) return {};
    const auto month = takeDigits(text, 2);
    if (!month || !take(text, "-")) return {};
    const auto day = takeDigits(text, 2);
    if (!day || !take(text, "T ")) return {};
    const std::chrono::year_month_day date(std::chrono::year(*year),
                                           std::chrono::month(static_cast<unsigned>(*month)),
                                           std::chrono::day(static_cast<unsigned>(*day)));
    const auto seconds = takeTimeOfDay(text);
    take(text, "Z");
    if (!date.ok() || !seconds || !text.empty()) return {};
    return UtcTime(std::chrono::sys_days(date)) + std::chrono::duration<double>(*seconds);
}

YearTime yearTimeOf(UtcTime time) {
    const auto midnight = std::chrono::floor<std::chrono::days>(time);
    const std::chrono::year_month_day date(midnight);
    const auto first = std::chrono::sys_days(date.year() / std::chrono::January / 1);
    return {static_cast<int>(date.year()), static_cast<int>((midnight - first).count()) + 1,
            (time - midnight).count() / 3600.0};
}

UtcTime utcOf(const YearTime& time) {
    const auto first =
        std::chrono::sys_days(std::chrono::year(time.year) / std::chrono::January / 1);
    return UtcTime(first + std::chrono::days(time.day - 1)) +
           std::chrono::duration<double>(3600.0 * time.hour);
}

}  // namespace neph
