// frame.cpp: puts the panels where the layout has room for them.
#include "app/ui/shell/frame.h"

#include <imgui.h>
#include <imgui_internal.h>  // popups and focus

#include <algorithm>

#include "app/ui/camera/camera_drag.h"
#include "app/ui/shell/context.h"
#include "app/ui/shell/panel_table.h"
#include "app/ui/shell/wishes.h"
#include "app/ui/time/path_lead.h"
#include "app/ui/time/time_bar.h"
#include "app/ui/widgets/fixed_window.h"
#include "app/ui/widgets/input.h"
#include "app/ui/widgets/places.h"
#include "app/ui/widgets/theme.h"

namespace neph::ui {
namespace {

constexpr float kMarkEms = 0.18f;  // half the size of the mark on an edge

/// A column's edge: a drag makes it wider or narrower, a click opens or closes it. `side` is 1
/// where the column is to the left of it.
void drawEdge(const char* name, const Area& area, float side, bool& open, float& ems) {
    if (area.empty()) return;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0f, 0.0f});
    const bool drawn = beginFixed(name, area.lower, area.size());
    ImGui::PopStyleVar();
    if (drawn) {
        const glm::vec2 size = area.size();
        ImGui::InvisibleButton("##edge", {size.x, size.y});
        place(side > 0.0f ? "view.left" : "view.right");
        const float dragged = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left).x;
        if (open && ImGui::IsItemActive() && dragged != 0.0f) {
            ems = std::clamp(ems + side * ImGui::GetIO().MouseDelta.x / ImGui::GetFontSize(),
                             kLeastColumnEms, kMostColumnEms);
        }
        if (ImGui::IsItemDeactivated() && dragged == 0.0f) open = !open;
        const bool hot = ImGui::IsItemHovered() || ImGui::IsItemActive();
        if (hot) {
            ImGui::SetMouseCursor(open ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_Hand);
            tooltip(open ? "Click to close, drag to resize" : "Click to open");
        }
        const ImU32 colour = ImGui::GetColorU32(hot ? ImGuiCol_CheckMark : ImGuiCol_TextDisabled);
        // A mark that points where a click would move the edge.
        const float half = kMarkEms * ImGui::GetFontSize() * (open ? -side : side);
        const glm::vec2 at = (area.lower + area.upper) / 2.0f;
        const float tall = 2.0f * std::abs(half);
        ImGui::GetWindowDrawList()->AddTriangleFilled(
            {at.x - half, at.y - tall}, {at.x - half, at.y + tall}, {at.x + half, at.y}, colour);
    }
    ImGui::End();
}

/// What one panel asks of another is there before the next is drawn.
void drawPlace(Ui& ui, PanelPlace at) {
    for (const Panel& panel : panels()) {
        if (panel.place != at || (panel.shown != nullptr && !(ui.*panel.shown))) continue;
        panel.draw(ui);
        carryOutWishes(ui);
    }
}

/// Scrolls where it holds more than there is room for.
void drawColumn(Ui& ui, const char* name, const Area& area, PanelPlace at) {
    if (area.empty()) return;
    if (beginFixed(name, area.lower, area.size(), 0)) drawPlace(ui, at);
    ImGui::End();
}

void drawColumns(Ui& ui, const Layout& layout) {
    drawColumn(ui, "##left", layout.left, PanelPlace::left);
    drawColumn(ui, "##right", layout.right, PanelPlace::right);
    bool left = !layout.left.empty(), right = !layout.right.empty();
    drawEdge("##left edge", layout.leftEdge, 1.0f, left, ui.settings.leftColumnEms);
    drawEdge("##right edge", layout.rightEdge, -1.0f, right, ui.settings.rightColumnEms);
    if (left == layout.left.empty()) openColumn(ui.settings, ui.columns, true, left);
    if (right == layout.right.empty()) openColumn(ui.settings, ui.columns, false, right);
}

/// All that stands around the image.
void drawAround(Ui& ui) {
    const Layout layout = ui.layout();
    drawPlace(ui, PanelPlace::top);
    drawColumns(ui, layout);
    drawPlace(ui, PanelPlace::bottom);
}

/// A menu or dialog that was there before this frame is closed by Escape.
void closeOnEscape(int popupsBefore) {
    const int popups = GImGui->OpenPopupStack.Size;
    const bool escape = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
    if (escape && popups > 0 && popups == popupsBefore) {
        ImGui::ClosePopupToLevel(popups - 1, true);
    }
}

}  // namespace

void draw(Ui& ui) {
    takeDecimalCommas();
    const int popups = GImGui->OpenPopupStack.Size;
    const PanelContext context = contextOf(ui);
    playOn(context, ui.playback, imageTimeOf(ui));
    keepOwnCamera(ui.session(), ui.playback);
    ui.cameraTools.leftTaken = ui.ask.drawing;
    moveCamera(context, ui.cameraTools);
    drawPlace(ui, PanelPlace::image);
    if (ui.columns.shown) drawAround(ui);
    drawPlace(ui, PanelPlace::over);
    closeOnEscape(popups);
    if (lacksGlyphs()) {
        ui.requests.restyle = true;
        ui.next.again(0.0);
    }
    ui.next.animates |= inputUnsettled();
}

}  // namespace neph::ui
