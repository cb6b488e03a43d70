// air_block.h: the air in some native columns, and what is computed from it.
#pragma once
#include <array>
#include <map>
#include <span>
#include <string>

#include "core/analysis/quantity.h"
#include "core/base/progress.h"
#include "core/dataset/dataset.h"
#include "core/volume/native_band.h"

namespace neph {

/// Fields of native columns, as far as given quantities need them. Cells are of the whole grid.
class AirBlock {
  public:
    /// Reads whole columns of `columns` (its levels do not matter). Throws Error where a quantity
    /// cannot be had from these data or a field cannot be read, or Cancelled.
    AirBlock(Dataset& dataset, int time, const CellBox& columns,
             std::span<const Quantity> quantities, const Progress& progress = {});

    /// In the unit of the quantity; NaN where the data have no value. `cell` lies in the columns.
    double value(Quantity quantity, glm::ivec3 cell) const;
    /// Height of a cell's centre, metres above sea level.
    double middleM(glm::ivec3 cell) const;
    /// The lower face of level `face`; that of the lowest is the ground.
    double faceM(glm::ivec2 column, int face) const;
    int levels() const { return levels_; }

    /// Linear in height between centres of cells; that of the outermost cell beyond them; NaN below
    /// the ground and above the top.
    double valueAtHeight(Quantity quantity, glm::ivec2 column, double heightM) const;
    /// The share of the way from the centre of `level` to the next, at a height in the column.
    struct Level {
        int level = 0;
        double share = 0.0;
        bool inside = false;
    };
    Level levelAt(glm::ivec2 column, double heightM) const;

  private:
    double at(const ColumnField& field, glm::ivec3 cell) const;
    double role(VariableRole role, glm::ivec3 cell) const;
    double condensate(glm::ivec3 cell) const;
    double vorticity(glm::ivec3 cell) const;
    /// The change of a component of the wind along an axis, per second.
    double slope(VariableRole component, int axis, glm::ivec3 cell) const;

    DatasetInfo info_;
    CellBox box_;
    int levels_ = 0;
    ColumnField heights_;
    std::array<std::optional<ColumnField>, kSpeciesCount> ratios_;
    std::map<VariableRole, ColumnField> air_;
    std::optional<ColumnField> reflectivity_;
};

/// Throws Error where a quantity cannot be had: names the file, the time and what is missing.
void requireQuantity(const Dataset& dataset, int time, Quantity quantity);

}  // namespace neph
