// names.h: the meaning of variable names in descriptors: those of CM1, of WRF and of other models
// whose output is made into GrADS files.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/plugin/reader_plugin.h"
#include "readers/les/quantity.h"

namespace les {

/// What the reader itself does with a variable that has no role for the host.
enum class Use { none, potentialTemperature, vapour, ground, cellHeight };

/// Meaning of a variable, derived from its name.
struct KnownVariable {
    std::string_view name;  ///< in lower case
    NephRole role;
    NephSpecies species;
    Quantity quantity;  ///< its unit must be one of these
    std::string_view standardName{};
    Use use = Use::none;
};
/// The table of all names.
std::span<const KnownVariable> knownVariables();

/// Null for a name that is not in the table; case is ignored.
const KnownVariable* findKnown(std::string_view name);

/// Whether the amounts of two variables of one species add up: categories of ice, and hail that is
/// kept apart by size. Other pairs, such as ql and qc, are two names of the same water.
bool addsUp(std::string_view name);

/// Whether a name without a meaning here could be that of a hydrometeor, by its first letter. Water
/// vapour, total water and the rime within ice are not.
bool looksLikeHydrometeor(std::string_view name);

/// Names of hydrometeors, for messages.
std::string knownHydrometeors();

/// "cloud water", "rain" …, for messages.
const char* speciesName(NephSpecies species);

}  // namespace les
