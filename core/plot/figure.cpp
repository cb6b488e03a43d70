// figure.cpp: ticks, levels, contours and colours.
#include "core/plot/figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/number_text.h"

namespace neph::plot {
namespace {

/// The round step, 1, 2 or 5 times a power of ten, that gives at most `most` steps.
double roundStep(double span, int most) {
    const double least = span / most;
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= least * (1.0 - 1e-9)) return factor * power;
    }
    return 10.0 * power;
}

std::vector<Tick> logarithmicTicks(double least, double greatest, int most) {
    std::vector<Tick> ticks;
    const int first = static_cast<int>(std::ceil(std::log10(least) - 1e-9));
    const int last = static_cast<int>(std::floor(std::log10(greatest) + 1e-9));
    const int stride = std::max(1, (last - first + most) / most);
    for (int power = first; power <= last; power += stride) {
        const double at = std::pow(10.0, power);
        ticks.push_back({at, numberText(at)});
    }
    return ticks;
}

// matplotlib's viridis, every ninth of the scale.
constexpr std::array<std::array<int, 3>, 10> kSequential{{{68, 1, 84},
                                                          {72, 40, 120},
                                                          {62, 73, 137},
                                                          {49, 104, 142},
                                                          {38, 130, 142},
                                                          {31, 158, 137},
                                                          {53, 183, 121},
                                                          {110, 206, 88},
                                                          {181, 222, 43},
                                                          {253, 231, 37}}};
// ColorBrewer's RdBu, from blue.
constexpr std::array<std::array<int, 3>, 11> kDiverging{{{5, 48, 97},
                                                         {33, 102, 172},
                                                         {67, 147, 195},
                                                         {146, 197, 222},
                                                         {209, 229, 240},
                                                         {247, 247, 247},
                                                         {253, 219, 199},
                                                         {244, 165, 130},
                                                         {214, 96, 77},
                                                         {178, 24, 43},
                                                         {103, 0, 31}}};

template <std::size_t N>
glm::vec3 between(const std::array<std::array<int, 3>, N>& colours, double share) {
    const double at = std::clamp(share, 0.0, 1.0) * (N - 1);
    const auto lower = std::min(static_cast<std::size_t>(at), N - 2);
    glm::vec3 colour(0.0f);
    for (int c = 0; c < 3; ++c) {
        const auto channel = static_cast<std::size_t>(c);
        colour[c] =
            static_cast<float>(std::lerp(colours[lower][channel], colours[lower + 1][channel],
                                         at - static_cast<double>(lower)) /
                               255.0);
    }
    return colour;
}

/// A piece of a contour between two sides of cells. Sides are numbered, so that pieces join.
struct Piece {
    std::array<std::size_t, 2> side;
    std::array<glm::dvec2, 2> at;
    bool used = false;
};

/// Cuts cells at a level: marching squares.
class Squares {
  public:
    Squares(const Contours& contours, double level) : contours_(contours), level_(level) {}

    std::vector<Piece> pieces() {
        for (std::size_t y = 0; y + 1 < contours_.y.size(); ++y) {
            for (std::size_t x = 0; x + 1 < contours_.x.size(); ++x) cut(x, y);
        }
        return std::move(pieces_);
    }

  private:
    double value(std::size_t x, std::size_t y) const {
        return static_cast<double>(contours_.values[y * contours_.x.size() + x]) - level_;
    }

    /// Where a side from (x, y) along x or y is crossed.
    struct Crossing {
        std::size_t side;
        glm::dvec2 at;
    };
    void side(std::vector<Crossing>& crossings, std::size_t x, std::size_t y, bool alongX) const {
        const double from = value(x, y), to = alongX ? value(x + 1, y) : value(x, y + 1);
        if ((from < 0.0) == (to < 0.0)) return;
        const double share = from / (from - to);
        const glm::dvec2 at =
            alongX
                ? glm::dvec2(std::lerp(contours_.x[x], contours_.x[x + 1], share), contours_.y[y])
                : glm::dvec2(contours_.x[x], std::lerp(contours_.y[y], contours_.y[y + 1], share));
        crossings.push_back({2 * (y * contours_.x.size() + x) + (alongX ? 0U : 1U), at});
    }

