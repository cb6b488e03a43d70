// draw.cpp: lays out a figure and draws its parts from back to front.
#include "core/plot/draw.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/number_text.h"

namespace neph::plot {
namespace {

constexpr double kTickPt = 4.0, kGapPt = 6.0, kBarPt = 14.0, kSamplePt = 18.0;
constexpr double kLeastNotes = 0.6;  // of the text's size; Tuned: still read
constexpr double kPtPerTickX = 60.0, kPtPerTickY = 28.0;

class Drawing {
  public:
    Drawing(const Figure& figure, const RectPt& area, Canvas& canvas, const Style& style)
        : figure_(figure), area_(area), canvas_(canvas), style_(style) {}

    Frame draw() {
        canvas_.fillRect(area_, ink(Ink::background));
        layOut();
        canvas_.clip(frame_.plot);
        drawGrid();
        if (figure_.field) drawField(*figure_.field);
        for (const Curve& curve : figure_.curves) {
            if (curve.filledBelow) fillBelow(curve);
        }
        for (const Contours& contours : figure_.contours) drawContours(contours);
        for (const Curve& curve : figure_.curves) {
            if (!curve.filledBelow) drawCurve(curve);
        }
        for (const Barb& barb : figure_.barbs) drawBarb(barb);
        for (const Mark& mark : figure_.marks) drawMark(mark);
        canvas_.endClip();
        drawAxes();
        drawTitle();
        drawLegend();
        drawNotes();
        if (figure_.field) drawBar(*figure_.field);
        return frame_;
    }

  private:
    glm::vec4 ink(Ink of) const { return inkColour(of, style_); }
    double text() const { return style_.textPt; }
    Pen pen(Ink of, double width, bool dashed = false) const { return {ink(of), width, dashed}; }

    void write(glm::dvec2 at, Anchor anchor, const std::string& words, Ink of = Ink::foreground,
               double scale = 1.0, bool upwards = false) {
        canvas_.text(at, anchor, words, ink(of), scale * text(), upwards);
    }

    /// By how much the notes are smaller than other text, so that all fit below `topY`.
    double notesScale(double topY) const {
        if (figure_.notes.empty()) return 1.0;
        const double wanted = 1.4 * text() * static_cast<double>(figure_.notes.size());
        return std::clamp((area_.upper.y - topY) / wanted, kLeastNotes, 1.0);
    }

    double notesWidth(double topY) {
        const double size = notesScale(topY) * text();
        double width = 0.0;
        for (const auto& [label, value] : figure_.notes) {
            width = std::max(width, canvas_.textSize(label + "   " + value, size).x);
        }
        return figure_.notes.empty() ? 0.0 : width + 2.0 * kGapPt;
    }

    void layOut() {
        frame_.x = figure_.x;
        frame_.y = figure_.y;
        const double line = 1.4 * text();
        double labels = 0.0;
        for (const Tick& tick : ticksOf(figure_.y, 8)) {
            labels = std::max(labels, canvas_.textSize(tick.text, text()).x);
        }
        RectPt plot = area_;
        plot.lower += glm::dvec2(kGapPt + line + labels + kTickPt + kGapPt,
                                 kGapPt + (figure_.title.empty() ? 0.0 : line * 1.2) +
                                     (figure_.subtitle.empty() ? 0.0 : line));
        plot.upper -= glm::dvec2(2.0 * kGapPt + notesWidth(plot.lower.y),
                                 2.0 * line + kTickPt + 2.0 * kGapPt);
        if (figure_.field) plot.upper.x -= kBarPt + 3.5 * text() + line + 2.0 * kGapPt;
        plot.upper.y -= line * legendRows(plot.lower.x);
        plot.upper = glm::max(plot.upper, plot.lower + glm::dvec2(20.0));
        if (figure_.equalScale) {
            const double spanX = std::abs(figure_.x.to - figure_.x.from);
            const double spanY = std::abs(figure_.y.to - figure_.y.from);
            const double scale = std::min(plot.size().x / spanX, plot.size().y / spanY);
            plot.upper = plot.lower + scale * glm::dvec2(spanX, spanY);
        }
        frame_.plot = plot;
        ticksX_ = ticksOf(figure_.x, std::max(2, static_cast<int>(plot.size().x / kPtPerTickX)));
        ticksY_ = ticksOf(figure_.y, std::max(2, static_cast<int>(plot.size().y / kPtPerTickY)));
    }

    double xOf(double at) const { return frame_.toPt({at, figure_.y.from}).x; }
    double yOf(double at) const { return frame_.toPt({figure_.x.from, at}).y; }

