// haze.cpp: humidity or aerosol to visibility, within what the look's parameter can be.
#include "core/look/haze.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/look/sun.h"
#include "core/sky/atmosphere.h"
#include "core/sky/humidity.h"

namespace neph {
namespace {

constexpr double kKm = 1e-3;

}  // namespace

bool asksHumidity(const Look& look) {
    return look.skyModel == SkyModel::atmosphere && look.haze != Haze::fixed;
}

double visibilityOfAerosolM(double perM) {
    return std::clamp(visibilityOfHazeM(perM), kLeastVisibilityM, kMostVisibilityM);
}

HazeState hazeOf(const Look& look, const Whereabouts& where) {
    if (!asksHumidity(look) || !where.humidity) return {static_cast<double>(look.visibilityM), {}};
    if (look.haze != Haze::aerosol || !where.aerosolPerM) {
        return {visibilityOfHumidityM(*where.humidity), where.humidity};
    }
    return {visibilityOfAerosolM(*where.aerosolPerM), where.humidity, true};
}

std::string hazeText(const HazeState& haze) {
    const std::string text = fmt::format("visibility {:.3g} km", haze.visibilityM * kKm);
    if (!haze.humidity) return text;
    const double percent = 100.0 * *haze.humidity;
    if (haze.byAerosol) {
        return fmt::format(
            "{} by the aerosol of the lowest air, at a relative humidity of {:.0f} %", text,
            percent);
    }
    return fmt::format("{} by a relative humidity of {:.0f} % of the lowest air", text, percent);
}

std::string hazeNote(const Look& look, const Whereabouts& where, std::string_view timeLabel,
                     std::string_view noHumidity, std::string_view noAerosol) {
    const bool aerosol = look.haze == Haze::aerosol;
    if (!asksHumidity(look) || (aerosol ? noAerosol : noHumidity).empty()) return {};
    std::string reason(aerosol ? noAerosol : noHumidity);
    if (!noHumidity.empty() && noHumidity != reason) reason += fmt::format(", and {}", noHumidity);
    return fmt::format("{}: haze does not follow the {}: {}; {}{}.", timeLabel,
                       aerosol ? "aerosol" : "humidity", reason, hazeText(hazeOf(look, where)),
                       where.humidity ? "" : " as sky.visibility has it");
}

Look lookAsDrawn(const Look& look, const Whereabouts& where) {
    Look drawn = withSun(look, where);
    drawn.visibilityM = static_cast<float>(hazeOf(look, where).visibilityM);
    drawn.haze = Haze::fixed;
    return drawn;
}

}  // namespace neph
