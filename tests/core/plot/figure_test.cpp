// figure_test.cpp: ticks, contours, colours, tables and where a figure is drawn.
#include "core/plot/figure.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "core/plot/draw.h"
#include "core/plot/table.h"

using namespace neph;
using namespace neph::plot;

namespace {

/// Contours over (x, y) in [-2, 2]², of `value`.
Contours contoursOf(const auto& value) {
    Contours contours;
    constexpr int kPoints = 81;
    for (int i = 0; i < kPoints; ++i) contours.x.push_back(-2.0 + 0.05 * i);
    contours.y = contours.x;
    for (const double y : contours.y) {
        for (const double x : contours.x)
            contours.values.push_back(static_cast<float>(value(x, y)));
    }
    return contours;
}

/// Remembers texts, and how much was filled.
class CountingCanvas final : public Canvas {
  public:
    std::vector<std::string> texts;
    std::vector<double> rights;  ///< of level texts, how far each reaches
    double lowest = 0.0;         ///< how far down level texts reach
    int rects = 0, lines = 0, clips = 0;

    void line(std::span<const glm::dvec2>, const Pen&) override { ++lines; }
    void fill(std::span<const glm::dvec2>, const glm::vec4&) override {}
    void fillRect(const RectPt&, const glm::vec4&) override { ++rects; }
    void text(glm::dvec2 at, Anchor anchor, const std::string& words, const glm::vec4&,
              double sizePt, bool upwards) override {
        texts.push_back(words);
        if (!upwards) rights.push_back(at.x + (1.0 - anchor.x) * textSize(words, sizePt).x);
        if (!upwards) lowest = std::max(lowest, at.y + (1.0 - anchor.y) * 1.2 * sizePt);
    }
    glm::dvec2 textSize(const std::string& words, double sizePt) override {
        return {0.6 * sizePt * static_cast<double>(words.size()), 1.2 * sizePt};
    }
    void clip(const RectPt&) override { ++clips; }
    void endClip() override { --clips; }
};

}  // namespace

TEST_CASE("Ticks are round, within the axis and not too many") {
    const std::vector<Tick> ticks = ticksOf({"", -3.0, 17.0, false, {}}, 5);
    REQUIRE(ticks.size() == 4);
    CHECK(ticks[0].at == 0.0);
    CHECK(ticks[0].text == "0");
    CHECK(ticks[3].text == "15");
    const std::vector<Tick> powers = ticksOf({"", 1e-3, 100.0, true, {}}, 10);
    REQUIRE(powers.size() == 6);
    CHECK(powers[0].text == "0.001");
    CHECK(powers[5].text == "100");
    CHECK(ticksOf({"", 1.0, 1.0, false, {}}, 5).empty());
    CHECK(roundLevels(0.3, 9.6, 5) == std::vector<double>{2.0, 4.0, 6.0, 8.0});
}

TEST_CASE("The contour of a cone is one closed circle") {
    const Contours cone = contoursOf([](double x, double y) { return std::hypot(x, y); });
    const auto lines = contourLines(cone, 1.0);
    REQUIRE(lines.size() == 1);
    double length = 0.0;
    for (std::size_t i = 0; i < lines[0].size(); ++i) {
        CHECK(glm::length(lines[0][i]) == doctest::Approx(1.0).epsilon(2e-3));
        if (i > 0) length += glm::distance(lines[0][i - 1], lines[0][i]);
    }
    CHECK(glm::distance(lines[0].front(), lines[0].back()) < 1e-9);
    CHECK(length == doctest::Approx(6.2832).epsilon(2e-3));
}

TEST_CASE("Contours part at missing values, and do not cross at a saddle") {
    const Contours hole = contoursOf([](double x, double y) {
        return std::abs(y) < 0.5 ? std::numeric_limits<double>::quiet_NaN() : x;
    });
    CHECK(contourLines(hole, 0.0).size() == 2);
    const Contours saddle = contoursOf([](double x, double y) { return x * y; });
    for (const double level : {-0.01, 0.01}) {
        const auto lines = contourLines(saddle, level);
        CHECK(lines.size() == 2);
        for (const auto& line : lines) {
            for (const glm::dvec2& at : line) CHECK(at.x * at.y * level > 0.0);
        }
    }
}

