// cm1_run.h: knowledge of CM1: the microphysics and the kind of grid of a run.
#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/plugin/reader_plugin.h"

namespace les {

/// Microphysics of a run.
struct Cm1Run {
    std::string scheme;
    NephMicrophysics microphysics = NEPH_MICROPHYSICS_UNKNOWN;
    double cloudDropletsPerM3 = 0.0;
    bool hail = false;  ///< the variable qg holds hail rather than graupel
    bool terrain = false, axisymmetric = false;
    std::array<double, 2> speedMPerS{};  ///< of the grid over the ground: umove, vmove if imove = 1
    /// Names of the hydrometeors that the scheme has; none for an unknown scheme.
    std::vector<std::string> hydrometeors;
};
/// The scheme with a number, of which a file says no more.
Cm1Run cm1RunOf(int ptype);
/// `text` is namelist.input. Entries that are absent or invalid leave their defaults.
Cm1Run parseCm1Namelist(std::string_view text);

}  // namespace les
