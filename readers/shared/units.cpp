// units.cpp: calls of UDUNITS-2, which is not thread-safe.
#include "readers/shared/units.h"

#include <udunits2.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <memory>
#include <mutex>
#include <string>

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#include <sanitizer/lsan_interface.h>
#endif
#endif

namespace shared {
namespace {

constexpr std::size_t kMaxLength = 64;  // longer texts are descriptions

struct UnitDeleter {
    void operator()(ut_unit* unit) const { ut_free(unit); }
};
struct ConverterDeleter {
    void operator()(cv_converter* converter) const { cv_free(converter); }
};
using Unit = std::unique_ptr<ut_unit, UnitDeleter>;
using Converter = std::unique_ptr<cv_converter, ConverterDeleter>;

/// A spelling of model output, and what UDUNITS calls it.
struct Spelling {
    std::string_view written, meant;
};
constexpr std::array kPureNumbers{"-", "none", "dimensionless", "unitless", "nondimensional"};
constexpr std::array kInPressure{Spelling{"mb", "hPa"}, Spelling{"mbar", "hPa"},
                                 Spelling{"hpa", "hPa"}, Spelling{"pa", "Pa"}};
constexpr std::array kInHeight{Spelling{"gpm", "m"}, Spelling{"gpkm", "km"}};
constexpr std::array kInTemperature{Spelling{"c", "celsius"}, Spelling{"deg c", "celsius"},
                                    Spelling{"degc", "celsius"}, Spelling{"k", "K"}};

std::string lower(std::string_view text) {
    std::string result(text);
    std::ranges::transform(result, result.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

void replaceAll(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos;
         at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
    }
}

/// `unit` as UDUNITS spells it, where a unit like `wanted` is expected.
std::string spelled(std::string_view unit, std::string_view wanted) {
    std::string text(unit);
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.pop_back();
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())))
        text.erase(0, 1);
    if (text.empty()) return text;
    const std::string small = lower(text);
    if (std::ranges::find(kPureNumbers, small) != kPureNumbers.end()) return "1";
    const auto meant = [&](const auto& spellings) -> std::string {
        const auto found = std::ranges::find(spellings, small, &Spelling::written);
        return found == spellings.end() ? text : std::string(found->meant);
    };
    if (wanted == "Pa") return meant(kInPressure);
    if (wanted == "K") return meant(kInTemperature);
    if (wanted == "m" && meant(kInHeight) != text) return meant(kInHeight);
    // "[g/kg]", and "kg kg-1 (dry air)".
    if (text.front() == '[' && text.back() == ']') text = text.substr(1, text.size() - 2);
    const std::size_t remark = text.rfind('(');
    if (remark != std::string::npos && remark > 0 && text.back() == ')' &&
        std::isalpha(static_cast<unsigned char>(text[std::min(remark + 1, text.size() - 1)]))) {
        text.resize(text.find_last_not_of(' ', remark - 1) + 1);
    }
    // Exponents in brackets would be taken for factors.
    for (const char digit : {'1', '2', '3', '4'}) {
        replaceAll(text, std::string("(-") + digit + ")", std::string("-") + digit);
        replaceAll(text, std::string("(") + digit + ")", std::string(1, digit));
        replaceAll(text, std::string("{-") + digit + "}", std::string("-") + digit);
    }
    replaceAll(text, "#", "1");
    return text;
}

/// The unit of a text; null if it is none. UDUNITS 2.2.28 loses a copy of the word at which it
/// gives up, a few bytes, which leak checks are told not to mind.
Unit parsed(ut_system* system, const std::string& text) {
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
    const __lsan::ScopedDisabler quiet;
#endif
#endif
    return Unit(ut_parse(system, text.c_str(), UT_UTF8));
}

/// The system of units, read once; null if its database is not installed.
ut_system* unitSystem() {
    ut_set_error_message_handler(&ut_ignore);
    static ut_system* const system = ut_read_xml(nullptr);
    return system;
}

}  // namespace

std::optional<Conversion> conversion(std::string_view from, std::string_view to) {
    if (from == to) return Conversion{};
    if (from.empty() || from.size() > kMaxLength) return {};
    static std::mutex mutex;
    const std::scoped_lock lock(mutex);
    ut_system* const system = unitSystem();
    if (system == nullptr) return {};
    Unit have = parsed(system, spelled(from, to));
    if (!have) have = parsed(system, lower(spelled(from, to)));  // "Kg/Kg"
    const Unit want = parsed(system, spelled(to, to));
    if (!have || !want || ut_are_convertible(have.get(), want.get()) == 0) return {};
    const Converter converter(ut_get_converter(have.get(), want.get()));
    if (!converter) return {};
    const double offset = cv_convert_double(converter.get(), 0.0);
    const double scale = cv_convert_double(converter.get(), 1.0) - offset;
    // Logarithmic and reciprocal units are no straight lines.
    const double third = cv_convert_double(converter.get(), 3.0);
    if (!std::isfinite(scale) || !std::isfinite(offset) || scale == 0.0 ||
        !(std::abs(third - (3.0 * scale + offset)) <= 1e-9 * std::abs(third) + 1e-300)) {
        return {};
    }
    return Conversion{scale, offset};
}

}  // namespace shared
