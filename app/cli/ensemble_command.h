// ensemble_command.h: `nephoscope ensemble`: probability, mean and spread of the optical depth over
// the members of an ensemble, as figures, a file or a map.
#pragma once
#include <filesystem>
#include <string>

#include "app/cli/common/arguments.h"
#include "core/volume/ensemble_maps.h"

namespace neph {

struct EnsembleRequest {
    SceneRequest scene;      ///< its members, preset, settings, time, region and readers
    double threshold = 1.0;  ///< of the optical depth
    EnsembleMap shown = EnsembleMap::probability;  ///< in a PNG
    std::filesystem::path out;  ///< .nc, .csv, .png or .svg; empty: figures alone
};

Command addEnsemble(CLI::App& app);

/// Prints the figures and writes the file. Throws Error, UsageError or Cancelled.
void runEnsemble(const EnsembleRequest& request, const Progress& progress);

}  // namespace neph
