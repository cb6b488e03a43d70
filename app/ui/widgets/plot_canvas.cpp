// plot_canvas.cpp: strokes and letters by ImDrawList.
#include "app/ui/widgets/plot_canvas.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/ui/widgets/input.h"
#include "app/ui/widgets/places.h"

namespace neph::ui {
namespace {

constexpr float kDashPx = 5.0f, kGapPx = 3.0f;

ImVec2 toIm(glm::dvec2 at) {
    return {static_cast<float>(at.x), static_cast<float>(at.y)};
}

ImU32 toIm(const glm::vec4& colour) {
    return ImGui::ColorConvertFloat4ToU32({colour.r, colour.g, colour.b, colour.a});
}

/// Turns what was drawn since `first` a quarter to the left, and takes it from `drawnAt` to `to`.
void turnUpwards(ImDrawList& list, int first, ImVec2 drawnAt, ImVec2 to) {
    for (int i = first; i < list.VtxBuffer.Size; ++i) {
        ImVec2& at = list.VtxBuffer[i].pos;
        at = {to.x + (at.y - drawnAt.y), to.y - (at.x - drawnAt.x)};
    }
}

bool onDark() {
    const ImVec4 ground = ImGui::GetStyleColorVec4(ImGuiCol_WindowBg);
    return ground.x + ground.y + ground.z < 1.5f;
}

}  // namespace

void PlotCanvas::line(std::span<const glm::dvec2> points, const plot::Pen& pen) {
    const auto width = static_cast<float>(pen.widthPt);
    if (!pen.dashed) {
        std::vector<ImVec2> line;
        for (const glm::dvec2& at : points) line.push_back(toIm(at));
        list_.AddPolyline(line.data(), static_cast<int>(line.size()), toIm(pen.colour), 0, width);
        return;
    }
    float phase = 0.0f;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const glm::vec2 from(points[i]), to(points[i + 1]);
        const float length = glm::distance(from, to);
        for (float at = -phase; at < length; at += kDashPx + kGapPx) {
            const float a = std::max(at, 0.0f), b = std::min(at + kDashPx, length);
            if (b <= a) continue;
            list_.AddLine(toIm(glm::mix(from, to, a / length)),
                          toIm(glm::mix(from, to, b / length)), toIm(pen.colour), width);
        }
        phase = std::fmod(phase + length, kDashPx + kGapPx);
    }
}

void PlotCanvas::fill(std::span<const glm::dvec2> points, const glm::vec4& colour) {
    std::vector<ImVec2> corners;
    for (const glm::dvec2& at : points) corners.push_back(toIm(at));
    list_.AddConvexPolyFilled(corners.data(), static_cast<int>(corners.size()), toIm(colour));
}

void PlotCanvas::fillRect(const plot::RectPt& rect, const glm::vec4& colour) {
    list_.AddRectFilled(toIm(rect.lower), toIm(rect.upper), toIm(colour));
}

void PlotCanvas::text(glm::dvec2 at, plot::Anchor anchor, const std::string& text,
                      const glm::vec4& colour, double sizePt, bool upwards) {
    const glm::dvec2 size = textSize(text, sizePt);
    const int first = list_.VtxBuffer.Size;
    glm::dvec2 start = at - glm::dvec2(anchor.x, anchor.y) * size;
    // The anchor is that of the turned text.
    if (upwards) start = at + glm::dvec2(-anchor.x * size.y, (1.0 - anchor.y) * size.x);
    // Letters that lie outside before they are turned would be left out.
    const ImVec2 drawnAt = upwards ? list_.GetClipRectMin() : toIm(start);
    list_.AddText(ImGui::GetFont(), static_cast<float>(sizePt), drawnAt, toIm(colour),
                  text.c_str());
    if (upwards) turnUpwards(list_, first, drawnAt, toIm(start));
}

glm::dvec2 PlotCanvas::textSize(const std::string& text, double sizePt) {
    const ImVec2 size =
        ImGui::GetFont()->CalcTextSizeA(static_cast<float>(sizePt), 1e6f, 0.0f, text.c_str());
    return {static_cast<double>(size.x), static_cast<double>(size.y)};
}

void PlotCanvas::clip(const plot::RectPt& rect) {
    list_.PushClipRect(toIm(rect.lower), toIm(rect.upper), true);
}

void PlotCanvas::endClip() {
    list_.PopClipRect();
}

ShownPlot showPlot(const char* id, const plot::Figure& figure, ImVec2 size, bool tells) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton(id, size);
    place(id);
    const bool hovered = ImGui::IsItemHovered();
    const bool clicked = ImGui::IsItemClicked();
    PlotCanvas canvas(*ImGui::GetWindowDrawList());
    const glm::dvec2 lower(static_cast<double>(at.x), static_cast<double>(at.y));
    const glm::dvec2 room(static_cast<double>(size.x), static_cast<double>(size.y));
    const plot::Style style{onDark(), static_cast<double>(ImGui::GetFontSize()) * 0.9};
    ShownPlot shown;
    shown.frame = plot::draw(figure, {lower, lower + room}, canvas, style);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const glm::dvec2 mousePt(static_cast<double>(mouse.x), static_cast<double>(mouse.y));
    if (!hovered || !shown.frame.contains(mousePt)) return shown;
    shown.hoveredAt = shown.frame.toAxes(mousePt);
    if (clicked) shown.clickedAt = shown.hoveredAt;
    if (!tells || !wantsTooltip()) return shown;
    ImGui::SetTooltip("%s", plot::readout(figure, shown.frame, mousePt).c_str());
    return shown;
}

}  // namespace neph::ui
