// haze.cpp: humidity to visibility, within what the look's parameter can be.
#include "core/look/haze.h"

#include <fmt/format.h>

#include "core/look/sun.h"
#include "core/sky/humidity.h"

namespace neph {
namespace {

constexpr double kKm = 1e-3;

}  // namespace

bool asksHumidity(const Look& look) {
    return look.skyModel == SkyModel::atmosphere && look.haze == Haze::humidity;
}

HazeState hazeOf(const Look& look, const Whereabouts& where) {
    if (!asksHumidity(look) || !where.humidity) return {static_cast<double>(look.visibilityM), {}};
    return {visibilityOfHumidityM(*where.humidity), where.humidity};
}

std::string hazeText(const HazeState& haze) {
    const std::string text = fmt::format("visibility {:.3g} km", haze.visibilityM * kKm);
    if (!haze.humidity) return text;
    return fmt::format("{} by a relative humidity of {:.0f} % of the lowest air", text,
                       100.0 * *haze.humidity);
}

std::string hazeNote(const Look& look, std::string_view timeLabel, std::string_view reason) {
    if (!asksHumidity(look) || reason.empty()) return {};
    return fmt::format("{}: haze does not follow the humidity: {}; {} as sky.visibility has it.",
                       timeLabel, reason, hazeText(hazeOf(look, {})));
}

Look lookAsDrawn(const Look& look, const Whereabouts& where) {
    Look drawn = withSun(look, where);
    drawn.visibilityM = static_cast<float>(hazeOf(look, where).visibilityM);
    drawn.haze = Haze::fixed;
    return drawn;
}

}  // namespace neph
