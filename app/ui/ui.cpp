// ui.cpp: the layout: a column each side, the time between them, the status along the bottom.
#include "app/ui/ui.h"

#include <imgui.h>

#include "app/ui/panels.h"

namespace neph::ui {
namespace {

constexpr float kColumnEms = 24.0f;  // width of a column in letters; two leave half of 1280 pixels
constexpr float kStatusLines = 1.9f;

void drawColumns(Ui& ui) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float height = display.y - statusHeight();
    if (beginFixed("##left", {0.0f, 0.0f}, {columnWidth(), height})) {
        drawFields(ui);
        drawData(ui);
    }
    ImGui::End();
    if (beginFixed("##right", {display.x - columnWidth(), 0.0f}, {columnWidth(), height})) {
        drawPresets(ui);
        drawGroups(ui);
    }
    ImGui::End();
}

}  // namespace

float columnWidth() {
    return kColumnEms * ImGui::GetFontSize();
}

float statusHeight() {
    return kStatusLines * ImGui::GetFontSize();
}

bool beginFixed(const char* name, glm::vec2 at, glm::vec2 size) {
    ImGui::SetNextWindowPos({at.x, at.y});
    ImGui::SetNextWindowSize({size.x, size.y});
    return ImGui::Begin(name, nullptr,
                        ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                            ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoCollapse |
                            ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                            ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoBringToFrontOnFocus);
}

PixelBox pictureBox(const Ui& ui) {
    const ImGuiIO& io = ImGui::GetIO();
    glm::vec2 lower{0.0f}, upper{io.DisplaySize.x, io.DisplaySize.y};
    if (ui.showPanels) {
        lower = {columnWidth(), statusHeight() + timeBarHeight(ui.session())};
        upper.x -= columnWidth();
    }
    const glm::vec2 scale{io.DisplayFramebufferScale.x, io.DisplayFramebufferScale.y};
    const glm::ivec2 corner{glm::round(lower * scale)};
    return {corner, glm::max(corner + 1, glm::ivec2(glm::round(upper * scale)))};
}

void draw(Ui& ui) {
    moveCamera(ui);
    if (ui.showPanels) {
        drawColumns(ui);
        drawTimeBar(ui);
        drawStatus(ui);
    }
    if (ui.showProfile) drawProfile(ui);
    drawNotices(ui);
    drawPathPopup(ui);
    if (ui.showHelp) drawHelp(ui);
}

}  // namespace neph::ui
