// notice_box.cpp: as wide as its words, up to what the image has room for.
#include "app/ui/panel/notice_box.h"

#include <imgui.h>

#include <algorithm>

namespace neph::ui {
namespace {

constexpr float kNoticeEms = 34.0f;

}  // namespace

float noticeWidth(const Area& image) {
    const float em = ImGui::GetFontSize();
    return std::min(kNoticeEms * em, std::max(image.size().x - 2.0f * em, 4.0f * em));
}

bool beginNotice(const Area& image, const char* name, NoticeAt at) {
    const float em = ImGui::GetFontSize();
    const glm::vec2 room = glm::max(image.size() - 2.0f * em, glm::vec2(4.0f * em));
    const float width = noticeWidth(image);
    const float share = at == NoticeAt::top ? 0.0f : at == NoticeAt::middle ? 0.5f : 1.0f;
    const float top = image.lower.y + em + share * room.y;
    ImGui::SetNextWindowPos({(image.lower.x + image.upper.x) / 2.0f, top}, ImGuiCond_Always,
                            {0.5f, share});
    ImGui::SetNextWindowSizeConstraints({0.0f, 0.0f}, {width, room.y});
    const bool open =
        ImGui::Begin(name, nullptr,
                     ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                         ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_AlwaysAutoResize |
                         ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                         ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PushTextWrapPos(width - 2.0f * ImGui::GetStyle().WindowPadding.x);
    return open;
}

void endNotice() {
    ImGui::PopTextWrapPos();
    ImGui::End();
}

}  // namespace neph::ui
