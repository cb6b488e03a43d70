// save_plots.h: plots of the panels as files.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/dataset/dataset.h"
#include "core/plot/figure.h"
#include "core/plot/table.h"

namespace neph {

/// Writes figures side by side, or for .csv the table, into `folder`, under a name that no file has
/// yet, or to the file that an absolute `name` is, and returns it. `data` may be null. Throws
/// Error.
std::string savePlots(const std::filesystem::path& folder, const std::string& name,
                      const std::vector<plot::Figure>& figures, plot::Table table,
                      const DatasetInfo* data);

}  // namespace neph
