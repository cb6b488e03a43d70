// places.h: where things are on the screen, by name, for recorded input and screenshots.
//
// `place` remembers the rectangle of ImGui's last item while places are wanted; otherwise it costs
// nothing. Names are ids of parameters and actions ("cloud.mixing_scale", "file.open"), or say what
// the thing is ("preset:fig06-physical", "time.slider").
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/ui/widgets/area.h"

namespace neph::ui {

void wantPlaces(bool wanted);
/// Forgets all: at the start of each frame.
void clearPlaces();
void place(std::string_view name);
/// The same of what is no item.
void place(std::string_view name, const Area& area);
std::optional<Area> placeOf(std::string_view name);
std::vector<std::string> knownPlaces();

}  // namespace neph::ui
