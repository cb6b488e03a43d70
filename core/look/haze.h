// haze.h: how far one sees in the air of a look: as it says, or as humidity or aerosol of data
// have it.
//
// Engines draw looks of a fixed haze whose sun stands by angles. `lookAsDrawn` makes such a look;
// whoever hands a look to a renderer calls it.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "core/geo/map_grid.h"
#include "core/look/look.h"

namespace neph {

/// The range of `sky.visibility`.
inline constexpr double kLeastVisibilityM = 2e3, kMostVisibilityM = 300e3;

/// Whether the look needs the humidity, and perhaps the aerosol, of the lowest air.
bool asksHumidity(const Look& look);

/// Visibility, m, where the model's aerosol has an extinction of `perM` at 550 nm, within the
/// above.
double visibilityOfAerosolM(double perM);

/// The haze of one image.
struct HazeState {
    double visibilityM = 0.0;        ///< near the ground, at a contrast of 0.02
    std::optional<double> humidity;  ///< what it follows from, 0 to 1; empty: the look
    bool byAerosol = false;          ///< it follows from the aerosol in air of that humidity
};

/// The haze over `where`: by what the look asks for; where there is no aerosol, by the humidity,
/// and where that is not known, that of `sky.visibility`.
HazeState hazeOf(const Look& look, const Whereabouts& where);

/// "visibility 29.7 km by a relative humidity of 70 % of the lowest air", "visibility 100 km", or
/// "visibility 164 km by the aerosol of the lowest air, at a relative humidity of 70 %".
std::string hazeText(const HazeState& haze);

/// For the notes of a time, why haze over `where` does not follow what the look asks for, and what
/// it follows instead; empty where it does. The reasons are VolumeSummary::noHumidity and
/// noAerosol.
std::string hazeNote(const Look& look, const Whereabouts& where, std::string_view timeLabel,
                     std::string_view noHumidity, std::string_view noAerosol);

/// The look that engines draw of `where`: the same with the sun by angles (withSun) and a fixed
/// haze.
Look lookAsDrawn(const Look& look, const Whereabouts& where);

}  // namespace neph
