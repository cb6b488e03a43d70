// cm1.h: knowledge of CM1: the meaning of its variable names, the model times in cm1out_metadata,
// and the microphysics in namelist.input.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "readers/raw_les/contents.h"

namespace raw {

/// Meaning of a variable of a GrADS file, derived from its name.
struct KnownVariable {
    std::string_view name;  ///< in lower case
    NephRole role;
    NephSpecies species;
    std::optional<Quantity> quantity;  ///< its unit must be one of these
    std::string_view standardName;
};
/// Null for a name that is not in the table; case is ignored.
const KnownVariable* findKnown(std::string_view name);

/// Names of the known hydrometeors, for messages.
std::string knownHydrometeors();

/// Model time of each output in seconds, from cm1out_metadata in `folder`; nothing if it is absent
/// or is not as CM1 writes it. CM1's tdef cannot be used: it only counts outputs.
std::optional<std::vector<double>> cm1Seconds(const std::string& folder);

/// Microphysics of a run.
struct Cm1Run {
    std::string scheme;
    NephMicrophysics microphysics = NEPH_MICROPHYSICS_UNKNOWN;
    double cloudDropletsPerM3 = 0.0;
    bool hail = false;  ///< the variable qg holds hail rather than graupel
};
/// `text` is namelist.input. Entries that are absent or invalid leave their defaults.
Cm1Run parseCm1Namelist(std::string_view text);

}  // namespace raw
