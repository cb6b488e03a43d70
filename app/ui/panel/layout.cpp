// layout.cpp: sizes in letters, tuned by eye at 960 x 600, 1280 x 720 and 1920 x 1080.
#include "app/ui/panel/layout.h"

#include <imgui.h>

#include <algorithm>

namespace neph::ui {
namespace {

constexpr float kLeastImageEms = 12.0f;  // else there is nothing to look at
constexpr float kEdgeEms = 0.75f;
constexpr float kTimeEms = 4.1f;  // two rows
constexpr float kStatusEms = 1.75f;

struct Widths {
    float left = 0.0f, right = 0.0f;  // 0: closed
};

/// In letters, in a window so many letters wide.
Widths widthsIn(float window, const Settings& settings, const Columns& columns) {
    Widths widths{settings.leftColumn ? settings.leftColumnEms : 0.0f,
                  settings.rightColumn ? settings.rightColumnEms : 0.0f};
    const float room = window - 2.0f * kEdgeEms - kLeastImageEms;
    if (widths.left > 0.0f && widths.right > 0.0f && room < 2.0f * kLeastColumnEms) {
        (columns.leftLast ? widths.right : widths.left) = 0.0f;
    }
    const float wanted = widths.left + widths.right;
    if (wanted <= room) return widths;
    // Both yield in proportion, though never below what their widgets need.
    for (float* width : {&widths.left, &widths.right}) {
        if (*width > 0.0f) *width = std::max(kLeastColumnEms, *width * room / wanted);
    }
    const float over = widths.left + widths.right - room;
    if (over > 0.0f && widths.left > 0.0f && widths.right > 0.0f) {
        (widths.left > widths.right ? widths.left : widths.right) -= over;
    }
    return widths;
}

}  // namespace

void openColumn(Settings& settings, Columns& columns, bool left, bool open) {
    (left ? settings.leftColumn : settings.rightColumn) = open;
    if (open) columns.leftLast = left;
}

bool hasTimeBar(const Session& session) {
    const DatasetInfo* info = session.info();
    return (info != nullptr && info->times.size() > 1) || session.ensemble() != nullptr ||
           session.document.path.keys.size() > 1;
}

Layout layoutOf(const Session& session, const Settings& settings, const Columns& columns) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const glm::vec2 window = glm::max(glm::vec2(display.x, display.y), 1.0f);
    Layout layout;
    layout.image = {glm::vec2(0.0f), window};
    if (!columns.shown) return layout;
    const float em = ImGui::GetFontSize();
    const auto whole = [](float pixels) { return glm::round(pixels); };
    const float top = whole(em + 2.0f * ImGui::GetStyle().FramePadding.y);
    const float statusTop = whole(window.y - kStatusEms * em);
    const float bottom = hasTimeBar(session) ? whole(statusTop - kTimeEms * em) : statusTop;
    const Widths widths = widthsIn(window.x / em, settings, columns);
    const float left = whole(widths.left * em), right = whole(window.x - widths.right * em);
    const float edge = whole(kEdgeEms * em);
    layout.menu = {{0.0f, 0.0f}, {window.x, top}};
    layout.left = {{0.0f, top}, {left, bottom}};
    layout.leftEdge = {{left, top}, {left + edge, bottom}};
    layout.rightEdge = {{right - edge, top}, {right, bottom}};
    layout.right = {{right, top}, {window.x, bottom}};
    layout.time = {{0.0f, bottom}, {window.x, statusTop}};
    layout.status = {{0.0f, statusTop}, window};
    layout.image = {{left + edge, top}, {right - edge, bottom}};
    return layout;
}

PixelBox imageBox(const Layout& layout) {
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
    const float height = ImGui::GetIO().DisplaySize.y;
    const Area& image = layout.image;
    const glm::vec2 factor{scale.x, scale.y};
    const glm::vec2 lower{image.lower.x, height - image.upper.y};
    const glm::vec2 upper{image.upper.x, height - image.lower.y};
    const glm::ivec2 corner = glm::max(glm::ivec2(glm::round(lower * factor)), 0);
    return {corner, glm::max(corner + 1, glm::ivec2(glm::round(upper * factor)))};
}

}  // namespace neph::ui
