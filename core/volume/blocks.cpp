// blocks.cpp: overlaps of native with target cells, and means over blocks.
#include "core/volume/blocks.h"

#include <algorithm>

namespace neph {
namespace {

constexpr double kLeastShare = 1e-9;  // faces that should coincide differ by rounding

/// Shares of the native cells from `lower` to `upper` in `count` target cells of `spacingM`, the
/// first of which begins at `originM`.
AxisShares sharesOf(const DatasetInfo& info, int axis, glm::ivec2 native, double originM,
                    double spacingM, int count) {
    AxisShares shares;
    int cell = native.x;
    for (int target = 0; target < count; ++target) {
        shares.first.push_back(shares.pieces.size());
        const double from = originM + spacingM * target, to = originM + spacingM * (target + 1);
        while (cell < native.y && info.edgeM(axis, cell + 1) <= from) ++cell;
        for (int at = cell; at < native.y && info.edgeM(axis, at) < to; ++at) {
            const double overlap =
                std::min(info.edgeM(axis, at + 1), to) - std::max(info.edgeM(axis, at), from);
            if (overlap < kLeastShare * spacingM) continue;
            shares.pieces.push_back({at - native.x, overlap / spacingM});
        }
    }
    shares.first.push_back(shares.pieces.size());
    return shares;
}

/// Native rows that the target rows from `firstRow` on overlap.
CellBox nativeRows(const ReadPlan& plan, const DatasetInfo& info, int firstRow, int rows) {
    const glm::ivec2 all(plan.box.lower.y, plan.box.upper.y);
    const double origin = plan.grid.originM.y + plan.grid.spacingM.y * firstRow;
    const AxisShares shares = sharesOf(info, 1, all, origin, plan.grid.spacingM.y, rows);
    CellBox native = plan.box;
    native.upper.y = native.lower.y + shares.pieces.back().cell + 1;
    native.lower.y += shares.pieces.front().cell;
    return native;
}

}  // namespace

std::vector<TargetBand> targetBands(const ReadPlan& plan, const DatasetInfo& info) {
    std::vector<TargetBand> bands;
    if (!hasUnevenCells(info)) {
        for (const CellBox& native : bandsOf(plan.box, plan.coarsening)) {
            const int row = (native.lower.y - plan.box.lower.y) / plan.coarsening;
            const int rows = (native.size().y + plan.coarsening - 1) / plan.coarsening;
            bands.push_back({native, row, rows, 0});
        }
        return bands;
    }
    // Each takes target rows until it needs as many native ones as a band of an even grid has.
    const int nativeRowsOfBand = bandsOf(plan.box, 1).front().size().y;
    for (int row = 0; row < plan.grid.size.y;) {
        int rows = 1;
        CellBox native = nativeRows(plan, info, row, rows);
        while (row + rows < plan.grid.size.y) {
            const CellBox more = nativeRows(plan, info, row, rows + 1);
            if (more.size().y > nativeRowsOfBand) break;
            native = more;
            ++rows;
        }
        const int known = bands.empty() ? native.lower.y : bands.back().native.upper.y;
        bands.push_back({native, row, rows, known - native.lower.y});
        row += rows;
    }
    return bands;
}

Blocks::Blocks(const ReadPlan& plan, const DatasetInfo& info, const TargetBand& band)
    : native_(band.native.size()),
      coarse_(plan.grid.size.x, band.rows),
      even_(!hasUnevenCells(info)),
      edge_(plan.coarsening) {
    if (even_) return;
    const RegularGrid& grid = plan.grid;
    x_ = sharesOf(info, 0, {band.native.lower.x, band.native.upper.x}, grid.originM.x,
                  grid.spacingM.x, coarse_.x);
    y_ = sharesOf(info, 1, {band.native.lower.y, band.native.upper.y},
                  grid.originM.y + grid.spacingM.y * band.firstRow, grid.spacingM.y, coarse_.y);
}

std::vector<double> Blocks::means(const ColumnField& field) const {
    const auto levels = static_cast<std::size_t>(field.values.size.z);
    std::vector<double> means(count() * levels);
    std::vector<double> weights(count());
    each([&](std::size_t block, std::size_t, double weight) { weights[block] += weight; });
    for (std::size_t level = 0; level < levels; ++level) {
        double* mean = means.data() + level * count();
        each([&](std::size_t block, std::size_t column, double weight) {
            mean[block] += weight * static_cast<double>(field.at(column, level));
        });
        for (std::size_t block = 0; block < count(); ++block) mean[block] /= weights[block];
    }
    return means;
}

std::vector<double> Blocks::averaged(const Array3f& quantity, const ColumnField& heights,
                                     std::span<const double> interfaces) const {
    const auto layers = static_cast<std::size_t>(quantity.size.z);
    const std::size_t layer = quantity.index(0, 0, 1);
    const double share = unitShare();
    std::vector<double> means(count() * layers);
    for (std::size_t k = 0; k < layers; ++k) {
        double* mean = means.data() + k * count();
        const float* values = quantity.values.data() + k * layer;
        each([&](std::size_t block, std::size_t column, double weight) {
            const double depth = static_cast<double>(heights.at(column, k + 1)) -
                                 static_cast<double>(heights.at(column, k));
            mean[block] += weight * (static_cast<double>(values[column]) * depth);
        });
        const double* lower = interfaces.data() + k * count();
        for (std::size_t block = 0; block < count(); ++block) {
            mean[block] *= share / (lower[block + count()] - lower[block]);
        }
    }
    return means;
}

}  // namespace neph
