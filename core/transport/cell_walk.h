// cell_walk.h: a ray's way through the cells between nodes, and extinction within a cell.
//
// Positions are in nodes. Between nodes extinction is trilinear, a cubic along a ray, which
// Simpson's rule integrates exactly.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/transport/transport_level.h"

namespace neph {

/// The values at the corners of a cell: bit 0 of a corner is x, bit 1 y, bit 2 z.
struct CellCorners {
    std::array<std::size_t, 8> node{};
    std::array<float, 8> value{};

    CellCorners(const TransportGrid& grid, const std::vector<float>& values,
                const glm::ivec3& cell) {
        glm::ivec3 next = cell + 1;
        for (int axis = 0; axis < 2; ++axis) {
            if (next[axis] == grid.nodes[axis]) next[axis] = grid.periodic(axis) ? 0 : cell[axis];
        }
        next.z = std::min(next.z, grid.nodes.z - 1);
        for (std::size_t corner = 0; corner < 8; ++corner) {
            node[corner] = grid.index((corner & 1U) != 0 ? next.x : cell.x,
                                      (corner & 2U) != 0 ? next.y : cell.y,
                                      (corner & 4U) != 0 ? next.z : cell.z);
            value[corner] = values[node[corner]];
        }
    }
    float most() const { return *std::ranges::max_element(value); }
    /// `share` is of the upper corners, 0 ... 1.
    float at(const glm::vec3& share) const {
        const auto line = [&](std::size_t from) {
            return value[from] + share.x * (value[from + 1] - value[from]);
        };
        const float low = line(0) + share.y * (line(2) - line(0));
        const float high = line(4) + share.y * (line(6) - line(4));
        return low + share.z * (high - low);
    }
};

/// Shares of the upper corners by which moments in a thick cell are interpolated: linear in the
/// depth from face to face, not in length. `lengthM` is `thicknessLengthM`.
inline glm::vec3 depthShares(const CellCorners& cell, float lengthM, const glm::vec3& share) {
    constexpr float kFrom = 1.0f, kWhole = 4.0f;
    const float part = std::clamp((cell.most() * lengthM - kFrom) / (kWhole - kFrom), 0.0f, 1.0f);
    if (part <= 0.0f) return share;
    glm::vec3 result = share;
    for (int axis = 0; axis < 3; ++axis) {
        float low = 0.0f, high = 0.0f;
        for (std::size_t corner = 0; corner < 8; ++corner) {
            (((corner >> axis) & 1U) != 0 ? high : low) += cell.value[corner];
        }
        const float t = share[axis], inDepth = (2.0f * low + (high - low) * t) * t / (low + high);
        result[axis] += part * (inDepth - t);
    }
    return result;
}

/// Follows a ray from `start` in nodes, `perM` nodes a metre, through the medium. Calls
/// `visit(cell, shares at the entry, shares a metre, metres in the cell)` until it returns false.
template <typename Visit>
void walkCells(const TransportGrid& grid, const glm::dvec3& start, const glm::dvec3& perM,
               Visit&& visit) {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    double entry = 0.0, exit = kFar;
    for (int axis = 0; axis < 3; ++axis) {
        if (grid.periodic(axis)) continue;
        const double last = grid.nodes[axis] - 1;
        if (perM[axis] == 0.0) {
            if (start[axis] < 0.0 || start[axis] > last) return;
            continue;
        }
        const double a = -start[axis] / perM[axis], b = (last - start[axis]) / perM[axis];
        entry = std::max(entry, std::min(a, b));
        exit = std::min(exit, std::max(a, b));
    }
    if (entry >= exit) return;  // it misses, by as far as a level axis takes it
    glm::ivec3 cell(0);
    glm::dvec3 still(0.0);  // shares where the ray does not move
    glm::dvec3 next(kFar);  // metres to the next face of each axis
    const glm::dvec3 at = start + perM * entry;
    for (int axis = 0; axis < 3; ++axis) {
        const int most = grid.nodes[axis] - (grid.periodic(axis) ? 1 : 2);
        double place = at[axis];
        if (grid.periodic(axis)) place -= grid.nodes[axis] * std::floor(place / grid.nodes[axis]);
        cell[axis] = std::clamp(static_cast<int>(place), 0, most);
        if (perM[axis] < 0.0 && place == cell[axis] && cell[axis] > 0) --cell[axis];
        still[axis] = place - cell[axis];
        if (perM[axis] == 0.0) continue;
        const double face = cell[axis] + (perM[axis] > 0.0 ? 1.0 : 0.0);
        next[axis] = entry + (face - place) / perM[axis];
    }
    const glm::vec3 rate(perM);
    while (entry < exit) {
        const int axis = next.x < next.y ? (next.x < next.z ? 0 : 2) : (next.y < next.z ? 1 : 2);
        const double end = std::min(next[axis], exit);
        if (end > entry) {
            glm::vec3 share;
            for (int i = 0; i < 3; ++i) {
                // From the face ahead, so that wrapped cells need no position of their own.
                const double ahead =
                    perM[i] == 0.0 ? still[i]
                                   : (perM[i] > 0.0 ? 1.0 : 0.0) - (next[i] - entry) * perM[i];
                share[i] = static_cast<float>(std::clamp(ahead, 0.0, 1.0));
            }
            if (!visit(cell, share, rate, static_cast<float>(end - entry))) return;
            entry = end;
        }
        if (next[axis] >= exit) return;
        next[axis] += 1.0 / std::abs(perM[axis]);
        cell[axis] += perM[axis] > 0.0 ? 1 : -1;
        if (grid.periodic(axis)) {
            cell[axis] = (cell[axis] + grid.nodes[axis]) % grid.nodes[axis];
        } else if (cell[axis] < 0 || cell[axis] > grid.nodes[axis] - 2) {
            return;
        }
    }
}

}  // namespace neph
