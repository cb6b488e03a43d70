// compose_domains.cpp: weights along x and y, then row by row.
#include "core/volume/compose_domains.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "core/base/parallel.h"

namespace neph {
namespace {

constexpr std::size_t kMostComposers = 8;

/// What the cells of the result take from those of a domain along one axis.
struct AxisWeights {
    struct Cell {
        int first = 0;          ///< cell of the domain
        std::size_t begin = 0;  ///< index of its weight
        std::size_t count = 0;  ///< cells of the domain from `first` on
    };
    std::vector<Cell> cells;
    std::vector<float> weights;
};

/// Adds a weight to a list that begins at cell `first`.
void addWeight(std::vector<double>& list, int first, int cell, double weight) {
    const auto index = static_cast<std::size_t>(cell - first);
    if (index >= list.size()) list.resize(index + 1, 0.0);
    list[index] += weight;
}

/// `domainCells` cells of the domain, `resultCells` of the result. Where a result cell lies across
/// the domain's border, its value is that of the part within (`partial`) or has nothing beyond.
AxisWeights weightsAlong(int axis, const LatticeGrid& at, int domainCells,
                         const LatticeGrid& resultAt, int resultCells, bool partial) {
    AxisWeights all;
    const bool linear = at.cell > resultAt.cell;
    for (int i = 0; i < resultCells; ++i) {
        std::vector<double> list;
        int first = -1, within = 0;
        for (int sub = 0; sub < resultAt.cell; ++sub) {
            const int lattice = resultAt.corner[axis] + i * resultAt.cell + sub - at.corner[axis];
            if (lattice < 0 || lattice >= domainCells * at.cell) continue;
            ++within;
            if (!linear) {
                if (first < 0) first = lattice / at.cell;
                addWeight(list, first, lattice / at.cell, 1.0);
                continue;
            }
            const double position = (lattice + 0.5) / at.cell - 0.5;
            const int below = static_cast<int>(std::floor(position));
            const int lower = std::clamp(below, 0, domainCells - 1);
            const int upper = std::clamp(below + 1, 0, domainCells - 1);
            if (first < 0) first = lower;
            addWeight(list, first, lower, 1.0 - (position - below));
            addWeight(list, first, upper, position - below);
        }
        all.cells.push_back({std::max(first, 0), all.weights.size(), list.size()});
        const double share = 1.0 / (partial ? std::max(within, 1) : resultAt.cell);
        for (const double weight : list) all.weights.push_back(static_cast<float>(weight * share));
    }
    return all;
}

/// One domain and the result, with all that does not depend on field and level.
class Composer {
  public:
    Composer(const SpeciesVolume& domain, const LatticeGrid& at,
             const std::optional<NestEdges>& edges, const LatticeGrid& resultAt,
             const RegularGrid& result)
        : size_(result.size),
          x_(weightsAlong(0, at, domain.grid.size.x, resultAt, size_.x, edges.has_value())),
          y_(weightsAlong(1, at, domain.grid.size.y, resultAt, size_.y, edges.has_value())) {
        shares_.assign(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y), 1.0f);
        if (!edges) return;
        for (int y = 0; y < size_.y; ++y) {
            for (int x = 0; x < size_.x; ++x) {
                const glm::dvec2 middle =
                    glm::dvec2(resultAt.corner) + (glm::dvec2(x, y) + 0.5) * double(resultAt.cell);
                shareAt(x, y) = static_cast<float>(nestWeight(*edges, middle));
            }
        }
    }

    /// One level of one field; `from` is empty where the domain lacks the species.
    void level(const Array3f& from, int z, Array3f& to) const {
        std::vector<float> row(static_cast<std::size_t>(from.size.x));
        for (int y = 0; y < size_.y; ++y) {
            if (!from.empty()) addRows(from, y, z, row);
            float* out = &to.at(0, y, z);
            const float* shares =
                shares_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x);
            for (int x = 0; x < size_.x; ++x) {
                const float share = shares[x];
                if (share == 0.0f) continue;
                const float value = from.empty() ? 0.0f : valueAt(row, x);
                out[x] = share == 1.0f ? value : out[x] + share * (value - out[x]);
            }
        }
    }

  private:
    float& shareAt(int x, int y) {
        return shares_[static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x) +
                       static_cast<std::size_t>(x)];
    }
    void addRows(const Array3f& from, int y, int z, std::vector<float>& row) const {
        std::ranges::fill(row, 0.0f);
        const AxisWeights::Cell& cell = y_.cells[static_cast<std::size_t>(y)];
        for (std::size_t i = 0; i < cell.count; ++i) {
            const float weight = y_.weights[cell.begin + i];
            const float* values = &from.at(0, cell.first + static_cast<int>(i), z);
            for (std::size_t x = 0; x < row.size(); ++x) row[x] += weight * values[x];
        }
    }
    float valueAt(const std::vector<float>& row, int x) const {
        const AxisWeights::Cell& cell = x_.cells[static_cast<std::size_t>(x)];
        float sum = 0.0f;
        for (std::size_t i = 0; i < cell.count; ++i) {
            sum += x_.weights[cell.begin + i] * row[static_cast<std::size_t>(cell.first) + i];
        }
        return sum;
    }

    glm::ivec3 size_;
    AxisWeights x_, y_;
    std::vector<float> shares_;  ///< of the domain, x fastest
};

}  // namespace

double nestWeight(const NestEdges& edges, glm::dvec2 position) {
    const glm::dvec2 inside =
        glm::min(position - glm::dvec2(edges.lower), glm::dvec2(edges.upper) - position);
    const double distance = std::min(inside.x, inside.y);
    if (distance <= 0.0) return 0.0;
    const double t = std::min(distance / edges.width, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

void composeDomain(const SpeciesVolume& domain, const LatticeGrid& at,
                   const std::optional<NestEdges>& edges, const LatticeGrid& resultAt,
                   SpeciesVolume& result, const Progress& progress) {
    assert(domain.grid.size.z == result.grid.size.z);
    const Composer composer(domain, at, edges, resultAt, result.grid);
    struct Field {
        const Array3f* from;
        Array3f* to;
    };
    std::vector<Field> fields;
    for (std::size_t s = 0; s < kSpeciesCount; ++s) {
        const auto species = static_cast<Species>(s);
        if (!domain.has(species) && !result.has(species)) continue;
        const bool extinction = domain.holdsExtinction(species) || result.holdsExtinction(species);
        assert(!extinction || (domain.content(species).empty() && result.content(species).empty()));
        const auto& from = extinction ? domain.extinctionPerM[s] : domain.contentKgPerM3[s];
        auto& to = extinction ? result.extinctionPerM[s] : result.contentKgPerM3[s];
        if (to.empty()) to = Array3f(result.grid.size);
        fields.push_back({&from, &to});
    }
    const auto levels = static_cast<std::size_t>(result.grid.size.z);
    shareOut(
        fields.size() * levels, workerCount(kMostComposers),
        [&](std::size_t piece, std::size_t, const Progress&) {
            const Field& field = fields[piece / levels];
            composer.level(*field.from, static_cast<int>(piece % levels), *field.to);
        },
        progress);
}

}  // namespace neph