TEST_CASE("Places of the plot and of the canvas are one another's inverse") {
    Figure figure;
    figure.x = {"x, km", 0.0, 10.0, false, {}};
    figure.y = {"y, m", 1.0, 1000.0, true, {}};
    Field field;
    field.label = "w, m/s";
    field.edgesX = {0.0, 5.0, 10.0};
    field.edgesY = {1.0, 10.0, 1000.0};
    field.values = {1.0f, 2.0f, 3.0f, std::numeric_limits<float>::quiet_NaN()};
    figure.field = field;
    CountingCanvas canvas;
    const Frame frame = draw(figure, {{0.0, 0.0}, {400.0, 300.0}}, canvas, {});
    CHECK(canvas.clips == 0);
    for (const glm::dvec2 at :
         {glm::dvec2(0.0, 1.0), glm::dvec2(10.0, 1000.0), glm::dvec2(2.5, 30.0)}) {
        const glm::dvec2 pt = frame.toPt(at);
        CHECK(frame.contains(pt));
        CHECK(frame.toAxes(pt).x == doctest::Approx(at.x));
        CHECK(frame.toAxes(pt).y == doctest::Approx(at.y));
    }
    CHECK(std::ranges::count(canvas.texts, "x, km") == 1);
    CHECK(std::ranges::count(canvas.texts, "w, m/s") == 1);
    CHECK(readout(figure, frame, frame.toPt({7.0, 5.0})) == "x, km: 7\ny, m: 5\nw, m/s: 2");
    CHECK(readout(figure, frame, frame.toPt({7.0, 500.0})) == "x, km: 7\ny, m: 500");
}

TEST_CASE("The legend names what is drawn, and goes on in a new row at the edge") {
    Figure figure;
    figure.x = {"x", 0.0, 1.0, false, {}};
    figure.y = {"y", 0.0, 1.0, false, {}};
    for (const char* label : {"Cloud water", "Cloud ice", "Rain", "Snow", "Graupel"}) {
        Curve curve;
        curve.label = label;
        curve.points = {{0.0, 0.0}, {1.0, 1.0}};
        figure.curves.push_back(curve);
    }
    Curve missing;
    missing.label = "Tropopause";
    missing.points = {{0.5, std::numeric_limits<double>::quiet_NaN()}};
    figure.curves.push_back(missing);
    Contours contours = contoursOf([](double, double) { return 5.0; });
    contours.label = "-20 °C";
    contours.levels = {-20.0};
    figure.contours = {contours};
    CountingCanvas wide, narrow;
    const Frame inOne = draw(figure, {{0.0, 0.0}, {900.0, 300.0}}, wide, {});
    const Frame inTwo = draw(figure, {{0.0, 0.0}, {300.0, 300.0}}, narrow, {});
    CHECK(std::ranges::count(wide.texts, "Graupel") == 1);
    CHECK(std::ranges::count(wide.texts, "Tropopause") == 0);
    CHECK(std::ranges::count(wide.texts, "-20 °C") == 0);
    CHECK(inTwo.plot.upper.y < inOne.plot.upper.y);
    for (const double right : narrow.rights) CHECK(right <= 300.0);
}

TEST_CASE("Notes that are many are smaller, so that all lie in the figure") {
    Figure figure;
    figure.x = {"x", 0.0, 1.0, false, {}};
    figure.y = {"y", 0.0, 1.0, false, {}};
    for (int i = 0; i < 21; ++i) figure.notes.emplace_back("SRH 0-3 km", "189 m2/s2");
    CountingCanvas canvas;
    const Style style;
    const double heightPt = 20.0 * 1.4 * style.textPt;
    draw(figure, {{0.0, 0.0}, {600.0, heightPt}}, canvas, style);
    CHECK(std::ranges::count(canvas.texts, "189 m2/s2") == 21);
    CHECK(canvas.lowest <= heightPt);
}

TEST_CASE("Colours end with their maps, and a diverging one is pale in the middle") {
    CHECK(colourAt(ColourMap::sequential, -1.0) == colourAt(ColourMap::sequential, 0.0));
    CHECK(colourAt(ColourMap::sequential, 1.0).r == doctest::Approx(253.0 / 255.0));
    const glm::vec3 middle = colourAt(ColourMap::diverging, 0.5);
    CHECK(middle.r == doctest::Approx(middle.b));
    CHECK(middle.r > 0.95f);
}

TEST_CASE("Tables are comma-separated, with missing numbers empty") {
    Table table;
    table.comments = {"Model: WRF"};
    table.columns = {{"time", {}, {"a", "b, \"c\""}},
                     {"w [m/s]", {1.25, std::numeric_limits<double>::quiet_NaN()}, {}}};
    CHECK(csvOf(table) == "# Model: WRF\ntime,w [m/s]\na,1.25\n\"b, \"\"c\"\"\",\n");
}
