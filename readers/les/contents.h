// contents.h: the common result of parsing any format of LES output: a description and, for every
// variable, the source of its values.
#pragma once
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/plugin/reader_plugin.h"
#include "readers/les/air.h"
#include "readers/les/box.h"

namespace les {

/// A value that is computed from the values of other variables of the same column.
struct Derived {
    /// A variable, at level clamp(level + shift, least, most). Planes and profiles have the same
    /// value at all levels or in all columns.
    struct Input {
        std::size_t variable = 0;
        std::ptrdiff_t shift = 0;
        std::size_t least = 0, most = std::numeric_limits<std::size_t>::max();
    };
    std::vector<Input> inputs;
    std::function<double(std::span<const double> values, std::size_t level)> value;
};

/// The source of a variable's values: exactly one of `stored`, `profile` and `derived`.
struct Source {
    /// In a file: reads a box at a time, in the units of the description, NaN where missing. Throws
    /// Error, as where the variable lacks that time, and Cancelled.
    std::function<void(std::size_t time, const Box&, std::span<float> values, const Tick&)>
        stored{};
    /// One value per level, bottom to top, the same at all times.
    std::vector<float> profile{};
    std::optional<Derived> derived{};
    /// Number of levels in the file; the levels above are zero. 0: all levels are stored.
    std::size_t storedLevels = 0;
};

/// Everything that is known about a data set after parsing, before any field is read.
struct Contents {
    neph::plugin::Description description;
    std::vector<Source> sources;      ///< parallel to description.variables
    std::vector<double> interfacesM;  ///< one more than there are levels, increasing
    /// Variables without a role of their own from which the state of the air is derived.
    std::optional<std::size_t> potentialTemperature, vapour;
    GasConstants gas;

    void add(neph::plugin::Variable variable, Source source);
    void addDerived(neph::plugin::Variable variable, Derived derived);
    std::optional<std::size_t> find(NephRole role) const;

    /// Notes that the model has periodic sides, and what shows the endless field.
    void notePeriodicSides(const std::string& model);

    /// Adds the sum of variables of one role and species. They keep their names and lose the role.
    void addSum(const std::vector<std::size_t>& parts);

    /// Adds interface heights that are the same everywhere, unless heights are there already, and
    /// pressure, temperature and density of the air that are not stored: derived if possible,
    /// otherwise from the standard atmosphere, which a note reports. Vapour then loses its role:
    /// with such air it has no humidity. Call this last.
    void completeAir();

  private:
    /// Gives a variable that is computed a name of its own, and its description as the reason for
    /// its role where none is stated.
    void settle(neph::plugin::Variable& variable) const;
    void addProfile(neph::plugin::Variable variable, const std::vector<double>& values);
    void addStandard(neph::plugin::Variable variable, double Air::*part);
    void addTemperature();
    void addDensity();
    void withoutHumidity();
};

/// Throws Error if two variables have the same name.
std::unique_ptr<neph::plugin::File> makeFile(Contents contents);

}  // namespace les
