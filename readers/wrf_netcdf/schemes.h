// schemes.h: WRF's microphysics schemes: their names, the hydrometeors they provide, and which size
// distributions they use.
#pragma once
#include <string>
#include <string_view>

#include "core/plugin/reader_abi.h"

namespace wrf {

/// A value of mp_physics.
struct Scheme {
    int number = -1;
    std::string_view name = "";
    /// The hydrometeors that it predicts, a letter each in the order of NephSpecies: c cloud, i
    /// ice, r rain, s snow, g graupel, h hail; empty where that is not known.
    std::string_view provides = "";
    NephMicrophysics microphysics = NEPH_MICROPHYSICS_UNKNOWN;
    /// One class for cloud water and ice, and one for rain and snow: which of the two, the
    /// temperature tells.
    bool onePhase = false;

    bool has(NephSpecies species) const {
        return provides.find("cirsgh"[species]) != std::string_view::npos;
    }
};

/// The scheme of a number; for an unknown one everything but the number is empty.
Scheme schemeOf(int mpPhysics);

/// For example "Thompson (MP_PHYSICS 8)"; "MP_PHYSICS 777" for an unknown number.
std::string schemeName(const Scheme& scheme);

}  // namespace wrf
