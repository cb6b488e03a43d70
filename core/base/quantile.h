// quantile.h: the value below which a share of all lie.
#pragma once
#include <span>

namespace neph {

/// The smallest value that a share of all, 0 to 1, do not exceed (nearest rank). There is one value
/// at least.
double quantile(std::span<const float> values, double share);

}  // namespace neph