    void cut(std::size_t x, std::size_t y) {
        const double sum = value(x, y) + value(x + 1, y) + value(x, y + 1) + value(x + 1, y + 1);
        if (!std::isfinite(sum)) return;
        std::vector<Crossing> crossings;
        side(crossings, x, y, true);
        side(crossings, x + 1, y, false);
        side(crossings, x, y + 1, true);
        side(crossings, x, y, false);
        if (crossings.size() < 2) return;
        // Sides are in turn. A saddle has four crossings, and its middle decides which corner the
        // lines cut off: the first, or its neighbours.
        const bool first = crossings.size() == 4 && (sum < 0.0) != (value(x, y) < 0.0);
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
            const Crossing& a = crossings[first ? (i + 3) % 4 : i];
            const Crossing& b = crossings[first ? i : i + 1];
            pieces_.push_back({{a.side, b.side}, {a.at, b.at}});
        }
    }

    const Contours& contours_;
    double level_;
    std::vector<Piece> pieces_;
};

}  // namespace

std::vector<double> edgesAround(const std::vector<double>& middles) {
    std::vector<double> edges{1.5 * middles[0] - 0.5 * middles[1]};
    for (std::size_t i = 0; i + 1 < middles.size(); ++i) {
        edges.push_back(0.5 * (middles[i] + middles[i + 1]));
    }
    const std::size_t last = middles.size() - 1;
    edges.push_back(1.5 * middles[last] - 0.5 * middles[last - 1]);
    return edges;
}

std::vector<Tick> ticksOf(const Axis& axis, int most) {
    if (!axis.ticks.empty()) return axis.ticks;
    const double least = std::min(axis.from, axis.to), greatest = std::max(axis.from, axis.to);
    if (!(greatest > least)) return {};
    if (axis.logarithmic) return logarithmicTicks(least, greatest, most);
    const double step = roundStep(greatest - least, most);
    std::vector<Tick> ticks;
    for (double at = std::ceil(least / step - 1e-9) * step; at <= greatest + 1e-9 * step;
         at += step) {
        const double exact = std::abs(at) < 1e-6 * step ? 0.0 : at;
        ticks.push_back({exact, numberText(exact)});
    }
    return ticks;
}

std::vector<double> roundLevels(double least, double greatest, int count) {
    std::vector<double> levels;
    if (!(greatest > least)) return levels;
    for (const Tick& tick : ticksOf(Axis{{}, least, greatest, false, {}}, count))
        levels.push_back(tick.at);
    return levels;
}

std::vector<std::vector<glm::dvec2>> contourLines(const Contours& contours, double level) {
    std::vector<Piece> pieces = Squares(contours, level).pieces();
    std::vector<std::pair<std::size_t, std::size_t>> ends;  // of a side, and the piece
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (const std::size_t side : pieces[i].side) ends.emplace_back(side, i);
    }
    std::ranges::sort(ends);
    const auto next = [&](std::size_t side) -> Piece* {
        auto at = std::ranges::lower_bound(ends, std::pair(side, std::size_t{0}));
        for (; at != ends.end() && at->first == side; ++at) {
            if (!pieces[at->second].used) return &pieces[at->second];
        }
        return nullptr;
    };
    std::vector<std::vector<glm::dvec2>> lines;
    for (Piece& first : pieces) {
        if (first.used) continue;
        first.used = true;
        std::vector<glm::dvec2> line{first.at[0], first.at[1]};
        for (const bool forward : {true, false}) {
            std::size_t side = first.side[forward ? 1 : 0];
            for (Piece* piece = next(side); piece != nullptr; piece = next(side)) {
                piece->used = true;
                const std::size_t other = piece->side[0] == side ? 1 : 0;
                line.insert(forward ? line.end() : line.begin(), piece->at[other]);
                side = piece->side[other];
            }
        }
        lines.push_back(std::move(line));
    }
    return lines;
}

glm::vec3 colourAt(ColourMap map, double share) {
    return map == ColourMap::diverging ? between(kDiverging, share) : between(kSequential, share);
}

}  // namespace neph::plot
