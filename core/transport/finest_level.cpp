// finest_level.cpp: scales the medium for the finest grid.
//
// Thick nodes are described by means around them, integrals with the function that is 1 at the node
// and 0 at its neighbours: so the nodes beside a cloud scatter what reaches its edge. They are as
// thick as their thickest neighbour: where scattering is isotropic on one side of an edge and not
// on the other, energy is lost.
#include <algorithm>
#include <utility>

#include "core/transport/grid_loops.h"
#include "core/transport/transport_level.h"

namespace neph {
namespace {

using Extinctions = std::vector<const std::vector<float>*>;

/// Scaled optics of all classes together.
struct MixedOptics {
    double extinctionPerM = 0.0, absorptionPerM = 0.0;
    std::array<double, kAlignedDegrees> scatteringPerM{};
};

MixedOptics mixedAt(const LightMedium& medium, const Extinctions& extinctions, std::size_t node,
                    bool aligned, double thickness) {
    MixedOptics mixed;
    for (std::size_t s = 0; s < medium.classes.size(); ++s) {
        const ScaledOptics scaled = scaledOptics(
            medium.classes[s], static_cast<double>((*extinctions[s])[node]), aligned, thickness);
        mixed.extinctionPerM += scaled.extinctionPerM;
        mixed.absorptionPerM += scaled.absorptionPerM;
        for (std::size_t l = 0; l < mixed.scatteringPerM.size(); ++l) {
            mixed.scatteringPerM[l] += scaled.scatteringPerM[l];
        }
    }
    return mixed;
}

/// (1, 4, 1) / 6 along each axis, mirrored at open sides.
std::vector<float> meansAround(const TransportGrid& grid, std::vector<float> values) {
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<float> means(values.size());
        forEachNode(grid, [&](const glm::ivec3& node, std::size_t index) {
            const auto [before, at, after] = beside(grid, axis, node[axis]);
            const auto valueAt = [&](int place) {
                glm::ivec3 other = node;
                other[axis] = place;
                return values[grid.index(other.x, other.y, other.z)];
            };
            means[index] = (valueAt(before < 0 ? after : before) + 4.0f * valueAt(at) +
                            valueAt(after < 0 ? before : after)) /
                           6.0f;
        });
        values = std::move(means);
    }
    return values;
}

/// Of a node and all 26 beside it.
std::vector<float> mostAround(const TransportGrid& grid, std::vector<float> values) {
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<float> most(values.size());
        forEachNode(grid, [&](const glm::ivec3& node, std::size_t index) {
            for (const int place : beside(grid, axis, node[axis])) {
                if (place < 0) continue;
                glm::ivec3 other = node;
                other[axis] = place;
                const float value = values[grid.index(other.x, other.y, other.z)];
                most[index] = std::max(most[index], value);
            }
        });
        values = std::move(most);
    }
    return values;
}

std::vector<float> thicknessOf(const LightMedium& medium, const Extinctions& extinctions) {
    std::vector<float> thickness(extinctions.empty() ? 0 : extinctions.front()->size());
    for (std::size_t node = 0; node < thickness.size(); ++node) {
        double sum = 0.0;
        for (const auto* extinction : extinctions) sum += static_cast<double>((*extinction)[node]);
        thickness[node] = static_cast<float>(lightThickness(medium, sum));
    }
    return thickness;
}

void setExtinction(const LightMedium& medium, const Extinctions& extinctions, bool aligned,
                   TransportLevel& level) {
    level.extinctionPerM.resize(level.grid.nodeCount());
    for (std::size_t node = 0; node < level.extinctionPerM.size(); ++node) {
        const auto thickness = static_cast<double>(level.thickness[node]);
        level.extinctionPerM[node] = static_cast<float>(
            mixedAt(medium, extinctions, node, aligned, thickness).extinctionPerM);
    }
}

/// Exactly 1 for l = 0 without absorption, as the balance of thick nodes requires.
void setAlbedo(const MixedOptics& mixed, int degrees, float* albedo) {
    albedo[0] = static_cast<float>(1.0 - mixed.absorptionPerM / mixed.extinctionPerM);
    for (int l = 1; l < degrees; ++l) {
        albedo[l] = static_cast<float>(mixed.scatteringPerM[static_cast<std::size_t>(l)] /
                                       mixed.extinctionPerM);
    }
}

