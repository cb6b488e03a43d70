// canvas.h: what a figure is drawn with. Positions and sizes are in points from the upper left
// corner; colours are sRGB with opacity, 0 to 1.
#pragma once
#include <glm/glm.hpp>
#include <span>
#include <string>

namespace neph::plot {

struct RectPt {
    glm::dvec2 lower{0.0}, upper{0.0};
    glm::dvec2 size() const { return upper - lower; }
};

struct Pen {
    glm::vec4 colour{0.0f, 0.0f, 0.0f, 1.0f};
    double widthPt = 1.0;
    bool dashed = false;
};

/// Which point of a text is at the position that it is drawn at: 0 left or top, 1 right or bottom.
struct Anchor {
    double x = 0.0, y = 0.0;
};

class Canvas {
  public:
    virtual ~Canvas() = default;

    virtual void line(std::span<const glm::dvec2> points, const Pen& pen) = 0;
    /// A convex polygon.
    virtual void fill(std::span<const glm::dvec2> points, const glm::vec4& colour) = 0;
    virtual void fillRect(const RectPt& rect, const glm::vec4& colour) = 0;
    virtual void text(glm::dvec2 at, Anchor anchor, const std::string& text,
                      const glm::vec4& colour, double sizePt, bool upwards) = 0;
    virtual glm::dvec2 textSize(const std::string& text, double sizePt) = 0;
    /// What is drawn until endClip() shows within the rectangle alone.
    virtual void clip(const RectPt& rect) = 0;
    virtual void endClip() = 0;

  protected:
    Canvas() = default;
    Canvas(const Canvas&) = default;
    Canvas& operator=(const Canvas&) = default;
};

}  // namespace neph::plot