    void drawGrid() {
        for (const Tick& tick : ticksX_) {
            const std::array<glm::dvec2, 2> ends{glm::dvec2(xOf(tick.at), frame_.plot.lower.y),
                                                 glm::dvec2(xOf(tick.at), frame_.plot.upper.y)};
            canvas_.line(ends, pen(Ink::faint, 0.5));
        }
        for (const Tick& tick : ticksY_) {
            const std::array<glm::dvec2, 2> ends{glm::dvec2(frame_.plot.lower.x, yOf(tick.at)),
                                                 glm::dvec2(frame_.plot.upper.x, yOf(tick.at))};
            canvas_.line(ends, pen(Ink::faint, 0.5));
        }
    }

    /// Cells of one colour beside one another are one rectangle.
    void drawField(const Field& field) {
        constexpr int kColours = 64;
        const auto step = [&](std::size_t cell) {
            const auto value = static_cast<double>(field.values[cell]);
            if (!std::isfinite(value)) return -1;
            const double share = (value - field.from) / (field.to - field.from);
            return std::clamp(static_cast<int>(share * kColours), 0, kColours - 1);
        };
        for (std::size_t row = 0; row < field.rows(); ++row) {
            const double lower = yOf(field.edgesY[row]), upper = yOf(field.edgesY[row + 1]);
            for (std::size_t from = 0; from < field.columns();) {
                const int colour = step(row * field.columns() + from);
                std::size_t to = from + 1;
                while (to < field.columns() && step(row * field.columns() + to) == colour) ++to;
                if (colour >= 0) {
                    const glm::dvec2 a(xOf(field.edgesX[from]), std::min(lower, upper));
                    const glm::dvec2 b(xOf(field.edgesX[to]), std::max(lower, upper));
                    canvas_.fillRect(
                        {a, b}, glm::vec4(colourAt(field.map, (colour + 0.5) / kColours), 1.0f));
                }
                from = to;
            }
        }
    }

    void fillBelow(const Curve& curve) {
        const double foot = frame_.plot.upper.y;
        for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
            const glm::dvec2 a = frame_.toPt(curve.points[i]);
            const glm::dvec2 b = frame_.toPt(curve.points[i + 1]);
            if (!std::isfinite(a.y + b.y)) continue;
            const std::array<glm::dvec2, 4> piece{a, b, glm::dvec2(b.x, foot),
                                                  glm::dvec2(a.x, foot)};
            canvas_.fill(piece, ink(curve.ink));
        }
    }

    void drawCurve(const Curve& curve) {
        std::vector<glm::dvec2> run;
        const auto finish = [&] {
            Pen line = pen(curve.ink, curve.width, curve.dashed);
            line.colour.a = static_cast<float>(curve.opacity);
            if (run.size() > 1) canvas_.line(run, line);
            run.clear();
        };
        for (const glm::dvec2& point : curve.points) {
            if (std::isfinite(point.x) && std::isfinite(point.y)) {
                run.push_back(frame_.toPt(point));
            } else {
                finish();
            }
        }
        finish();
    }

    void drawContours(const Contours& contours) {
        for (const double level : contours.levels) {
            for (const auto& line : contourLines(contours, level)) {
                std::vector<glm::dvec2> points;
                for (const glm::dvec2& at : line) points.push_back(frame_.toPt(at));
                canvas_.line(points, pen(contours.ink, contours.width));
                if (contours.named) nameLine(points, numberText(level), contours.ink);
            }
        }
    }

    /// Writes a level where a long line is in its middle.
    void nameLine(const std::vector<glm::dvec2>& points, const std::string& words, Ink of) {
        double length = 0.0;
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            length += glm::distance(points[i], points[i + 1]);
        }
        if (length < 12.0 * text()) return;
        const glm::dvec2 at = points[points.size() / 2];
        const glm::dvec2 size = canvas_.textSize(words, 0.85 * text());
        const RectPt behind{at - 0.5 * size - 1.0, at + 0.5 * size + 1.0};
        if (!frame_.contains(behind.lower) || !frame_.contains(behind.upper)) return;
        glm::vec4 ground = ink(Ink::background);
        ground.a = 0.75f;
        canvas_.fillRect(behind, ground);
        write(at, {0.5, 0.5}, words, of, 0.85);
    }

    void drawMark(const Mark& mark) {
        const glm::dvec2 at = frame_.toPt(mark.at);
        if (mark.dot) {
            constexpr double kDotPt = 2.5;
            canvas_.fillRect({at - kDotPt, at + kDotPt}, ink(mark.ink));
        }
        write(at + glm::dvec2(kGapPt, 0.0), {0.0, 0.5}, mark.text, mark.ink);
    }

