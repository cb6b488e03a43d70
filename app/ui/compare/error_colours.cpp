// error_colours.cpp: the image of errors, and its colour bar.
#include "app/ui/compare/error_colours.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/base/number_text.h"

namespace neph::ui {
namespace {

constexpr float kBarLengthEms = 22.0f, kScaleHeightEms = 0.7f;  // in letters
constexpr int kScaleSteps = 64;
constexpr ImU32 kScalePlate = IM_COL32(20, 22, 26, 210);
constexpr ImU32 kScaleText = IM_COL32(235, 238, 242, 255);

ImU32 scaleColour(double error, const ErrorScale& scale) {
    const glm::vec3 colour = errorColour(error, scale);
    return ImGui::GetColorU32({colour.x, colour.y, colour.z, 1.0f});
}

/// Below the image of errors: what its colours mean.
void drawErrorBar(const Area& area, const ErrorScale& scale, const char* meaning) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const float em = ImGui::GetFontSize();
    const float width = std::min(kBarLengthEms * em, 0.6f * area.size().x);
    const ImVec2 at{(area.lower.x + area.upper.x - width) / 2.0f, area.upper.y - 3.2f * em};
    list.AddRectFilled({at.x - 3.0f * em, at.y - 0.6f * em},
                       {at.x + width + 3.0f * em, at.y + 2.4f * em}, kScalePlate, 0.4f * em);
    const float step = width / kScaleSteps;
    for (int i = 0; i < kScaleSteps; ++i) {
        const double error = scale.most * (2.0 * (i + 0.5) / kScaleSteps - 1.0);
        const float x = at.x + step * static_cast<float>(i);
        list.AddRectFilled({x, at.y}, {x + step + 0.5f, at.y + kScaleHeightEms * em},
                           scaleColour(error, scale));
    }
    const std::string most = numberText(100.0 * scale.most, 3);
    const std::array<std::string, 3> labels{"-" + most + " %", meaning, most + " %"};
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const ImVec2 size = ImGui::CalcTextSize(labels[i].c_str());
        const float middle = at.x + width * static_cast<float>(i) / 2.0f;
        list.AddText({middle - size.x / 2.0f, at.y + 0.9f * em}, kScaleText, labels[i].c_str());
    }
}

}  // namespace

void drawErrorColours(const Area& area, unsigned texture, const ErrorScale& scale,
                      const char* meaning) {
    ImGui::GetBackgroundDrawList()->AddImage(
        reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture)),
        {area.lower.x, area.lower.y}, {area.upper.x, area.upper.y});
    drawErrorBar(area, scale, meaning);
}

}  // namespace neph::ui
