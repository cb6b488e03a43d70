// calendar.cpp: days since 0001-01-01 in each calendar.
#include "readers/shared/calendar.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

#include "readers/shared/units.h"

namespace shared {
namespace {

constexpr double kDaySeconds = 86400.0;
constexpr std::array kDaysBefore{0, 31, 59, 90, 120, 151, 181, 212, 243, 273, 304, 334, 365};

struct Date {
    int year = 1, month = 1, day = 1;
};

bool isLeap(int year, Calendar calendar) {
    switch (calendar) {
        case Calendar::gregorian:
            return year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
        case Calendar::julian:
            return year % 4 == 0;
        case Calendar::allLeap:
            return true;
        case Calendar::noLeap:
        case Calendar::days360:
            break;
    }
    return false;
}

/// Leap days in the years before `year`.
int leapDaysBefore(int year, Calendar calendar) {
    const int past = year - 1;
    switch (calendar) {
        case Calendar::gregorian:
            return past / 4 - past / 100 + past / 400;
        case Calendar::julian:
            return past / 4;
        case Calendar::allLeap:
            return past;
        case Calendar::noLeap:
        case Calendar::days360:
            break;
    }
    return 0;
}

/// Days in the year before the first of `month`, 1 to 13.
int daysBeforeMonth(int year, int month, Calendar calendar) {
    if (calendar == Calendar::days360) return 30 * (month - 1);
    return kDaysBefore[static_cast<std::size_t>(month - 1)] +
           (month > 2 && isLeap(year, calendar) ? 1 : 0);
}

int daysInMonth(int year, int month, Calendar calendar) {
    return daysBeforeMonth(year, month + 1, calendar) - daysBeforeMonth(year, month, calendar);
}

int daysBeforeYear(int year, Calendar calendar) {
    const int length = calendar == Calendar::days360 ? 360 : 365;
    return length * (year - 1) + leapDaysBefore(year, calendar);
}

Date dateOfDays(int days, Calendar calendar) {
    Date date;
    date.year = std::max(days / 366 + 1, 1);
    while (daysBeforeYear(date.year + 1, calendar) <= days) ++date.year;
    const int inYear = days - daysBeforeYear(date.year, calendar);
    while (date.month < 12 && daysBeforeMonth(date.year, date.month + 1, calendar) <= inYear) {
        ++date.month;
    }
    date.day = inYear - daysBeforeMonth(date.year, date.month, calendar) + 1;
    return date;
}

/// Takes texts of a date from the front.
class Scanner {
  public:
    explicit Scanner(std::string_view text) : rest_(text) {}

    bool atEnd() const { return rest_.empty(); }
    /// Whether the next character is one of `any`, which is then taken.
    bool take(std::string_view any) {
        if (rest_.empty() || any.find(rest_.front()) == std::string_view::npos) return false;
        rest_.remove_prefix(1);
        return true;
    }
    /// Up to `most` digits.
    std::optional<int> digits(std::size_t most) {
        std::size_t length = 0;
        while (length < std::min(most, rest_.size()) &&
               std::isdigit(static_cast<unsigned char>(rest_[length])) != 0) {
            ++length;
        }
        int value = 0;
        const auto [end, code] = std::from_chars(rest_.data(), rest_.data() + length, value);
        if (length == 0 || code != std::errc()) return {};
        rest_.remove_prefix(length);
        return value;
    }
    void dropDigits() {
        while (!rest_.empty() && std::isdigit(static_cast<unsigned char>(rest_.front())) != 0) {
            rest_.remove_prefix(1);
        }
    }

  private:
    std::string_view rest_;
};

/// The time of day in seconds; nothing if what follows is not one.
std::optional<double> timeOfDay(Scanner& text) {
    double seconds = 0.0;
    double unit = 3600.0;
    for (const int most : {24, 59, 60}) {
        const auto value = text.digits(2);
        if (!value || *value > most) return {};
        seconds += *value * unit;
        unit /= 60.0;
        if (!text.take(":_")) break;  // colons are replaced where file systems forbid them
    }
    if (text.take(".")) text.dropDigits();  // fractions of seconds do not matter to model output
    return seconds;
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlank(" \t\0", 3);
    const std::size_t first = text.find_first_not_of(kBlank);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

}  // namespace

std::optional<Calendar> calendarNamed(std::string_view name) {
    struct Row {
        std::string_view name;
        Calendar calendar;
    };
    constexpr std::array kRows{
        Row{"", Calendar::gregorian},          Row{"standard", Calendar::gregorian},
        Row{"gregorian", Calendar::gregorian}, Row{"proleptic_gregorian", Calendar::gregorian},
        Row{"julian", Calendar::julian},       Row{"noleap", Calendar::noLeap},
        Row{"365_day", Calendar::noLeap},      Row{"all_leap", Calendar::allLeap},
        Row{"366_day", Calendar::allLeap},     Row{"360_day", Calendar::days360}};
    std::string spelling(trimmed(name));
    std::ranges::transform(spelling, spelling.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const auto found = std::ranges::find(kRows, spelling, &Row::name);
    if (found == kRows.end()) return {};
    return found->calendar;
}

std::optional<double> secondsOfDate(std::string_view text, Calendar calendar) {
    Scanner scan(trimmed(text));
    const auto year = scan.digits(4);
    if (!year || *year < 1 || !scan.take("-")) return {};
    const auto month = scan.digits(2);
    if (!month || *month < 1 || *month > 12 || !scan.take("-")) return {};
    const auto day = scan.digits(2);
    if (!day || *day < 1 || *day > daysInMonth(*year, *month, calendar)) return {};
    double seconds = 0.0;
    if (scan.take(" T_")) {
        const auto time = timeOfDay(scan);
        if (!time) return {};
        seconds = *time;
    }
    scan.take(" ");
    scan.take("Z");
    if (!scan.atEnd()) return {};
    const int days =
        daysBeforeYear(*year, calendar) + daysBeforeMonth(*year, *month, calendar) + *day - 1;
    return days * kDaySeconds + seconds;
}

std::string dateOfSeconds(double seconds, Calendar calendar) {
    constexpr double kMostSeconds = 9999.0 * 360.0 * kDaySeconds;
    const double whole = std::clamp(std::round(seconds), 0.0, kMostSeconds);
    const double days = std::floor(whole / kDaySeconds);
    const auto rest = static_cast<int>(whole - days * kDaySeconds);
    const Date date = dateOfDays(static_cast<int>(days), calendar);
    return fmt::format("{:04}-{:02}-{:02}_{:02}:{:02}:{:02}", date.year, date.month, date.day,
                       rest / 3600, rest / 60 % 60, rest % 60);
}

std::optional<TimeUnit> timeUnit(std::string_view units, Calendar calendar) {
    const std::size_t since = units.find(" since ");
    if (since == std::string_view::npos) return {};
    const auto toSeconds = conversion(trimmed(units.substr(0, since)), "s");
    const auto origin = secondsOfDate(units.substr(since + 7), calendar);
    if (!toSeconds || !origin || toSeconds->offset != 0.0) return {};
    return TimeUnit{*origin, toSeconds->scale};
}

}  // namespace shared
