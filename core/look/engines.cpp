// engines.cpp: counts of an engine's work, in words.
#include "core/look/engines.h"

#include <fmt/format.h>

namespace neph {

std::string countText(int count, std::string_view unit) {
    return fmt::format("{} {}{}", count, unit, count == 1 ? "" : "s");
}

}  // namespace neph
