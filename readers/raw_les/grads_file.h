// grads_file.h: GrADS descriptors and the flat files they describe, as CM1 writes them.
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "readers/raw_les/contents.h"
#include "readers/raw_les/grads_ctl.h"

namespace raw {

/// 80: a descriptor of a grid in three dimensions. 5: another descriptor. 0: none.
int scoreCtl(const std::string& path);

/// Opens a descriptor; every data file's size is checked before anything is read. Throws Error.
std::unique_ptr<neph::plugin::File> openGrads(const std::string& ctlPath);

/// Descriptor in the folder of `path` that names it as its data file.
std::optional<std::string> ctlThatNames(const std::string& path);

/// The descriptors of model output in a folder, sorted: those that openGrads would take.
std::vector<std::string> modelCtls(const std::string& folder);

}  // namespace raw
