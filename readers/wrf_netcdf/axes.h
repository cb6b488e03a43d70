// axes.h: which dimension of a file is time, x, y or z, by the fields that lie on them: tools that
// process output rename dimensions.
#pragma once
#include <array>
#include <optional>
#include <string>

#include "readers/wrf_netcdf/failure.h"

namespace wrf {

/// Names of dimensions in x, y, z.
struct Axes {
    std::string time;                   ///< empty if fields have no time
    std::array<std::string, 3> centre;  ///< of cells
    std::array<std::string, 3> face;    ///< of staggered variables; empty if the file has none
    std::array<std::size_t, 3> length{};

    /// The length of the dimension of faces.
    std::size_t faces(std::size_t axis) const { return length[axis] + 1; }
};

/// The axes of the fields of model output; nothing if the file has no such fields. Throws Failure
/// if they are stored in another order than time, z, y, x.
std::optional<Axes> axesOf(const NcFile& file);

/// Where a variable lies.
struct Shape {
    bool timed = false;
    bool flat = false;                         ///< without z
    std::array<bool, 3> staggered{};           ///< in x, y, z
    std::array<std::size_t, 3> size{1, 1, 1};  ///< values in x, y, z

    bool onCells() const { return !flat && !staggered[0] && !staggered[1] && !staggered[2]; }
    /// On the faces between layers.
    bool onInterfaces() const { return !flat && !staggered[0] && !staggered[1] && staggered[2]; }
};

/// Nothing for a variable that does not lie on the horizontal grid. A third axis may be any, such
/// as layers of soil; then the variable is neither on cells nor on interfaces.
std::optional<Shape> shapeOf(const NcVariable& variable, const Axes& axes);

}  // namespace wrf
