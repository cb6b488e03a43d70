// compare_engines.h: the same view drawn by one engine after the other, the last of which is the
// reference.
#pragma once
#include "app/cli/compare/compare_options.h"
#include "app/cli/compare/comparison.h"

namespace neph {

/// Draws all, and keeps them where the options name a folder. The last is the reference. Throws
/// Error, UsageError or Cancelled.
std::vector<ComparedPicture> drawEngines(const ComparisonOptions& options,
                                         const Progress& progress);

/// Name of a file in the folder of the options, of an engine as typed: "slicing:light.form=printed"
/// becomes slicing-light.form-printed.
std::filesystem::path fileOf(const ComparisonOptions& options, const std::string& engine,
                             const std::string& ending);

}  // namespace neph
