// cm1.h: knowledge of CM1: the model times in cm1out_metadata, and the microphysics and the kind of
// grid in namelist.input.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/plugin/reader_plugin.h"

namespace raw {

/// Model time of each output in seconds, from cm1out_metadata in `folder`; nothing if it is absent
/// or is not as CM1 writes it. CM1's tdef cannot be used: it only counts outputs. `swapped`: where
/// its descriptor does not state a byte order.
std::optional<std::vector<double>> cm1Seconds(const std::string& folder, bool swapped);

/// Microphysics of a run.
struct Cm1Run {
    std::string scheme;
    NephMicrophysics microphysics = NEPH_MICROPHYSICS_UNKNOWN;
    double cloudDropletsPerM3 = 0.0;
    bool hail = false;  ///< the variable qg holds hail rather than graupel
    bool terrain = false, axisymmetric = false;
    /// Names of the hydrometeors that the scheme has; none for an unknown scheme.
    std::vector<std::string> hydrometeors;
};
/// `text` is namelist.input. Entries that are absent or invalid leave their defaults.
Cm1Run parseCm1Namelist(std::string_view text);

}  // namespace raw
