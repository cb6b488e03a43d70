// time_bar.cpp: which time of the series is shown.
#include <fmt/format.h>
#include <imgui.h>

#include "app/ui/panels.h"

namespace neph::ui {

float timeBarHeight(const Session& session) {
    const DatasetInfo* info = session.info();
    return info == nullptr || info->times.size() < 2 ? 0.0f : 2.6f * ImGui::GetFontSize();
}

void drawTimeBar(Ui& ui) {
    const float height = timeBarHeight(ui.session());
    if (height == 0.0f) return;
    const DatasetInfo* info = ui.session().info();
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float left = columnWidth();
    int& time = ui.session().document.time;
    const int last = static_cast<int>(info->times.size()) - 1;
    if (beginFixed("##time", {left, display.y - statusHeight() - height},
                   {display.x - 2.0f * left, height})) {
        if (ImGui::ArrowButton("##back", ImGuiDir_Left) && time > 0) --time;
        ImGui::SameLine();
        if (ImGui::ArrowButton("##forth", ImGuiDir_Right) && time < last) ++time;
        ImGui::SameLine();
        ImGui::SetNextItemWidth(-1.0f);
        const std::string label = fmt::format(
            "{}   {} of {}", info->times[static_cast<std::size_t>(time)].label, time + 1, last + 1);
        // A '%' in a model's own label must not be read as a format.
        std::string format;
        for (const char c : label) format += c == '%' ? std::string("%%") : std::string(1, c);
        ImGui::SliderInt("##slider", &time, 0, last, format.c_str(), ImGuiSliderFlags_AlwaysClamp);
    }
    ImGui::End();
}

}  // namespace neph::ui
