// grads_contents.h: what a parsed descriptor and its data files contain: model, grid, times and
// variables with their meaning.
#pragma once
#include <memory>
#include <string>

#include "readers/les/contents.h"
#include "readers/raw_les/grads_ctl.h"

namespace les {

/// Throws Error. The size of every data file is checked, and a sample of the numbers is read,
/// before anything else is.
std::unique_ptr<neph::plugin::File> makeGrads(const std::string& ctlPath, Ctl ctl);

/// Whether a descriptor has a hydrometeor on more than one plane.
bool hasHydrometeor(const Ctl& ctl);

}  // namespace les
