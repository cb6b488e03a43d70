// transport_slab.h: media that tests solve.
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/transport/light_solver.h"

/// Sanitizers make a solution take minutes; the tests of every build without them run it.
#ifdef NEPH_SANITIZED
inline constexpr bool kSolvesInSeconds = false;
#else
inline constexpr bool kSolvesInSeconds = true;
#endif

/// A homogeneous layer between the ground and the top, of Henyey-Greenstein.
struct TransportSlab {
    double g = 0.0, opticalDepth = 1.0, singleScattering = 1.0;
    glm::ivec3 nodes{4, 4, 33};
    double widthToHeight = 1000.0;  ///< of the space between nodes

    static constexpr double kHeightM = 1000.0;

    neph::LightMedium medium() const {
        neph::LightMedium result;
        result.nodes = nodes;
        const double heightM = kHeightM / (nodes.z - 1);
        result.spacingM = {widthToHeight * heightM, widthToHeight * heightM, heightM};
        neph::LightClass light;
        light.extinctionPerM = neph::Array3f(nodes, static_cast<float>(opticalDepth / kHeightM));
        light.singleScattering = singleScattering;
        for (std::size_t l = 0; l < light.moments.size(); ++l) light.moments[l] = std::pow(g, l);
        result.classes.push_back(std::move(light));
        return result;
    }
};

/// Shares of what enters at the top of a medium with periodic sides over black ground.
struct TransportBudget {
    double reflected = 0.0, transmitted = 0.0;
};

/// Flux through the top follows from the moment of z, since no diffuse light comes from above.
inline TransportBudget transportBudget(const neph::LightSolver& solver) {
    const neph::TransportGrid& grid = solver.level().grid;
    const double sine = solver.scene().towardsSun.z;
    const double perMoment = std::sqrt(4.0 * std::numbers::pi / 3.0);
    const auto columns = static_cast<double>(grid.columnCount());
    TransportBudget budget;
    const std::size_t top = grid.nodeCount() - grid.columnCount();
    for (std::size_t i = 0; i < grid.columnCount(); ++i) {
        budget.reflected +=
            perMoment * static_cast<double>(solver.momentsAt(top + i)[2]) / sine / columns;
        budget.transmitted += (static_cast<double>(solver.groundFlux()[i]) / sine +
                               static_cast<double>(solver.beam()[i])) /
                              columns;
    }
    return budget;
}

struct ThickestNode {
    glm::dvec3 atM{0.0};
    double extinctionPerM = 0.0;  ///< scaled
};

inline ThickestNode thickestNode(const neph::LightSolver& solver) {
    const neph::TransportGrid& grid = solver.level().grid;
    const auto& extinctions = solver.level().extinctionPerM;
    const auto thickest = std::ranges::max_element(extinctions);
    const auto index = static_cast<int>(thickest - extinctions.begin());
    const glm::ivec3 n = grid.nodes;
    const glm::ivec3 node(index % n.x, index / n.x % n.y, index / n.x / n.y);
    return {glm::dvec3(node) * grid.spacingM, static_cast<double>(*thickest)};
}

/// Clouds with holes and thick cores; with a `scale` of 20 up to a scaled depth of 30 between
/// nodes.
inline neph::LightMedium transportClouds(const glm::ivec3& nodes, float scale = 1.0f) {
    neph::LightMedium medium;
    medium.nodes = nodes;
    medium.spacingM = {200.0, 250.0, 150.0};
    for (const double g : {0.85, 0.75}) {
        neph::LightClass light;
        light.extinctionPerM = neph::Array3f(nodes);
        for (std::size_t l = 0; l < light.moments.size(); ++l) light.moments[l] = std::pow(g, l);
        medium.classes.push_back(std::move(light));
    }
    for (int k = 1; k < nodes.z - 1; ++k) {
        for (int j = 0; j < nodes.y; ++j) {
            for (int i = 0; i < nodes.x; ++i) {
                const double wave = std::sin(0.9 * i) * std::cos(0.8 * j + 0.5) * std::sin(0.4 * k);
                if (wave <= 0.1) continue;
                medium.classes[0].extinctionPerM.at(i, j, k) =
                    scale * static_cast<float>(0.02 * wave);
                medium.classes[1].extinctionPerM.at(i, j, k) =
                    scale * static_cast<float>(0.005 * wave * wave);
            }
        }
    }
    return medium;
}
