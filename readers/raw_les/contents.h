// contents.h: the common result of parsing any of the three raw formats: a description and, for
// every variable, the source of its values.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/plugin/reader_plugin.h"
#include "readers/raw_les/air.h"
#include "readers/raw_les/raw_values.h"

namespace raw {

/// The source of a variable's values: exactly one of `stored`, `profile` and `derived`.
struct Source {
    /// In a file: returns the location at a time. Throws Error if the variable lacks that time.
    std::function<RawField(std::size_t time)> stored{};
    /// One value per level, bottom to top, the same at all times.
    std::vector<float> profile{};
    /// Computed from other variables of the same file.
    enum class Derived { none, temperature, density } derived = Derived::none;
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
    std::optional<std::size_t> find(NephRole role) const;

    /// Adds interface heights, and those of pressure, temperature and density of the air that are
    /// not stored: derived if possible, otherwise from the standard atmosphere, which a note
    /// reports. Call this last.
    void completeAir();

  private:
    void addProfile(neph::plugin::Variable variable, const std::vector<double>& values);
};

/// Throws Error if two variables have the same name.
std::unique_ptr<neph::plugin::File> makeFile(Contents contents);

}  // namespace raw
