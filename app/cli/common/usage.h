// usage.h: faults of the command line itself, and the values of options from their text.
#pragma once
#include <charconv>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/base/error.h"

namespace neph {

/// A fault of the command line itself; exit status 2.
class UsageError : public Error {
  public:
    using Error::Error;
};

/// Runs `work`; an Error that it throws becomes a fault of `where`, an option as typed.
template <typename Work>
auto asUsage(const std::string& where, const Work& work) {
    try {
        return work();
    } catch (const Error& error) {
        ErrorParts parts = error.parts();
        parts.where = where;
        throw UsageError(parts);
    }
}

[[noreturn]] void refuseNumber(std::string_view option, const std::string& text, bool whole,
                               double lo, double hi);

/// A number from `lo` to `hi`. Throws UsageError.
template <typename Number>
Number parseNumber(std::string_view option, const std::string& text, Number lo, Number hi) {
    Number value{};
    const char* const end = text.data() + text.size();
    const auto [stop, fault] = std::from_chars(text.data(), end, value);
    if (fault != std::errc{} || stop != end || !(value >= lo && value <= hi)) {
        refuseNumber(option, text, std::is_integral_v<Number>, static_cast<double>(lo),
                     static_cast<double>(hi));
    }
    return value;
}

}  // namespace neph
