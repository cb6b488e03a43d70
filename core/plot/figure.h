// figure.h: a plot as plain values: axes, curves, a field in colours, contours, marks.
//
// Everything is in the units of the axes. What draws one, where, and as what kind of file, is
// elsewhere: core/plot/draw.h draws it onto any canvas.
#pragma once
#include <cstddef>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace neph::plot {

/// A labelled place on an axis.
struct Tick {
    double at = 0.0;
    std::string text;
};

struct Axis {
    std::string label;  ///< with the unit: "Height, km"
    double from = 0.0, to = 1.0;
    bool logarithmic = false;  ///< both ends positive
    std::vector<Tick> ticks;   ///< none: chosen to fit
};

/// Colours that figures use, each of which has a value on light and on dark ground.
enum class Ink : int {
    foreground,
    faint,
    red,
    blue,
    green,
    orange,
    purple,
    cyan,
    background,
    ground
};

struct Curve {
    std::string label;               ///< in the legend; empty: not there
    std::vector<glm::dvec2> points;  ///< NaN interrupts it
    Ink ink = Ink::foreground;
    double width = 1.5;  ///< in points
    double opacity = 1.0;
    bool dashed = false;
    bool filledBelow = false;  ///< down to the lower end of the plot
};

enum class ColourMap : int { sequential, diverging };

/// A rectangle of cells in colours, x fastest, upwards; NaN leaves the ground as it is.
struct Field {
    std::string label;                   ///< of the colour bar, with the unit
    std::vector<double> edgesX, edgesY;  ///< one more than cells, increasing
    std::vector<float> values;
    double from = 0.0, to = 1.0;  ///< of the colours
    ColourMap map = ColourMap::sequential;

    std::size_t columns() const { return edgesX.size() - 1; }
    std::size_t rows() const { return edgesY.size() - 1; }
};

/// Lines of equal value over values at points, x fastest.
struct Contours {
    std::string label;  ///< in the legend, with the unit
    std::vector<double> x, y;
    std::vector<float> values;  ///< NaN interrupts lines
    std::vector<double> levels;
    Ink ink = Ink::foreground;
    double width = 1.0;
    bool named = true;  ///< the value is written on the line
};

/// Text at a place.
struct Mark {
    glm::dvec2 at{0.0};
    std::string text;
    Ink ink = Ink::foreground;
    bool dot = true;
};

/// A barb of wind: 5 m/s half, 10 a full one, 50 a pennant. Wind blows along `windMPerS`.
struct Barb {
    glm::dvec2 at{0.0};
    glm::dvec2 windMPerS{0.0};
};

struct Figure {
    std::string title, subtitle;
    Axis x, y;
    bool equalScale = false;  ///< of both axes, as on a map
    std::optional<Field> field;
    std::vector<Curve> curves;
    std::vector<Contours> contours;
    std::vector<Mark> marks;
    std::vector<Barb> barbs;
    /// What a place of the plot stands for, where that is not what the axes say; none: they say it.
    std::function<std::string(glm::dvec2 at)> meaning;
    /// Lines of text beside the plot: label and value.
    std::vector<std::pair<std::string, std::string>> notes;
};

/// Edges half way between increasing middles, of which there are two at least.
std::vector<double> edgesAround(const std::vector<double>& middles);

/// Round values within an axis, `most` of them or fewer, with their text.
std::vector<Tick> ticksOf(const Axis& axis, int most);

/// Round levels between the least and the greatest of values, some `count` of them.
std::vector<double> roundLevels(double least, double greatest, int count);

/// Polylines where the values are `level`, in the units of x and y.
std::vector<std::vector<glm::dvec2>> contourLines(const Contours& contours, double level);

/// sRGB, 0 to 1, of a share of the scale, 0 to 1.
glm::vec3 colourAt(ColourMap map, double share);

}  // namespace neph::plot
