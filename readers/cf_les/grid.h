// grid.h: the cells of a data set in metres, and which of the stored ones they are.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "readers/cf_les/file_set.h"

namespace cf {

struct Grid {
    std::array<std::string, 3> dimension;  ///< of the cells in x, y, z, as the files name it
    /// The names that the model has for it, as MONC's z and zn.
    std::array<std::vector<std::string>, 3> aliases;
    std::array<std::size_t, 3> stored{};  ///< cells in the files
    std::array<std::size_t, 3> begin{};   ///< first stored cell of the domain
    std::array<std::size_t, 3> size{};    ///< cells of the domain
    std::array<bool, 3> flip{};           ///< stored from east to west, north to south, top down
    std::array<double, 2> spacingM{};
    std::array<std::vector<double>, 2> edgesM;  ///< faces, where cells are not even
    std::vector<double> interfacesM;            ///< nominal, increasing
    /// Position of the south-west corner in the coordinates of the file; 0 if it has none.
    std::array<double, 2> cornerM{};

    /// Whether a variable lies on the stored cells, in every direction that it has.
    bool holds(const Stored& stored) const;
    /// The stored cells of a box of cells, for a variable on the cells.
    les::Box storedBox(const les::Box& box, const Layout& layout) const;
};

/// The grid of the first hydrometeor. Throws Failure, naming the coordinate that is missing or
/// cannot be used. `notes` say what was left out or assumed.
Grid gridOf(const FileSet& files, const Model& model, std::vector<std::string>& notes);

/// Turns values of a box around along the axes that are stored the other way.
void turn(std::span<float> values, const les::Box& box, const std::array<bool, 3>& flip,
          const Layout& layout);

}  // namespace cf
