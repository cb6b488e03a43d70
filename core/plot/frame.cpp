// frame.cpp: inks, and positions on axes.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/number_text.h"
#include "core/plot/draw.h"

namespace neph::plot {
namespace {

struct InkRow {
    glm::vec3 light, dark;  ///< on light and on dark ground
};
// The hues are those of [OkabeIto08], darker on white where they would be faint.
constexpr std::array kInks{
    InkRow{{0.10f, 0.10f, 0.12f}, {0.92f, 0.93f, 0.95f}},
    InkRow{{0.80f, 0.80f, 0.82f}, {0.32f, 0.34f, 0.37f}},
    InkRow{{0.78f, 0.22f, 0.05f}, {0.98f, 0.48f, 0.30f}},
    InkRow{{0.00f, 0.39f, 0.65f}, {0.40f, 0.70f, 0.98f}},
    InkRow{{0.00f, 0.50f, 0.36f}, {0.25f, 0.82f, 0.62f}},
    InkRow{{0.80f, 0.52f, 0.00f}, {0.95f, 0.70f, 0.20f}},
    InkRow{{0.68f, 0.36f, 0.55f}, {0.90f, 0.60f, 0.78f}},
    InkRow{{0.16f, 0.58f, 0.80f}, {0.45f, 0.82f, 0.98f}},
    InkRow{{1.00f, 1.00f, 1.00f}, {0.11f, 0.12f, 0.14f}},
    InkRow{{0.62f, 0.55f, 0.47f}, {0.40f, 0.35f, 0.30f}},
};

double valueOf(const Axis& axis, double share) {
    if (!axis.logarithmic) return std::lerp(axis.from, axis.to, share);
    return axis.from * std::pow(axis.to / axis.from, share);
}

}  // namespace

double axisShare(const Axis& axis, double at) {
    if (!axis.logarithmic) return (at - axis.from) / (axis.to - axis.from);
    return std::log(std::max(at, 1e-300) / axis.from) / std::log(axis.to / axis.from);
}

glm::vec4 inkColour(Ink ink, const Style& style) {
    const InkRow& row = kInks[static_cast<std::size_t>(ink)];
    return {style.dark ? row.dark : row.light, 1.0f};
}

glm::dvec2 Frame::toPt(glm::dvec2 at) const {
    return {std::lerp(plot.lower.x, plot.upper.x, axisShare(x, at.x)),
            std::lerp(plot.upper.y, plot.lower.y, axisShare(y, at.y))};
}

glm::dvec2 Frame::toAxes(glm::dvec2 pt) const {
    const glm::dvec2 share = (pt - plot.lower) / plot.size();
    return {valueOf(x, share.x), valueOf(y, 1.0 - share.y)};
}

bool Frame::contains(glm::dvec2 pt) const {
    return glm::all(glm::greaterThanEqual(pt, plot.lower)) &&
           glm::all(glm::lessThanEqual(pt, plot.upper));
}

std::string readout(const Figure& figure, const Frame& frame, glm::dvec2 pt) {
    const glm::dvec2 at = frame.toAxes(pt);
    if (figure.meaning) return figure.meaning(at);
    std::string text = fmt::format("{}: {}\n{}: {}", figure.x.label, numberText(at.x, 3),
                                   figure.y.label, numberText(at.y, 3));
    if (!figure.field) return text;
    const Field& field = *figure.field;
    const auto cellOf = [](const std::vector<double>& edges, double value) {
        return static_cast<std::size_t>(std::ranges::upper_bound(edges, value) - edges.begin());
    };
    const std::size_t x = cellOf(field.edgesX, at.x), y = cellOf(field.edgesY, at.y);
    if (x == 0 || y == 0 || x > field.columns() || y > field.rows()) return text;
    const float value = field.values[(y - 1) * field.columns() + x - 1];
    if (!std::isfinite(value)) return text;
    return text + fmt::format("\n{}: {}", field.label, numberText(static_cast<double>(value), 3));
}

}  // namespace neph::plot
