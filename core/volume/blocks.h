// blocks.h: the native columns that each column of the target grid is made of, band by band.
//
// On an even grid a target column is a block of n x n native ones. Where cells differ in width, it
// is made of those that it overlaps, each with the share of the target's area that it covers: the
// shares of a native column sum to its own area over that of a target column, so that the mass of
// the domain is conserved. There is nothing beyond the border of the domain.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "core/volume/native_band.h"
#include "core/volume/read_plan.h"

namespace neph {

/// Rows of the target grid that are made together, and the native columns that they need.
struct TargetBand {
    CellBox native;
    int firstRow = 0, rows = 0;  ///< of the target grid
    int ownRow = 0;  ///< rows of `native` before it belong to the band to the south as well
};

/// All bands of a plan, from south to north, each about a megabyte per field.
std::vector<TargetBand> targetBands(const ReadPlan& plan, const DatasetInfo& info);

/// What native cells along one axis contribute to each target cell.
struct AxisShares {
    struct Piece {
        int cell;      ///< native, counted from the start of the band
        double share;  ///< of the target cell that it covers
    };
    std::vector<Piece> pieces;       ///< of all target cells, in order
    std::vector<std::size_t> first;  ///< of each target cell, and the end

    std::span<const Piece> of(int target) const {
        const auto i = static_cast<std::size_t>(target);
        return {pieces.data() + first[i], pieces.data() + first[i + 1]};
    }
};

/// Maps the native columns of one band to blocks: the columns of its target rows.
class Blocks {
  public:
    Blocks(const ReadPlan& plan, const DatasetInfo& info, const TargetBand& band);

    std::size_t count() const {
        return static_cast<std::size_t>(coarse_.x) * static_cast<std::size_t>(coarse_.y);
    }
    /// Of a block that a weight of 1 covers.
    double unitShare() const {
        return even_ ? 1.0 / (static_cast<double>(edge_) * static_cast<double>(edge_)) : 1.0;
    }

    /// Calls `visit(block, column, weight)` for every native column of every block; the weight is
    /// in units of unitShare().
    template <typename Visit>
    void each(Visit&& visit) const {
        if (even_) {
            eachEven(visit);
        } else {
            eachOverlap(visit);
        }
    }

    /// Mean of each level of `field` over what each block has of the domain; block fastest.
    std::vector<double> means(const ColumnField& field) const;

    /// Averages a quantity per m³, such as content, over each block and the depth of the block's
    /// layer, so that its integral over the full area of the block is conserved. `interfaces` are
    /// the means of `heights`. Block fastest.
    std::vector<double> averaged(const Array3f& quantity, const ColumnField& heights,
                                 std::span<const double> interfaces) const;

  private:
    template <typename Visit>
    void eachEven(Visit&& visit) const {
        std::size_t column = 0;
        for (int y = 0; y < native_.y; ++y) {
            std::size_t block =
                static_cast<std::size_t>(coarse_.x) * static_cast<std::size_t>(y / edge_);
            for (int x = 0; x < native_.x; ++block) {
                const int end = std::min(x + edge_, native_.x);
                for (; x < end; ++x) visit(block, column++, 1.0);
            }
        }
    }
    template <typename Visit>
    void eachOverlap(Visit&& visit) const {
        std::size_t block = 0;
        for (int j = 0; j < coarse_.y; ++j) {
            for (int i = 0; i < coarse_.x; ++i, ++block) {
                for (const AxisShares::Piece& y : y_.of(j)) {
                    const std::size_t row =
                        static_cast<std::size_t>(y.cell) * static_cast<std::size_t>(native_.x);
                    for (const AxisShares::Piece& x : x_.of(i)) {
                        visit(block, row + static_cast<std::size_t>(x.cell), x.share * y.share);
                    }
                }
            }
        }
    }

    glm::ivec2 native_;  // columns of the band
    glm::ivec2 coarse_;  // blocks of the band; those at the north and east edges may be incomplete
    bool even_;
    int edge_;          // native columns along each edge of a full block of an even grid
    AxisShares x_, y_;  // of an uneven one
};

}  // namespace neph