/// Whether more than a few of the nodes with particles are optically thick.
bool needsBalance(const TransportLevel& level) {
    constexpr double kMostBetweenNodes = 4.0, kFew = 0.03;
    const auto thickPerM =
        static_cast<float>(kMostBetweenNodes / thicknessLengthM(level.grid.spacingM));
    const auto above = [&](float least) {
        return static_cast<double>(
            std::ranges::count_if(level.extinctionPerM, [&](float perM) { return perM > least; }));
    };
    return above(thickPerM) > kFew * above(0.0f);
}

/// No greater scaled depth is between two nodes: nothing gets through it anyway, and somewhere
/// between 50 and 150 cycles begin to diverge.
constexpr double kDeepest = 25.0;

/// The extinctions of the classes, less where a node of `level` would be deeper than that; empty
/// where none would.
std::vector<std::vector<float>> limitedExtinctions(const Extinctions& extinctions,
                                                   const TransportLevel& level) {
    const auto most = static_cast<float>(kDeepest / thicknessLengthM(level.grid.spacingM));
    const std::vector<float>& scaled = level.extinctionPerM;
    if (std::ranges::none_of(scaled, [&](float perM) { return perM > most; })) return {};
    std::vector<std::vector<float>> limited;
    for (const auto* values : extinctions) {
        limited.push_back(*values);
        for (std::size_t i = 0; i < scaled.size(); ++i) {
            if (scaled[i] > most) limited.back()[i] *= most / scaled[i];
        }
    }
    return limited;
}

/// What all parts of a level start from.
struct Thickness {
    explicit Thickness(const LightMedium& medium, bool aligned, TransportLevel& level) {
        for (const LightClass& light : medium.classes) {
            atNodes.push_back(&light.extinctionPerM.values);
        }
        level.thickness = thicknessOf(medium, atNodes);
        level.thickness.resize(level.grid.nodeCount());
        setExtinction(medium, atNodes, aligned, level);
        thick = needsBalance(level);
        limited = limitedExtinctions(atNodes, level);
        for (std::size_t c = 0; c < limited.size(); ++c) atNodes[c] = &limited[c];
        if (!thick) {
            if (!limited.empty()) setExtinction(medium, atNodes, aligned, level);
            return;
        }
        for (const auto* values : atNodes) means.push_back(meansAround(level.grid, *values));
        for (const auto& values : means) around.push_back(&values);
        level.thickness = mostAround(level.grid, thicknessOf(medium, around));
        setExtinction(medium, atNodes, aligned, level);
    }

    std::vector<std::vector<float>> limited, means;
    Extinctions atNodes, around;  ///< of each class, at nodes and around them
    bool thick = false;
};

}  // namespace

std::vector<float> nodeThickness(const LightMedium& medium, bool periodicSides, bool aligned) {
    TransportLevel level;
    level.grid = {medium.nodes, medium.spacingM, periodicSides};
    const Thickness of(medium, aligned, level);
    return std::move(level.thickness);
}

TransportLevel finestLevel(const LightMedium& medium, bool periodicSides, bool aligned,
                           int momentCount) {
    TransportLevel level;
    level.grid = {medium.nodes, medium.spacingM, periodicSides};
    level.momentCount = momentCount;
    level.degreeCount = momentCount == kBroadMoments ? kBroadDegrees : kAlignedDegrees;
    const Thickness of(medium, aligned, level);
    level.numberActive();
    if (of.thick) level.aroundPerM.assign(level.activeCount, 0.0f);
    for (std::size_t node = 0; node < level.place.size(); ++node) {
        if (level.place[node] < 0) continue;
        const auto thickness = static_cast<double>(level.thickness[node]);
        MixedOptics mixed = mixedAt(medium, of.atNodes, node, aligned, thickness);
        if (of.thick) {
            const MixedOptics mean = mixedAt(medium, of.around, node, aligned, thickness);
            level.aroundPerM[static_cast<std::size_t>(level.place[node])] =
                static_cast<float>(mean.extinctionPerM);
            if (level.extinctionPerM[node] <= 0.0f) mixed = mean;
        }
        if (mixed.extinctionPerM <= 0.0) continue;
        setAlbedo(mixed, level.degreeCount, level.albedoAt(node));
    }
    if (of.thick) level.setBalanced();
    return level;
}

}  // namespace neph
