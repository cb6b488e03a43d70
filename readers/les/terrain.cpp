// terrain.cpp: interface heights as derived variables.
#include "readers/les/terrain.h"

#include <algorithm>
#include <cmath>

#include "readers/les/levels.h"

namespace les {
namespace {

constexpr double kFlatM = 0.01;  // below this terrain is rounding

/// Whether a stored plane is `heightM` everywhere.
bool isLevel(const Contents& contents, std::size_t variable, std::size_t level, double heightM) {
    const auto& size = contents.description.variables[variable].size;
    const Box box{
        {0, 0, level},
        {static_cast<std::size_t>(size[0]), static_cast<std::size_t>(size[1]), level + 1}};
    std::vector<float> values(box.count());
    contents.sources[variable].stored(0, box, values, [](double) {});
    const double tolerance = kFlatM + 1e-5 * std::abs(heightM);
    return std::ranges::all_of(values, [&](float value) {
        return std::abs(static_cast<double>(value) - heightM) <= tolerance;
    });
}

/// Position between two centres (0 and 1) at which an interface lies.
struct Between {
    std::size_t below;
    double part;
};

std::vector<Between> placesOf(const std::vector<double>& interfacesM) {
    const std::vector<double> centres = centresOf(interfacesM);
    const std::size_t n = centres.size();
    std::vector<Between> places;
    for (std::size_t k = 0; k <= n; ++k) {
        const std::size_t below = std::min(k == 0 ? 0 : k - 1, n - 2);
        places.push_back(
            {below, (interfacesM[k] - centres[below]) / (centres[below + 1] - centres[below])});
    }
    return places;
}

Derived fromCells(const Contents& contents, std::size_t cells, std::optional<std::size_t> ground) {
    const std::size_t n = contents.interfacesM.size() - 1;
    Derived derived;
    derived.inputs = {{cells, -1, 0, n - 2}, {cells, 0, 1, n - 1}};
    if (ground) derived.inputs.push_back({*ground});
    derived.value = [places = placesOf(contents.interfacesM)](std::span<const double> of,
                                                              std::size_t k) {
        if (k == 0 && of.size() > 2) return of[2];
        return of[0] + places[k].part * (of[1] - of[0]);
    };
    return derived;
}

Derived fromGround(const Contents& contents, std::size_t ground) {
    Derived derived;
    derived.inputs = {{ground}};
    derived.value = [nominal = contents.interfacesM](std::span<const double> of, std::size_t k) {
        return of[0] + nominal[k] * (nominal.back() - of[0]) / nominal.back();
    };
    return derived;
}

}  // namespace

bool isFlat(const Contents& contents, const Terrain& terrain) {
    if (!terrain.cellHeight) return !terrain.ground || isLevel(contents, *terrain.ground, 0, 0.0);
    const std::vector<double> centres = centresOf(contents.interfacesM);
    return isLevel(contents, *terrain.cellHeight, 0, centres.front()) &&
           isLevel(contents, *terrain.cellHeight, centres.size() - 1, centres.back());
}

void addTerrainHeights(Contents& contents, const Terrain& terrain) {
    neph::plugin::Variable variable{"interface_height", "altitude", "m",
                                    "height of layer interfaces", NEPH_ROLE_INTERFACE_HEIGHT};
    variable.size = contents.description.size;
    ++variable.size[2];
    if (terrain.cellHeight) {
        contents.addDerived(std::move(variable),
                            fromCells(contents, *terrain.cellHeight, terrain.ground));
        return;
    }
    contents.addDerived(std::move(variable), fromGround(contents, *terrain.ground));
    contents.description.notes.emplace_back(
        "Levels follow the terrain: their heights are computed from zs by the transform of "
        "Gal-Chen and Somerville, which is CM1's.");
}

}  // namespace les
