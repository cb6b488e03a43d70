// revolve.h: axisymmetric output, whose x is the distance from the axis, on a grid in x and y.
#pragma once
#include <memory>

#include "core/plugin/reader_plugin.h"

namespace les {

/// A file of n x 1 columns from the axis outwards, as one of 2n x 2n columns around the axis.
/// Values are linear in the radius between centres of cells, as at the first centre within it, and
/// beyond the last cell zero for amounts of hydrometeors and as in the last cell for everything
/// else. Throws Error if `flat` has more than one row.
std::unique_ptr<neph::plugin::File> revolved(std::unique_ptr<neph::plugin::File> flat);

}  // namespace les
