// haze.h: how far one sees in the air of a look: as it says, or as the humidity of data has it.
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

/// Whether the look needs the humidity of the lowest air.
bool asksHumidity(const Look& look);

/// The haze of one image.
struct HazeState {
    double visibilityM = 0.0;        ///< near the ground, at a contrast of 0.02
    std::optional<double> humidity;  ///< what it follows from, 0 to 1; empty: the look
};

/// The haze over `where`: where a humidity is asked for and not known, that of `sky.visibility`.
HazeState hazeOf(const Look& look, const Whereabouts& where);

/// "visibility 29.7 km by a relative humidity of 70 % of the lowest air", or "visibility 100 km".
std::string hazeText(const HazeState& haze);

/// For the notes of a time, why haze does not follow the humidity although the look asks for it;
/// empty where it does. `reason` is VolumeSummary::noHumidity.
std::string hazeNote(const Look& look, std::string_view timeLabel, std::string_view reason);

/// The look that engines draw of `where`: the same with the sun by angles (withSun) and a fixed
/// haze.
Look lookAsDrawn(const Look& look, const Whereabouts& where);

}  // namespace neph
