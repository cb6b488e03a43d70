// plot_canvas.h: plots on the panels: a canvas of ImGui, and an item that shows a figure.
#pragma once
#include <imgui.h>

#include <optional>

#include "core/plot/draw.h"

namespace neph::ui {

class PlotCanvas final : public plot::Canvas {
  public:
    explicit PlotCanvas(ImDrawList& list) : list_(list) {}

    void line(std::span<const glm::dvec2> points, const plot::Pen& pen) override;
    void fill(std::span<const glm::dvec2> points, const glm::vec4& colour) override;
    void fillRect(const plot::RectPt& rect, const glm::vec4& colour) override;
    void text(glm::dvec2 at, plot::Anchor anchor, const std::string& text, const glm::vec4& colour,
              double sizePt, bool upwards) override;
    glm::dvec2 textSize(const std::string& text, double sizePt) override;
    void clip(const plot::RectPt& rect) override;
    void endClip() override;

  private:
    ImDrawList& list_;
};

/// A figure as it was drawn, and what the mouse does to it.
struct ShownPlot {
    plot::Frame frame;
    std::optional<glm::dvec2> hoveredAt;  ///< in the units of the axes
    std::optional<glm::dvec2> clickedAt;
};

/// An item of `size` pixels, which says what is under the mouse unless the caller does.
ShownPlot showPlot(const char* id, const plot::Figure& figure, ImVec2 size, bool tells = true);

}  // namespace neph::ui
