// cm1.h: the model times of a run of CM1, which it writes into cm1out_metadata.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "readers/les/cm1_run.h"

namespace les {

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

/// How far the grid has moved at each output, metres along x and y, since model time 0: as the
/// metadata state it, else at the speed of the namelist.
std::vector<std::array<double, 2>> cm1Offsets(const Cm1Times& times, const Cm1Run& run);

}  // namespace les
