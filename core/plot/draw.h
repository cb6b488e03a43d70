// draw.h: draws a figure onto a canvas.
#pragma once
#include "core/plot/canvas.h"
#include "core/plot/figure.h"

namespace neph::plot {

/// How figures look: on paper, or on the panels of the window.
struct Style {
    bool dark = false;
    double textPt = 11.0;
};

glm::vec4 inkColour(Ink ink, const Style& style);

/// Share of the way from the axis's start to its end.
double axisShare(const Axis& axis, double at);

/// Where the axes of a figure are on a canvas.
struct Frame {
    RectPt plot;  ///< within the axes
    Axis x, y;

    glm::dvec2 toPt(glm::dvec2 at) const;
    glm::dvec2 toAxes(glm::dvec2 pt) const;
    bool contains(glm::dvec2 pt) const;
};

/// Draws `figure` into `area`, ground included, and returns where its axes are.
Frame draw(const Figure& figure, const RectPt& area, Canvas& canvas, const Style& style);

/// What is under a place of the plot, as the cursor shows it: "12.5 km, 4.2 km: 3.1 g/kg".
std::string readout(const Figure& figure, const Frame& frame, glm::dvec2 pt);

}  // namespace neph::plot
