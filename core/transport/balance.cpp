// balance.cpp: residuals of the energy balance, and how nodes follow them.
#include "core/transport/balance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/transport/grid_loops.h"

namespace neph {
namespace {

const float kIsotropicHarmonic = static_cast<float>(1.0 / std::sqrt(4.0 * std::numbers::pi));

/// `visit(node, place, what an integral around the node is multiplied by to become a mean)` of
/// balanced nodes.
template <typename Visit>
void forEachBalanced(const TransportLevel& level, const Visit& visit) {
    forEachNode(level.grid, [&](const glm::ivec3& at, std::size_t node) {
        if (level.balanced[node] <= 0.0f) return;
        const auto place = static_cast<std::size_t>(level.place[node]);
        visit(node, place, timesCut(level.grid, at) / level.aroundPerM[place]);
    });
}

}  // namespace

LightField missingFrom(const TransportLevel& level, const Swept& sums, const LightField& field,
                       const float* beam) {
    LightField missing = sums.field;
    for (std::size_t i = 0; i < missing.moments.size(); ++i) missing.moments[i] -= field.moments[i];
    for (std::size_t i = 0; i < missing.groundFlux.size(); ++i) {
        missing.groundFlux[i] -= field.groundFlux[i];
    }
    const auto moments = static_cast<std::size_t>(level.momentCount);
    const auto degrees = static_cast<std::size_t>(level.degreeCount);
    forEachBalanced(level, [&](std::size_t node, std::size_t place, float toMean) {
        const float share = level.balanced[node], albedo = level.albedo[place * degrees];
        const float lit = beam != nullptr ? albedo * kIsotropicHarmonic * beam[node] : 0.0f;
        // Not as a difference of moments, which would leave rounding alone where nodes are thick.
        const float gain = kIsotropicHarmonic * toMean * sums.excess[place] +
                           (albedo - 1.0f) * field.moments[place * moments] + lit;
        float& value = missing.moments[place * moments];
        value += share * (gain - value);
    });
    return missing;
}

std::vector<float> resistanceOf(const TransportLevel& level, const Swept& sums) {
    // Four times what an isolated change meets: with 2 the corners of clouds slowly diverge.
    constexpr float kDamping = 4.0f, kLeast = 1e-7f;
    constexpr auto kPerSphere = static_cast<float>(0.25 / std::numbers::pi);
    std::vector<float> resistance(level.activeCount, 1.0f);
    forEachBalanced(level, [&](std::size_t node, std::size_t place, float toMean) {
        const float share = level.balanced[node];
        const float* albedo = &level.albedo[place * static_cast<std::size_t>(level.degreeCount)];
        const float lost = kPerSphere * toMean * sums.exchange[place] / (1.0f - albedo[1]);
        const float own = std::clamp(lost + 1.0f - albedo[0], kLeast, 1.0f);
        resistance[place] = std::min(1.0f, kDamping * (1.0f - share + share * own));
    });
    return resistance;
}

void relax(const LightField& missing, const std::vector<float>& resistance, LightField& field) {
    const std::size_t moments = resistance.empty() ? 1 : missing.moments.size() / resistance.size();
    for (std::size_t i = 0; i < missing.moments.size(); ++i) {
        const float part = i % moments == 0 ? 1.0f / resistance[i / moments] : 1.0f;
        field.moments[i] += part * missing.moments[i];
    }
    for (std::size_t i = 0; i < missing.groundFlux.size(); ++i) {
        field.groundFlux[i] += missing.groundFlux[i];
    }
}

void limitBalanced(const TransportLevel& level, double brightest, LightField& field) {
    const auto most = static_cast<float>(brightest) / kIsotropicHarmonic;
    forEachBalanced(level, [&](std::size_t, std::size_t place, float) {
        float& value = field.moments[place * static_cast<std::size_t>(level.momentCount)];
        value = std::clamp(value, 0.0f, most);
    });
}

}  // namespace neph
