// grads_file.h: opens GrADS descriptors and the binary files that they describe, as written by CM1.
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "readers/les/contents.h"
#include "readers/raw_les/grads_ctl.h"

namespace les {

/// 80: a descriptor of a three-dimensional grid. 5: any other descriptor. 0: not a descriptor.
int scoreCtl(const std::string& path);

/// Opens a descriptor. The size of every data file is checked before anything is read. Throws
/// Error.
std::unique_ptr<neph::plugin::File> openGrads(const std::string& ctlPath);

/// The descriptor in the folder of `path` that names `path` as its data file.
std::optional<std::string> findCtlOf(const std::string& path);

/// The descriptors of model output in a folder, sorted: those with at least one hydrometeor.
std::vector<std::string> modelCtls(const std::string& folder);

}  // namespace les
