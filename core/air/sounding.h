// sounding.h: the air of one column as a balloon would find it.
#pragma once
#include <algorithm>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

namespace neph {

/// Air at one height.
struct SoundingLevel {
    double pressurePa = 0.0;
    double heightM = 0.0;  ///< above sea level
    double temperatureK = 0.0;
    double vapourRatio = 0.0;  ///< kg per kg of dry air
    /// Along the grid's x and y, m/s, as the data state it (CM1: relative to a grid that moves);
    /// where they have it.
    std::optional<glm::dvec2> windMPerS = {};
};

/// From the ground up; pressure falls from level to level.
struct Sounding {
    double groundM = 0.0;  ///< above sea level
    std::vector<SoundingLevel> levels;

    bool hasWind() const {
        return std::ranges::any_of(
            levels, [](const SoundingLevel& level) { return level.windMPerS.has_value(); });
    }
};

/// Air between two levels: linear in the logarithm of pressure, that of the ends beyond them.
SoundingLevel levelAt(const Sounding& sounding, double pressurePa);

/// Wind at a height above the ground, linear in height between the levels that have it; that of the
/// ends beyond them. The sounding has wind.
glm::dvec2 windAt(const Sounding& sounding, double aboveGroundM);

/// How far above the ground its wind is known: half a layer above the highest level that has it.
double windTopM(const Sounding& sounding);

}  // namespace neph