    void drawBarb(const Barb& barb) {
        constexpr double kStaffPt = 26.0, kFlagPt = 9.0, kApartPt = 4.0;
        const glm::dvec2 at = frame_.toPt(barb.at);
        const double speed = glm::length(barb.windMPerS);
        const Pen line = pen(Ink::foreground, 1.0);
        if (!std::isfinite(speed) || speed < 2.5) return;
        // The staff points to where the wind comes from; flags are on its left as seen from there.
        const glm::dvec2 from = glm::dvec2(-barb.windMPerS.x, barb.windMPerS.y) / speed;
        const glm::dvec2 side = glm::dvec2(-from.y, from.x);
        const std::array<glm::dvec2, 2> staff{at, at + kStaffPt * from};
        canvas_.line(staff, line);
        double place = kStaffPt;
        int halves = static_cast<int>(std::lround(speed / 5.0));
        const auto flag = [&](double length) {
            const glm::dvec2 foot = at + place * from;
            const std::array<glm::dvec2, 2> ends{foot, foot + length * (side + 0.4 * from)};
            canvas_.line(ends, line);
            place -= kApartPt;
        };
        for (; halves >= 10; halves -= 10) {
            const glm::dvec2 foot = at + place * from;
            const std::array<glm::dvec2, 3> pennant{foot, foot + kFlagPt * side,
                                                    foot - kApartPt * from};
            canvas_.fill(pennant, line.colour);
            place -= kApartPt + 2.0;
        }
        for (; halves >= 2; halves -= 2) flag(kFlagPt);
        if (halves == 1) {
            if (place == kStaffPt) place -= kApartPt;
            flag(0.5 * kFlagPt);
        }
    }

    void drawAxes() {
        const RectPt& plot = frame_.plot;
        const std::array<glm::dvec2, 5> box{plot.lower, glm::dvec2(plot.upper.x, plot.lower.y),
                                            plot.upper, glm::dvec2(plot.lower.x, plot.upper.y),
                                            plot.lower};
        canvas_.line(box, pen(Ink::foreground, 1.0));
        for (const Tick& tick : ticksX_) {
            const double x = xOf(tick.at);
            if (x < plot.lower.x - 0.5 || x > plot.upper.x + 0.5) continue;
            const std::array<glm::dvec2, 2> ends{glm::dvec2(x, plot.upper.y),
                                                 glm::dvec2(x, plot.upper.y + kTickPt)};
            canvas_.line(ends, pen(Ink::foreground, 1.0));
            write({x, plot.upper.y + kTickPt + 1.0}, {0.5, 0.0}, tick.text);
        }
        for (const Tick& tick : ticksY_) {
            const double y = yOf(tick.at);
            if (y < plot.lower.y - 0.5 || y > plot.upper.y + 0.5) continue;
            const std::array<glm::dvec2, 2> ends{glm::dvec2(plot.lower.x - kTickPt, y),
                                                 glm::dvec2(plot.lower.x, y)};
            canvas_.line(ends, pen(Ink::foreground, 1.0));
            write({plot.lower.x - kTickPt - 2.0, y}, {1.0, 0.5}, tick.text);
        }
        const glm::dvec2 middle = 0.5 * (plot.lower + plot.upper);
        write({middle.x, plot.upper.y + kTickPt + 1.4 * text()}, {0.5, 0.0}, figure_.x.label);
        write({area_.lower.x + kGapPt, middle.y}, {0.0, 0.5}, figure_.y.label, Ink::foreground, 1.0,
              true);
    }

    void drawTitle() {
        double y = area_.lower.y + kGapPt;
        if (!figure_.title.empty()) {
            write({frame_.plot.lower.x, y}, {0.0, 0.0}, figure_.title, Ink::foreground, 1.2);
            y += 1.2 * 1.4 * text();
        }
        if (figure_.subtitle.empty()) return;
        write({frame_.plot.lower.x, y}, {0.0, 0.0}, figure_.subtitle);
    }

