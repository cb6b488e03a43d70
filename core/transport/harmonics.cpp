// harmonics.cpp: the basis, written out.
#include "core/transport/harmonics.h"

#include <cmath>
#include <numbers>

namespace neph {

Harmonics harmonicsAt(const glm::dvec3& travel, const glm::dvec3& sunTravel) {
    constexpr double kSphere = 4.0 * std::numbers::pi;
    const double a = std::sqrt(1.0 / kSphere), b = std::sqrt(3.0 / kSphere);
    const double c = std::sqrt(15.0 / kSphere), d = std::sqrt(5.0 / kSphere) / 2.0;
    const double x = travel.x, y = travel.y, z = travel.z;
    const std::array<double, kBroadMoments> broad{a,
                                                  b * y,
                                                  b * z,
                                                  b * x,
                                                  c * x * y,
                                                  c * y * z,
                                                  d * (3.0 * z * z - 1.0),
                                                  c * x * z,
                                                  c * (x * x - y * y) / 2.0};
    Harmonics value{};
    for (std::size_t q = 0; q < broad.size(); ++q) value[q] = static_cast<float>(broad[q]);
    const auto legendre = legendreAt<kAlignedDegrees>(glm::dot(travel, sunTravel));
    for (std::size_t l = kBroadDegrees; l < legendre.size(); ++l) {
        const double norm = std::sqrt((2.0 * static_cast<double>(l) + 1.0) / kSphere);
        value[l + 6] = static_cast<float>(norm * legendre[l]);
    }
    return value;
}

}  // namespace neph
