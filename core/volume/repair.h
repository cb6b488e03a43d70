// repair.h: corrects mixing ratios that cannot be real, and reports it.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/grid/grid.h"

namespace neph {

/// The corrections made in one field.
struct Repairs {
    std::size_t negative = 0;    ///< values below zero
    std::size_t missing = 0;     ///< NaN and infinities
    std::size_t impossible = 0;  ///< above 1 kg/kg: a fill value that the reader could not know
    float smallest = 0.0f;       ///< kg/kg, of the negative ones
    bool allZero = true;         ///< no value above zero remains

    /// Adds the corrections of another part of the field.
    Repairs& operator+=(const Repairs& part);
};

/// Sets negative, missing and impossible mixing ratios (kg/kg) to zero.
Repairs repair(Array3f& mixingRatio);

/// One sentence for each kind of correction.
std::vector<std::string> describe(const Repairs& repairs, std::string_view variable);

}  // namespace neph
