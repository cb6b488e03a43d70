// microhh_air.cpp: reads the two files, which are told by their sizes.
//
// thermo_basestate contains, with n levels: θ_l and q_t on n levels; then θ_v, pressure, Exner
// function and density, each on n levels and on n + 1 interfaces. rhoref contains only the last.
#include "readers/les/microhh_air.h"

#include <algorithm>
#include <filesystem>

#include "readers/les/numbers.h"

namespace les {

MicrohhAir readMicrohhAir(const std::string& folder, std::size_t bytesEach, bool swapped,
                          std::size_t levels) {
    const auto numbersOf = [&](const char* name, std::size_t count) -> std::vector<double> {
        const std::string path = (std::filesystem::path(folder) / name).string();
        if (fileSize(path) != count * bytesEach) return {};
        return readReals(path, bytesEach, swapped, count);
    };
    const auto profile = [&](const std::vector<double>& numbers, std::size_t first) {
        const auto start = numbers.begin() + static_cast<std::ptrdiff_t>(first);
        return std::vector<double>(start, start + static_cast<std::ptrdiff_t>(levels));
    };
    const std::size_t n = levels;
    const auto base = numbersOf("thermo_basestate.0000000", 10 * n + 4);
    const auto density = numbersOf("rhoref.0000000", 2 * n + 1);
    MicrohhAir air;
    if (!density.empty()) air.densityKgPerM3 = profile(density, 0);
    if (base.empty()) return air;
    if (density.empty()) air.densityKgPerM3 = profile(base, 8 * n + 3);
    air.pressurePa = profile(base, 4 * n + 1);
    const auto vapour = profile(base, n);
    const auto virtualTheta = profile(base, 2 * n);
    const auto exner = profile(base, 6 * n + 2);
    for (std::size_t k = 0; k < n; ++k) {
        // θ_v = θ (1 + (R_v/R_d − 1) q), R_v = 461.5, R_d = 287.04 in MicroHH's constants.h
        air.temperatureK.push_back(virtualTheta[k] * exner[k] /
                                   (1.0 + (461.5 / 287.04 - 1.0) * std::max(vapour[k], 0.0)));
    }
    return air;
}

}  // namespace les
