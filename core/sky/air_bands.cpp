// air_bands.cpp: bands that stand for eight wavelengths.
#include "core/sky/air_bands.h"

#include "core/sky/air_profile.h"

namespace neph {
namespace {

constexpr std::size_t kMiddle = 4;  // 560 nm
constexpr float kDepth = 0.5f;
/// Molecules up to 12 km thin out nearly exponentially, if not by all there is: their column there
/// is right, and their density within 1.6 % below 8 km and 4 % at 10 km. [USSA76]
constexpr double kThinningM = 9552.0;

glm::dvec3 bandsOf(const Spectrum& extinctionPerM) {
    const float middlePerM = extinctionPerM.at[kMiddle];
    if (middlePerM <= 0.0f) return glm::dvec3(0.0);
    const float columnM = kDepth / middlePerM;
    const glm::dvec3 left =
        rgbOfSunlight(expMinus(columnM * extinctionPerM)) / rgbOfSunlight(Spectrum(1.0f));
    return -glm::log(left) / static_cast<double>(columnM);
}

}  // namespace

AirBands airBandsOf(const Atmosphere& air) {
    return {.moleculesPerM = bandsOf(air.moleculesPerM()),
            .hazePerM = bandsOf(air.hazePerM()),
            .moleculesHeightM = kThinningM,
            .hazeHeightM = kHazeHeightM,
            .hazeAlbedo = kHazeAlbedo};
}

}  // namespace neph
