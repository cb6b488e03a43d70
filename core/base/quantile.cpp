// quantile.cpp: sorts as far as is needed.
#include "core/base/quantile.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace neph {

double quantile(std::span<const float> values, double share) {
    std::vector<float> sorted(values.begin(), values.end());
    const double rank = std::ceil(share * static_cast<double>(sorted.size()));
    const auto at =
        sorted.begin() + std::max<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(rank), 1) - 1;
    std::nth_element(sorted.begin(), at, sorted.end());
    return static_cast<double>(*at);
}

}  // namespace neph
