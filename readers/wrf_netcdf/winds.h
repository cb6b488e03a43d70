// winds.h: the wind in the cells of the grid, from components on faces.
#pragma once
#include <string>
#include <vector>

#include "readers/wrf_netcdf/fields.h"

namespace wrf {

/// Wind along the grid's x and y, and upward, m/s in each cell, as far as the file has them: the
/// mean of two faces where a component is stored on faces. A component whose units do not convert
/// is left out with a note.
std::vector<Field> findWinds(const Tiles& tiles, UnitNotes& unitNotes,
                             std::vector<std::string>& notes);

/// Along which axis a variable lies on faces: 0, 1 or 2; -1 for one in cells.
int facesAxisOf(const Tiles& tiles, const NcVariable& variable);

/// Means of neighbours along `axis` of `faces`, which has one more there than `box`.
void meansOfFaces(std::span<const float> faces, int axis, const shared::Box& box,
                  std::span<float> cells);

}  // namespace wrf
