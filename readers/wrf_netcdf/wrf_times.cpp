// wrf_times.cpp: converts a calendar date to seconds.
#include "readers/wrf_netcdf/wrf_times.h"

#include <array>
#include <charconv>
#include <chrono>

namespace wrf {
namespace {

std::optional<int> numberAt(std::string_view text, std::size_t start, std::size_t length) {
    const std::string_view digits = text.substr(start, length);
    int value = 0;
    const auto [end, code] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (code != std::errc() || end != digits.data() + digits.size() || value < 0) return {};
    return value;
}

}  // namespace

std::optional<double> secondsOf(std::string_view text) {
    constexpr std::string_view kForm = "0000-00-00_00:00:00";
    if (text.size() != kForm.size()) return {};
    for (std::size_t i = 0; i < kForm.size(); ++i) {
        if (kForm[i] != '0' && kForm[i] != text[i]) return {};
    }
    const auto year = numberAt(text, 0, 4);
    const auto month = numberAt(text, 5, 2);
    const auto day = numberAt(text, 8, 2);
    const auto hour = numberAt(text, 11, 2);
    const auto minute = numberAt(text, 14, 2);
    const auto second = numberAt(text, 17, 2);
    if (!year || !month || !day || !hour || !minute || !second) return {};
    if (*hour > 24 || *minute > 59 || *second > 60) return {};
    using namespace std::chrono;
    const year_month_day date{std::chrono::year{*year},
                              std::chrono::month{static_cast<unsigned>(*month)},
                              std::chrono::day{static_cast<unsigned>(*day)}};
    if (!date.ok()) return {};
    const sys_days first{std::chrono::year{1} / 1 / 1};
    const auto days = (sys_days{date} - first).count();
    return static_cast<double>(days) * 86400.0 + *hour * 3600 + *minute * 60 + *second;
}

}  // namespace wrf
