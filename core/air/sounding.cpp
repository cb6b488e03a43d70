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
    const auto& levels = sounding.levels;
    const double heightM = sounding.groundM + aboveGroundM;
    const auto above = std::ranges::find_if(
        levels, [&](const SoundingLevel& level) { return level.heightM >= heightM; });
    if (above == levels.begin()) return levels.front().windMPerS.value_or(glm::dvec2(0.0));
    if (above == levels.end()) return levels.back().windMPerS.value_or(glm::dvec2(0.0));
    const SoundingLevel& below = *(above - 1);
    const double share = (heightM - below.heightM) / (above->heightM - below.heightM);
    return between(below, *above, share).windMPerS.value_or(glm::dvec2(0.0));
}

}  // namespace neph
