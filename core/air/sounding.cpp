// sounding.cpp: interpolation between levels.
#include "core/air/sounding.h"

#include <algorithm>
#include <cmath>

namespace neph {
namespace {

SoundingLevel between(const SoundingLevel& a, const SoundingLevel& b, double share) {
    SoundingLevel level;
    const auto mix = [&](double SoundingLevel::*of) { level.*of = std::lerp(a.*of, b.*of, share); };
    level.pressurePa = a.pressurePa * std::pow(b.pressurePa / a.pressurePa, share);
    mix(&SoundingLevel::heightM);
    mix(&SoundingLevel::temperatureK);
    mix(&SoundingLevel::vapourRatio);
    if (a.windMPerS && b.windMPerS) level.windMPerS = glm::mix(*a.windMPerS, *b.windMPerS, share);
    return level;
}

}  // namespace

SoundingLevel levelAt(const Sounding& sounding, double pressurePa) {
    const auto& levels = sounding.levels;
    const auto above = std::ranges::find_if(
        levels, [&](const SoundingLevel& level) { return level.pressurePa <= pressurePa; });
    if (above == levels.begin()) return levels.front();
    if (above == levels.end()) return levels.back();
    const SoundingLevel& below = *(above - 1);
    return between(
        below, *above,
        std::log(pressurePa / below.pressurePa) / std::log(above->pressurePa / below.pressurePa));
}

glm::dvec2 windAt(const Sounding& sounding, double aboveGroundM) {
    const double heightM = sounding.groundM + aboveGroundM;
    const SoundingLevel* below = nullptr;
    for (const SoundingLevel& level : sounding.levels) {
        if (!level.windMPerS) continue;
        if (level.heightM < heightM) {
            below = &level;
            continue;
        }
        if (below == nullptr) return *level.windMPerS;
        const double share = (heightM - below->heightM) / (level.heightM - below->heightM);
        return glm::mix(*below->windMPerS, *level.windMPerS, share);
    }
    return below == nullptr ? glm::dvec2(0.0) : *below->windMPerS;
}

double windTopM(const Sounding& sounding) {
    const auto& levels = sounding.levels;
    std::size_t last = levels.size();
    while (last > 0 && !levels[last - 1].windMPerS) --last;
    if (last == 0) return 0.0;
    const double height = levels[last - 1].heightM;
    const double below = last > 1 ? levels[last - 2].heightM : sounding.groundM;
    return height + 0.5 * (height - below) - sounding.groundM;
}

}  // namespace neph
