// image_label.cpp: drawn behind all panels.
#include "app/ui/widgets/image_label.h"

namespace neph::ui {
namespace {

constexpr ImU32 kLabelPlate = IM_COL32(20, 22, 26, 190);
constexpr ImU32 kLabelText = IM_COL32(235, 238, 242, 255);
constexpr ImU32 kMarkedText = IM_COL32(120, 180, 240, 255);

}  // namespace

void imageLabel(const char* text, ImVec2 at, float alignX, bool marked) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const ImVec2 size = ImGui::CalcTextSize(text);
    const float pad = 0.4f * ImGui::GetFontSize();
    const ImVec2 lower{at.x - alignX * (size.x + 2.0f * pad), at.y};
    list.AddRectFilled(lower, {lower.x + size.x + 2.0f * pad, lower.y + size.y + pad}, kLabelPlate,
                       pad);
    list.AddText({lower.x + pad, lower.y + pad / 2.0f}, marked ? kMarkedText : kLabelText, text);
}

}  // namespace neph::ui