    struct Entry {
        std::string label;
        Ink ink;
        bool dashed;
    };
    /// Whether a level lies within the values, so that there may be a line.
    static bool crossed(const Contours& contours) {
        double least = std::numeric_limits<double>::infinity(), most = -least;
        for (const float value : contours.values) {
            if (!std::isfinite(value)) continue;
            least = std::min(least, static_cast<double>(value));
            most = std::max(most, static_cast<double>(value));
        }
        return std::ranges::any_of(contours.levels,
                                   [&](double level) { return level >= least && level <= most; });
    }
    std::vector<Entry> legendOf() const {
        std::vector<Entry> entries;
        for (const Curve& curve : figure_.curves) {
            const bool drawn = std::ranges::any_of(curve.points, [](const glm::dvec2& point) {
                return std::isfinite(point.x) && std::isfinite(point.y);
            });
            if (!drawn || curve.label.empty()) continue;
            entries.push_back({curve.label, curve.ink, curve.dashed});
        }
        for (const Contours& contours : figure_.contours) {
            if (contours.label.empty() || !crossed(contours)) continue;
            entries.push_back({contours.label, contours.ink, false});
        }
        return entries;
    }

    /// Where entries begin, as an advance along a row and the number of that row; rows reach from
    /// `fromX` to the edge of the figure.
    std::vector<glm::dvec2> legendPlaces(double fromX) {
        std::vector<glm::dvec2> places;
        glm::dvec2 next(0.0);
        for (const Entry& entry : legendOf()) {
            const double width = kSamplePt + 4.0 + canvas_.textSize(entry.label, text()).x;
            if (next.x > 0.0 && fromX + next.x + width > area_.upper.x) {
                next = {0.0, next.y + 1.0};
            }
            places.push_back(next);
            next.x += width + 2.0 * kGapPt;
        }
        return places;
    }

    double legendRows(double fromX) {
        const std::vector<glm::dvec2> places = legendPlaces(fromX);
        return places.empty() ? 0.0 : places.back().y + 1.0;
    }

    void drawLegend() {
        const std::vector<Entry> entries = legendOf();
        const std::vector<glm::dvec2> places = legendPlaces(frame_.plot.lower.x);
        const double top = frame_.plot.upper.y + kTickPt + 3.5 * text();
        for (std::size_t i = 0; i < entries.size(); ++i) {
            const Entry& entry = entries[i];
            const double x = frame_.plot.lower.x + places[i].x;
            const double y = top + 1.4 * text() * places[i].y;
            const std::array<glm::dvec2, 2> ends{glm::dvec2(x, y), glm::dvec2(x + kSamplePt, y)};
            canvas_.line(ends, pen(entry.ink, 2.0, entry.dashed));
            write({x + kSamplePt + 4.0, y}, {0.0, 0.5}, entry.label);
        }
    }

    void drawNotes() {
        const double top = frame_.plot.lower.y, scale = notesScale(top);
        const double x = area_.upper.x - notesWidth(top) + kGapPt;
        double y = top;
        for (const auto& [label, value] : figure_.notes) {
            write({x, y}, {0.0, 0.0}, label, Ink::foreground, scale);
            write({area_.upper.x - kGapPt, y}, {1.0, 0.0}, value, Ink::foreground, scale);
            y += 1.4 * scale * text();
        }
    }

    void drawBar(const Field& field) {
        constexpr int kSteps = 64;
        const double x = frame_.plot.upper.x + 2.0 * kGapPt;
        const RectPt bar{{x, frame_.plot.lower.y}, {x + kBarPt, frame_.plot.upper.y}};
        const double step = bar.size().y / kSteps;
        for (int i = 0; i < kSteps; ++i) {
            canvas_.fillRect({{bar.lower.x, bar.upper.y - (i + 1) * step},
                              {bar.upper.x, bar.upper.y - i * step + 0.3}},
                             glm::vec4(colourAt(field.map, (i + 0.5) / kSteps), 1.0f));
        }
        const Axis axis{{}, field.from, field.to, false, {}};
        for (const Tick& tick : ticksOf(axis, static_cast<int>(bar.size().y / kPtPerTickY))) {
            const double y = bar.upper.y - axisShare(axis, tick.at) * bar.size().y;
            write({bar.upper.x + 4.0, y}, {0.0, 0.5}, tick.text);
        }
        write({bar.upper.x + 3.5 * text() + kGapPt, 0.5 * (bar.lower.y + bar.upper.y)}, {0.0, 0.5},
              field.label, Ink::foreground, 1.0, true);
    }

    const Figure& figure_;
    RectPt area_;
    Canvas& canvas_;
    const Style& style_;
    Frame frame_;
    std::vector<Tick> ticksX_, ticksY_;
};

}  // namespace

Frame draw(const Figure& figure, const RectPt& area, Canvas& canvas, const Style& style) {
    return Drawing(figure, area, canvas, style).draw();
}

}  // namespace neph::plot
