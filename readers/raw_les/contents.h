// contents.h: what the three raw formats have in common once their descriptors are understood: a
// description and, for every variable, where its values come from.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/plugin/reader_plugin.h"
#include "readers/raw_les/air.h"
#include "readers/raw_les/raw_values.h"

namespace raw {

/// Where the values of a variable come from: exactly one of these.
struct Source {
    /// Stored: where they lie at a time. Throws Error where the variable lacks that time.
    std::function<RawField(std::size_t time)> stored{};
    /// The same everywhere on a level and at all times, bottom to top.
    std::vector<float> profile{};
    /// Derived from other variables of the same file.
    enum class Derived { none, temperature, density } derived = Derived::none;
    /// Levels that are stored; those above are zero. 0: all.
    std::size_t storedLevels = 0;
};

struct Contents {
    neph::plugin::Description description;
    std::vector<Source> sources;  ///< one for each variable of the description
    std::vector<double> interfacesM;
    /// Stored variables that have no role of their own but that air is derived from.
    std::optional<std::size_t> potentialTemperature, vapour;
    GasConstants gas;

    void add(neph::plugin::Variable variable, Source source);
    std::optional<std::size_t> find(NephRole role) const;

    /// Adds interface heights, and the pressure, temperature and density of the air as far as they
    /// are not stored: derived, or else the standard atmosphere's, which a note says. Call last.
    void completeAir();

  private:
    void addProfile(neph::plugin::Variable variable, const std::vector<double>& values);
};

/// Description and reads. Throws Error where one name stands for two variables.
std::unique_ptr<neph::plugin::File> makeFile(Contents contents);

}  // namespace raw
