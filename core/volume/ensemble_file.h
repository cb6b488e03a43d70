// ensemble_file.h: the maps of an ensemble in a file: CF NetCDF, or a table.
#pragma once
#include <string>

#include "core/volume/ensemble_maps.h"

namespace neph {

/// A NetCDF file after CF-1.8 with all three maps on (y, x), latitude and longitude where known.
/// `source`: the program and its version.
std::string ensembleNetcdf(const EnsembleDepths& depths, double threshold,
                           const std::string& source);

/// A line for each column: x, y, latitude and longitude where known, then the three maps. Lines
/// that begin with '#' say what they are.
std::string ensembleCsv(const EnsembleDepths& depths, double threshold, const std::string& source);

}  // namespace neph
