// air.h: from which stored variables heights, pressure, temperature and density of the air follow:
// history files, restart files and processed output have different ones.
#pragma once
#include <string>
#include <vector>

#include "readers/wrf_netcdf/term.h"

namespace wrf {

/// What a sum of stored variables means as heat.
enum class Heat { temperature, theta, thetaMinus300, moistThetaMinus300 };

struct AirSources {
    std::vector<Term> height;    ///< summed: geopotential in m2 s-2, or height in m
    bool geopotential = true;    ///< else height
    bool onInterfaces = true;    ///< else at the centres of cells
    std::vector<Term> pressure;  ///< summed, Pa
    std::vector<Term> heat;      ///< summed, K
    Heat kind = Heat::thetaMinus300;
    std::vector<Term> vapour;   ///< one, kg kg-1; none: dry air
    std::vector<Term> terrain;  ///< one, m: the lowest interface, where heights are at centres
    /// How each follows, for descriptions: "(PH+PHB)/9.81".
    std::string heightText, pressureText, temperatureText;
};

/// Throws Failure that names the first variable without which no image can be made.
AirSources findAir(const Tiles& tiles, UnitNotes& unitNotes, std::vector<std::string>& notes);

}  // namespace wrf
