// transport_level.h: the scaled medium on one grid of the multigrid, and fields on it.
//
// Moments are kept for active nodes only: those with extinction and their neighbours. Outside the
// scatterers light just passes through.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/transport/light_medium.h"
#include "core/transport/row_span.h"

namespace neph {

struct TransportGrid {
    glm::ivec3 nodes{0};
    glm::dvec3 spacingM{0.0};
    bool periodicSides = false;

    std::size_t nodeCount() const { return columnCount() * static_cast<std::size_t>(nodes.z); }
    std::size_t columnCount() const {
        return static_cast<std::size_t>(nodes.x) * static_cast<std::size_t>(nodes.y);
    }
    std::size_t index(int x, int y, int z) const {
        return static_cast<std::size_t>(x) +
               static_cast<std::size_t>(nodes.x) *
                   (static_cast<std::size_t>(y) +
                    static_cast<std::size_t>(nodes.y) * static_cast<std::size_t>(z));
    }
    bool periodic(int axis) const { return periodicSides && axis < 2; }
    /// How far apart neighbours along each axis are in an array of all nodes.
    std::array<std::size_t, 3> steps() const {
        return {1, static_cast<std::size_t>(nodes.x), columnCount()};
    }
};

/// The other two axes of slices across `axis`: along their rows, and from row to row.
constexpr std::array<int, 2> sliceAxes(int axis) {
    return {axis == 0 ? 1 : 0, axis == 2 ? 1 : 2};
}

/// Moments of radiance at active nodes and irradiance from above, without beam, at the ground.
struct LightField {
    std::vector<float> moments;     ///< those of one node side by side
    std::vector<float> groundFlux;  ///< x fastest
};

/// Of two fields of one level.
void addTo(LightField& sum, const LightField& term);

struct TransportLevel {
    TransportGrid grid;
    int momentCount = kBroadMoments;
    int degreeCount = kBroadDegrees;
    std::vector<float> extinctionPerM;  ///< scaled, of every node: what light meets between nodes
    std::vector<float> thickness;       ///< of every node, on the finest grid: `lightThickness`
    std::vector<std::int32_t> place;    ///< of every node among the active ones, or -1
    /// Scattering over extinction times chi'_l, degreeCount of each active node.
    std::vector<float> albedo;
    std::size_t activeCount = 0;
    /// Of slices across each axis: where the active nodes of a row are, row by row.
    std::array<std::vector<RowSpan>, 3> activeRows;

    // Empty unless nodes are optically thick. docs/transport.md
    std::vector<float> aroundPerM;  ///< scaled, of each active node: the mean around it
    /// Of every node: which share of l = 0 follows from its energy balance.
    std::vector<float> balanced;

    bool thick() const { return !balanced.empty(); }
    /// What a node counts in means.
    float weightAt(std::size_t node) const {
        if (!thick()) return extinctionPerM[node];
        return place[node] < 0 ? 0.0f : aroundPerM[static_cast<std::size_t>(place[node])];
    }
    /// Of an active node.
    float* albedoAt(std::size_t node);
    const float* albedoAt(std::size_t node) const {
        return &albedo[static_cast<std::size_t>(place[node]) *
                       static_cast<std::size_t>(degreeCount)];
    }
    /// Finds the active nodes from the extinctions, and makes room for their albedos.
    void numberActive();
    /// The same with all nodes active.
    void numberAll();
    RowSpan activeRow(int axis, int slice, int row) const {
        const auto rows = static_cast<std::size_t>(grid.nodes[sliceAxes(axis)[1]]);
        return activeRows[static_cast<std::size_t>(axis)]
                         [static_cast<std::size_t>(slice) * rows + static_cast<std::size_t>(row)];
    }
    void setBalanced();

    LightField emptyField() const;
    std::size_t bytes() const;

  private:
    void numberMarked();
};

/// TransportLevel::thickness of the finest level alone.
std::vector<float> nodeThickness(const LightMedium& medium, bool periodicSides, bool aligned);

/// Thick where light is scattered more often than 4 times between two nodes.
TransportLevel finestLevel(const LightMedium& medium, bool periodicSides, bool aligned,
                           int momentCount);

/// Whether half the resolution has fewer nodes.
bool canCoarsen(const TransportGrid& grid);

/// At half the resolution where an axis can be halved.
TransportLevel coarsened(const TransportLevel& fine);

/// `after` - `before` of a fine field, on the coarse grid: means weighted by extinction.
LightField restricted(const TransportLevel& fine, const TransportLevel& coarse,
                      const LightField& after, const LightField& before);

/// Adds `part` of a coarse correction to a fine field, trilinear between nodes.
void addProlonged(const TransportLevel& fine, const TransportLevel& coarse,
                  const LightField& correction, float part, LightField& field);

}  // namespace neph
