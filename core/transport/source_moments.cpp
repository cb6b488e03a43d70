// source_moments.cpp: moments of the field times what is scattered of them.
#include "core/transport/source_moments.h"

#include <algorithm>
#include <cstddef>

namespace neph {
namespace {

/// Nodes from `at` - 1 to `at` + 1 that exist.
struct Around {
    int from, to;
};

Around around(int at, int count) {
    return {std::max(at - 1, 0), std::min(at + 1, count - 1)};
}

/// Calls `visit(node)` for a node and those around it.
template <typename Visit>
void forNeighbours(const TransportGrid& grid, const glm::ivec3& at, const Visit& visit) {
    const Around x = around(at.x, grid.nodes.x), y = around(at.y, grid.nodes.y),
                 z = around(at.z, grid.nodes.z);
    for (int k = z.from; k <= z.to; ++k) {
        for (int j = y.from; j <= y.to; ++j) {
            for (int i = x.from; i <= x.to; ++i) visit(grid.index(i, j, k));
        }
    }
}

/// Sums over the particles of some nodes.
class MeanShares {
  public:
    MeanShares(const TransportLevel& level, float* out) : level_(level), out_(out) {}
    void add(std::size_t node) {
        const auto degrees = static_cast<std::size_t>(level_.degreeCount);
        if (level_.extinctionPerM[node] <= 0.0f) return;
        const float* from =
            &level_.scatteringPerM[static_cast<std::size_t>(level_.place[node]) * degrees];
        for (std::size_t l = 0; l < degrees; ++l) out_[l] += from[l];
        extinctionPerM_ += level_.extinctionPerM[node];
    }
    void divide() {
        if (extinctionPerM_ <= 0.0f) return;
        for (int l = 0; l < level_.degreeCount; ++l) out_[l] /= extinctionPerM_;
    }

  private:
    const TransportLevel& level_;
    float* out_;
    float extinctionPerM_ = 0.0f;
};

}  // namespace

std::vector<float> scatteringShares(const TransportLevel& level) {
    const auto degrees = static_cast<std::size_t>(level.degreeCount);
    std::vector<float> shares(level.activeCount * degrees, 0.0f);
    std::size_t node = 0;
    for (int k = 0; k < level.grid.nodes.z; ++k) {
        for (int j = 0; j < level.grid.nodes.y; ++j) {
            for (int i = 0; i < level.grid.nodes.x; ++i, ++node) {
                if (level.place[node] < 0) continue;
                MeanShares mean(level,
                                &shares[static_cast<std::size_t>(level.place[node]) * degrees]);
                if (level.extinctionPerM[node] > 0.0f) {
                    mean.add(node);
                } else {
                    forNeighbours(level.grid, {i, j, k}, [&](std::size_t n) { mean.add(n); });
                }
                mean.divide();
            }
        }
    }
    return shares;
}

std::vector<float> sourceMoments(const LightSolver& solver, const std::vector<float>& shares,
                                 int degrees) {
    const auto moments = static_cast<std::size_t>(solver.momentCount());
    std::vector<float> source = solver.field().moments;
    for (std::size_t i = 0; i < solver.level().activeCount; ++i) {
        const float* share = &shares[i * static_cast<std::size_t>(degrees)];
        for (std::size_t q = 0; q < moments; ++q) {
            source[i * moments + q] *= share[degreeOf(static_cast<int>(q))];
        }
    }
    return source;
}

}  // namespace neph
