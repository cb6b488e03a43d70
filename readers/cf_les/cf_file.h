// cf_file.h: which model a NetCDF file is of, and opening it.
#pragma once
#include <memory>
#include <string>

#include "core/plugin/reader_plugin.h"

namespace cf {

/// 95 for a file of a model of the table, or with a map, that has hydrometeors on its grid; 60 for
/// one by standard names alone; 7 for a file of a model of the table without them, whose opening
/// gives the reason; 0 otherwise.
int scoreOf(const std::string& path);

/// Opens a NetCDF file with a map: the one named, else the one beside the file; else as its row in
/// the table says. Throws Failure.
std::unique_ptr<neph::plugin::File> openFile(const std::string& path, const std::string& map);

}  // namespace cf
