// variables.h: the stored variables of a data set, with roles by name, and what is derived from
// them.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "readers/cf_les/grid.h"
#include "readers/les/contents.h"

namespace cf {

/// What reads the values of a data set: shared by all its variables.
struct DataSet {
    /// Opens what belongs to `file`. Throws Failure.
    DataSet(std::unique_ptr<nc::NcFile> file, Model row)
        : model(std::move(row)), files(std::move(file), model) {}
    DataSet(const DataSet&) = delete;  // `files` refer to names of `model`
    DataSet& operator=(const DataSet&) = delete;

    Model model;  ///< a copy: of a mapping there is no row
    FileSet files;
    Grid grid{};
    std::vector<std::size_t> records{};  ///< along the dimension of time, one for each time
};

/// Adds all variables on the grid with their roles, and everything that follows from them, to
/// `contents`, whose description has the size of the grid. `hail`: the variable qg holds hail.
/// Throws Failure for a hydrometeor or air in an unknown unit.
void addVariables(const std::shared_ptr<const DataSet>& data, bool hail, les::Contents& contents);

}  // namespace cf
