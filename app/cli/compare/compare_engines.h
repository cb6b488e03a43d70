// compare_engines.h: the same view drawn by one engine after the other, the last of which is the
// reference.
#pragma once
#include "app/cli/compare/compare_request.h"
#include "app/cli/compare/comparison.h"

namespace neph {

/// Draws all, or the member and the one that it is compared with, and keeps them where the request
/// names a folder. The last is the reference. Throws Error, UsageError or Cancelled.
std::vector<ComparedImage> drawEngines(const CompareRequest& request, const Progress& progress);

/// Name of a file in the folder of the request, of an engine as typed: "slicing:light.form=printed"
/// becomes slicing-light.form-printed.
std::filesystem::path fileOf(const CompareRequest& request, const std::string& engine,
                             const std::string& ending);

}  // namespace neph
