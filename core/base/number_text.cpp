// number_text.cpp: fixed-point notation where that is short, powers of ten elsewhere.
#include "core/base/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace neph {
namespace {

constexpr double kLeastFixed = 1e-4, kMostFixed = 1e7;

}  // namespace

std::string numberText(double value, int digits) {
    const double size = std::abs(value);
    if (value == 0.0) return "0";
    if (!(size >= kLeastFixed && size < kMostFixed)) return fmt::format("{:.{}g}", value, digits);
    const int before = static_cast<int>(std::floor(std::log10(size))) + 1;
    std::string text = fmt::format("{:.{}f}", value, std::clamp(digits - before, 0, digits + 3));
    if (text.find('.') == std::string::npos) return text;
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

std::string percentText(double share, double sigma) {
    if (!(sigma > 0.0)) return numberText(100.0 * share, 4) + " %";
    const double percent = 100.0 * sigma;
    // Two significant digits of the standard error.
    const int decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(percent))), 0, 4);
    return fmt::format("{:.{}f} ± {:.{}f} %", 100.0 * share, decimals, percent, decimals);
}

}  // namespace neph
