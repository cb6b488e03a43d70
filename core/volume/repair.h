// repair.h: corrects mixing ratios that cannot be real, and reports it; refuses fields that were
// not read right.
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/dataset/dataset.h"
#include "core/grid/grid.h"

namespace neph {

/// More condensate than this in a kg of air cannot be real: the heaviest hail of storms is about
/// 0.03 kg/kg.
inline constexpr float kMostRatioKgPerKg = 0.1f;

/// The corrections made in one field, and what kind of values it holds.
struct Repairs {
    std::size_t values = 0;      ///< looked at
    std::size_t negative = 0;    ///< a little below zero: the noise of a model
    std::size_t missing = 0;     ///< NaN
    std::size_t impossible = 0;  ///< infinite, or further from zero than kMostRatioKgPerKg
    float smallest = 0.0f;       ///< kg/kg, of the negative ones
    bool allZero = true;         ///< no value above zero remains

    std::size_t condensate = 0;  ///< possible, and enough to be seen
    std::size_t swappable = 0;   ///< of the impossible: possible with the bytes swapped
    std::size_t thousandth = 0;  ///< of the impossible: possible as g/kg
    std::size_t vanishing = 0;   ///< not zero, but far below what any model means
    std::size_t hidden = 0;      ///< of the vanishing: condensate with the bytes swapped
    float mark = 0.0f;           ///< an impossible value, the commonest as far as is known,
    std::size_t marked = 0;      ///< and how often it is there

    /// Adds the corrections of another part of the field.
    Repairs& operator+=(const Repairs& part);
    /// Whether (nearly) all impossible values are one: a mark for missing values that the file does
    /// not state.
    bool hasMark() const;
    /// Whether the field has no value at all.
    bool nothing() const;
};

/// Sets negative, missing and impossible mixing ratios (kg/kg) to zero; counts those of the rows
/// from `countedFrom` on.
Repairs repair(Array3f& mixingRatio, int countedFrom = 0);

/// Throws Error, with the likely cause, if so many of a whole field's values are impossible that it
/// cannot have been read right. docs/readers.md
void requirePlausible(const Repairs& repairs, const Dataset& dataset, int time,
                      std::string_view variable);

/// Throws Error if none of the fields has any value.
void requireValues(std::span<const Repairs> fields, const Dataset& dataset, int time);

/// One sentence for each kind of correction.
std::vector<std::string> describe(const Repairs& repairs, std::string_view variable);

}  // namespace neph
