// light_medium.cpp: delta-M scaling. [Wiscombe77]
#include "core/transport/light_medium.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shaders/lib/glsl_cpp.h"

namespace neph {

double SkyLight::radianceAt(const glm::dvec3& towards) const {
    if (dome) return dome->patterns[pattern].at(towards, dome->towardsSun);
    const glm::vec3 radiance =
        glsl::skyRadiance(static_cast<float>(towards.z), glm::vec3(static_cast<float>(zenith)),
                          glm::vec3(static_cast<float>(horizon)));
    return static_cast<double>(radiance.x);
}

double SkyLight::irradiance() const {
    if (dome) return std::numbers::pi;  // of any pattern
    constexpr int kBands = 2000;
    double sum = 0.0;
    for (int i = 0; i < kBands; ++i) {
        const double up = (i + 0.5) / kBands;
        sum += 2.0 * std::numbers::pi / kBands * up * radianceAt({0.0, 0.0, up});
    }
    return sum;
}

namespace {

/// Along one axis, (1, 2, 1) / 4; beyond the ends there is nothing, or the other end.
Array3f halvedAlong(int axis, bool periodic, const Array3f& fine) {
    glm::ivec3 size = fine.size;
    const int count = fine.size[axis];
    size[axis] = count / 2 + (periodic ? 0 : 1);
    Array3f coarse(size);
    const auto valueAt = [&](glm::ivec3 node, int place) {
        node[axis] = periodic ? (place + count) % count : place;
        return node[axis] < 0 || node[axis] >= count ? 0.0f : fine.at(node.x, node.y, node.z);
    };
    std::size_t index = 0;
    for (int k = 0; k < size.z; ++k) {
        for (int j = 0; j < size.y; ++j) {
            for (int i = 0; i < size.x; ++i) {
                const glm::ivec3 node{i, j, k};
                const int at = 2 * node[axis];
                coarse.values[index++] = 0.5f * valueAt(node, at) +
                                         0.25f * (valueAt(node, at - 1) + valueAt(node, at + 1));
            }
        }
    }
    return coarse;
}

}  // namespace

LightMedium halved(const LightMedium& medium, bool periodicSides) {
    constexpr int kFewest = 5;
    LightMedium coarse = medium;
    for (int axis = 0; axis < 3; ++axis) {
        const bool periodic = periodicSides && axis < 2;
        if (medium.nodes[axis] < kFewest || (periodic && medium.nodes[axis] % 2 != 0)) continue;
        coarse.nodes[axis] = medium.nodes[axis] / 2 + (periodic ? 0 : 1);
        coarse.spacingM[axis] *= 2.0;
        for (LightClass& light : coarse.classes) {
            light.extinctionPerM = halvedAlong(axis, periodic, light.extinctionPerM);
        }
    }
    return coarse;
}

double forwardShare(const LightClass& light, bool aligned, double thickness) {
    const auto momentOf = [&](int l) {
        return std::max(0.0, light.moments[static_cast<std::size_t>(l)]);
    };
    const double broad = momentOf(kBroadDegrees);
    const double thin = aligned ? momentOf(kAlignedDegrees) : broad;
    return glm::mix(glm::mix(thin, broad, std::min(thickness, 1.0)), momentOf(1),
                    std::max(thickness - 1.0, 0.0));
}

double thicknessLengthM(const glm::dvec3& spacingM) {
    // The bounds of thickness were found with nodes that are 2.5 times as wide as high.
    constexpr double kFlattest = 2.5;
    return std::min(meanCellM(glm::dvec2(spacingM)), kFlattest * spacingM.z);
}

double lightThickness(const LightMedium& medium, double extinctionPerM) {
    // Tuned on a storm.
    constexpr double kThin = 1.0, kThick = 4.0, kTowardsIsotropic = 10.0, kIsotropic = 30.0;
    const double depth = extinctionPerM * thicknessLengthM(medium.spacingM);
    const auto between = [&](double from, double to) {
        return std::clamp((depth - from) / (to - from), 0.0, 1.0);
    };
    return between(kThin, kThick) + between(kTowardsIsotropic, kIsotropic);
}

ScaledOptics scaledOptics(const LightClass& light, double extinctionPerM, bool aligned,
                          double thickness) {
    const double share = forwardShare(light, aligned, thickness);
    const double scattering = light.singleScattering * extinctionPerM;
    ScaledOptics scaled;
    scaled.absorptionPerM = extinctionPerM - scattering;
    scaled.extinctionPerM = scaled.absorptionPerM + scattering * (1.0 - share);
    for (std::size_t l = 0; l < scaled.scatteringPerM.size(); ++l) {
        // More than there is of a degree is not taken away.
        const double least = l < kBroadDegrees ? std::min(0.0, light.moments[l]) : 0.0;
        scaled.scatteringPerM[l] = scattering * std::max(light.moments[l] - share, least);
    }
    return scaled;
}

}  // namespace neph
