// quantity.h: the quantities that the reader understands: their SI units and which values are
// possible.
#pragma once
#include <optional>
#include <string_view>

#include "readers/shared/units.h"

namespace les {

enum class Quantity { ratio, density, pressure, temperature, radius, number, length, speed };

/// Conversion from `unit`, as a model spells it, to the SI unit of `quantity`; nothing for a unit
/// of another kind. Where case matters to UDUNITS and the unit fails as written, lower case is
/// tried.
std::optional<shared::Conversion> toSi(Quantity quantity, std::string_view unit);

/// SI unit in the notation of CF, for the host.
const char* siUnit(Quantity quantity);
/// Examples of accepted units, for messages; the first word is the usual one.
const char* acceptedUnits(Quantity quantity);

/// Whether a value other than zero can be one of a model's, in SI. Temperatures may be potential
/// ones. Numbers in the wrong byte order rarely are.
bool isPossible(Quantity quantity, double value);

}  // namespace les
