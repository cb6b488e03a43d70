// places.cpp: rectangles by name.
#include "app/ui/widgets/places.h"

#include <imgui.h>

#include <map>

namespace neph::ui {
namespace {

bool wantedNow = false;

std::map<std::string, Area, std::less<>>& places() {
    static std::map<std::string, Area, std::less<>> known;
    return known;
}

}  // namespace

void wantPlaces(bool wanted) {
    wantedNow = wanted;
}

void clearPlaces() {
    places().clear();
}

void place(std::string_view name) {
    if (!wantedNow) return;
    const ImVec2 lower = ImGui::GetItemRectMin(), upper = ImGui::GetItemRectMax();
    place(name, {{lower.x, lower.y}, {upper.x, upper.y}});
}

void place(std::string_view name, const Area& area) {
    if (wantedNow) places().insert_or_assign(std::string(name), area);
}

std::optional<Area> placeOf(std::string_view name) {
    const auto found = places().find(name);
    if (found == places().end()) return {};
    return found->second;
}

std::vector<std::string> knownPlaces() {
    std::vector<std::string> names;
    for (const auto& [name, where] : places()) names.push_back(name);
    return names;
}

}  // namespace neph::ui
