// names.h: the known name nearest to a mistyped one.
#pragma once
#include <span>
#include <string_view>

namespace neph {

/// The candidate with the smallest edit distance, or empty when none is within a third of the
/// name's length (at least 2).
std::string_view nearestName(std::string_view name, std::span<const std::string_view> candidates);

}  // namespace neph
