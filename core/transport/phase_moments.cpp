// phase_moments.cpp: the midpoint rule, with points that crowd towards forward.
#include "core/transport/phase_moments.h"

#include <cmath>
#include <numbers>

#include "core/transport/harmonics.h"

namespace neph {

PhaseMoments phaseMomentsOf(const std::function<float(float cosTheta)>& phase) {
    constexpr int kPoints = 50000;
    PhaseMoments sum{};
    for (int i = 0; i < kPoints; ++i) {
        const double x = (i + 0.5) / kPoints;
        const double theta = std::numbers::pi * x * x, cosTheta = std::cos(theta);
        const double weight =
            x * std::sin(theta) * static_cast<double>(phase(static_cast<float>(cosTheta)));
        const auto legendre = legendreAt<kPhaseMomentCount>(cosTheta);
        for (std::size_t l = 0; l < sum.size(); ++l) sum[l] += weight * legendre[l];
    }
    const double norm = sum[0];
    for (double& moment : sum) moment /= norm;
    return sum;
}

}  // namespace neph
