// usage.cpp: what is said of numbers that do not fit.
#include "app/cli/common/usage.h"

#include <fmt/format.h>

namespace neph {

void refuseNumber(std::string_view option, const std::string& text, bool whole, double lo,
                  double hi) {
    throw UsageError({std::string(option), "cannot take this value", text,
                      fmt::format("a {} from {} to {}", whole ? "whole number" : "number", lo, hi),
                      ""});
}

}  // namespace neph
