// cm1.h: the model times of a run of CM1, which it writes into cm1out_metadata.
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace les {

/// Model time of each output in seconds, from cm1out_metadata in `folder`; nothing if it is absent
/// or is not as CM1 writes it. CM1's tdef cannot be used: it only counts outputs. `swapped`: where
/// its descriptor does not state a byte order.
std::optional<std::vector<double>> cm1Seconds(const std::string& folder, bool swapped);

}  // namespace les
