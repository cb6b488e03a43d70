// light_medium.cpp: delta-M scaling. [Wiscombe77]
#include "core/transport/light_medium.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shaders/lib/glsl_cpp.h"

namespace neph {

double SkyLight::radianceAt(double up) const {
    const glm::vec3 radiance =
        glsl::skyRadiance(static_cast<float>(up), glm::vec3(static_cast<float>(zenith)),
                          glm::vec3(static_cast<float>(horizon)));
    return static_cast<double>(radiance.x);
}

double SkyLight::irradiance() const {
    constexpr int kBands = 2000;
    double sum = 0.0;
    for (int i = 0; i < kBands; ++i) {
        const double up = (i + 0.5) / kBands;
        sum += 2.0 * std::numbers::pi / kBands * up * radianceAt(up);
    }
    return sum;
}

double forwardShare(const LightClass& light, bool aligned, double thickness) {
    // What is kept of the phase function ends at l = 2, or at l = 8 where the nodes are thin.
    const double broad = std::max(0.0, light.moments[kBroadDegrees]);
    if (!aligned) return broad;
    const double narrow = std::max(0.0, light.moments[kAlignedDegrees]);
    return narrow + thickness * (broad - narrow);
}

double lightThickness(const LightMedium& medium, double extinctionPerM) {
    // Tuned on a storm: f of l = 8 up to an optical depth of 1 between nodes, of l = 2 from 4 on.
    constexpr double kThin = 1.0, kThick = 4.0;
    const double depth = extinctionPerM * meanCellM(glm::dvec2(medium.spacingM));
    return std::clamp((depth - kThin) / (kThick - kThin), 0.0, 1.0);
}

ScaledOptics scaledOptics(const LightClass& light, double extinctionPerM, bool aligned,
                          double thickness) {
    const double share = forwardShare(light, aligned, thickness);
    const double scattering = light.singleScattering * extinctionPerM;
    ScaledOptics scaled;
    scaled.extinctionPerM = extinctionPerM - scattering * share;
    for (std::size_t l = 0; l < scaled.scatteringPerM.size(); ++l) {
        const double left = scattering * (light.moments[l] - share);
        scaled.scatteringPerM[l] = l < kBroadDegrees ? left : std::max(0.0, left);
    }
    return scaled;
}

}  // namespace neph
