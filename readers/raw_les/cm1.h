// cm1.h: knowledge of CM1: the model times in cm1out_metadata, and the microphysics and the kind of
// grid in namelist.input.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/plugin/reader_plugin.h"

namespace raw {

/// Of each output, from cm1out_metadata.
struct Cm1Times {
    std::vector<double> seconds;  ///< model time
    /// How far the grid has moved over the ground (domainlocx, domainlocy); empty where it is not
    /// written, as of grids that stand still.
    std::array<std::vector<double>, 2> offsetM;
};
/// From cm1out_metadata in `folder`; nothing if it is absent or is not as CM1 writes it. CM1's tdef
/// cannot be used: it only counts outputs. `swapped`: where its descriptor does not state a byte
/// order.
std::optional<Cm1Times> cm1Times(const std::string& folder, bool swapped);

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
/// How far the grid has moved at each output, metres along x and y, since model time 0: as the
/// metadata state it, else at the speed of the namelist.
std::vector<std::array<double, 2>> cm1Offsets(const Cm1Times& times, const Cm1Run& run);

/// `text` is namelist.input. Entries that are absent or invalid leave their defaults.
Cm1Run parseCm1Namelist(std::string_view text);

}  // namespace raw
