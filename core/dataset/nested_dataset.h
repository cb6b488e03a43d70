// nested_dataset.h: the domains of a nested run as one data set.
//
// World space, times and all that is read by name are those of the outermost domain; the others are
// its nests (Dataset::nests). core/volume/nested_volume composes them.
//
// The times are those at which all of the picture is known: the outermost domain's. A nest is there
// at a time if it has output within the time in which air at 50 m/s crosses one cell of the
// outermost domain; output in between, which nests often have, is for opening the nest by itself.
#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "core/dataset/dataset.h"
#include "core/dataset/series.h"

namespace neph {

/// How a data set is made of one series.
using MakeDataset = std::function<std::shared_ptr<Dataset>(const Series& series)>;

/// The data set of one series; of several the composed one, whose outermost domain contains the
/// first and as many others as possible. Domains that do not fit are left out with a note if they
/// are from folders. Throws Error if one of them was named.
std::shared_ptr<Dataset> openDomains(std::vector<Series> domains, const MakeDataset& make);

/// Domains as one data set; exposed for tests. `seconds` is the first time on the clock that they
/// share.
struct NestedPart {
    std::shared_ptr<Dataset> dataset;
    double seconds = 0.0;
    std::string name;
};

/// Composes `nests` within `whole`, each at the times at which it lies within it; `whole` itself if
/// none ever does. Nothing is read.
std::shared_ptr<Dataset> nestWithin(const NestedPart& whole, std::vector<NestedPart> nests);

/// Longest time between the output of a nest and that of the whole which counts as one time.
double nestToleranceSeconds(const DatasetInfo& whole);

}  // namespace neph
