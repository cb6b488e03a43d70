// contents.h: which fields of a file make up the volume: one grid, one kind of levels, the times.
#pragma once
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "readers/grib/grid.h"
#include "readers/grib/product.h"

namespace grib {

inline constexpr std::size_t kNoField = std::numeric_limits<std::size_t>::max();

/// Indices into the fields of the file by [time][level]; kNoField where the file has none.
using Stack = std::vector<std::vector<std::size_t>>;

struct Moment {
    double seconds = 0.0;  ///< from 0001-01-01
    std::string label;     ///< "2021-08-14_18:00:00"
};

struct Contents {
    Grid grid;                   ///< of all fields below
    unsigned surface = kHybrid;  ///< or kIsobaric
    std::vector<double> levels;  ///< of that surface; isobaric ones from the ground up
    std::vector<Moment> times;
    std::map<Parameter, Stack> stacks;  ///< what lies on the levels
    /// Fields at the ground by time; kNoField where there is none.
    std::vector<std::size_t> groundHeight, groundPressure;
    /// The first of these that has every level.
    Parameter height{}, temperature{}, pressure{}, vapour{};
    bool hasVapour = false;
    Product first;  ///< one of the fields, for what they share
    std::vector<std::string> notes;

    const Stack* find(const Parameter& parameter) const {
        const auto found = stacks.find(parameter);
        return found == stacks.end() ? nullptr : &found->second;
    }
};

/// Throws Failure if the grid cannot be read, or no levels have height, pressure and temperature.
Contents contentsOf(const Inventory& inventory);

}  // namespace grib
