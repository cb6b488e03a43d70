// microhh_air.h: MicroHH's reference air: moist, horizontally uniform.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace les {

/// One value per level; empty where the files are not there.
struct MicrohhAir {
    std::vector<double> densityKgPerM3, pressurePa, temperatureK;
};
/// From rhoref.0000000 and thermo_basestate.0000000 of a case with `levels` levels, whose numbers
/// have `bytesEach` bytes.
MicrohhAir readMicrohhAir(const std::string& folder, std::size_t bytesEach, bool swapped,
                          std::size_t levels);

}  // namespace les
