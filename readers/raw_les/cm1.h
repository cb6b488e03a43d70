// cm1.h: what CM1 puts beside its GrADS output: actual times, the namelist, and what its variables
// mean.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "readers/raw_les/contents.h"

namespace raw {

/// What a variable of a GrADS file is taken for, by its name.
struct KnownVariable {
    std::string_view name;  ///< in lower case
    NephRole role;
    NephSpecies species;
    std::optional<Quantity> quantity;  ///< its unit must be one of these
    std::string_view standardName;
};
const KnownVariable* findKnown(std::string_view name);

/// Names of hydrometeors, for messages.
std::string knownHydrometeors();

/// Seconds of each time, from cm1out_metadata beside the descriptor; nothing where there is none or
/// it is not what CM1 writes.
std::optional<std::vector<double>> cm1Seconds(const std::string& folder);

/// From the text of namelist.input: scheme, droplet number, whether the large ice is hail.
struct Cm1Run {
    std::string scheme;
    NephMicrophysics microphysics = NEPH_MICROPHYSICS_UNKNOWN;
    double cloudDropletsPerM3 = 0.0;
    bool hail = false;
};
Cm1Run parseCm1Namelist(std::string_view text);

}  // namespace raw
