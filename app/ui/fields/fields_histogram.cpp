// fields_histogram.cpp: cells by how much they hold, over whole decades; both axes are logarithmic,
// because a few dense cells matter as much as many thin ones.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/ui/fields/fields_plots.h"
#include "app/ui/widgets/input.h"
#include "app/ui/widgets/plot_canvas.h"
#include "core/base/number_text.h"

namespace neph::ui {
namespace {

constexpr float kHeightEms = 9.0f;
constexpr double kLeastCells = 0.5;  // where the axis begins, so that one cell is seen

/// As people say it: g/m³, or extinction by the kilometre.
struct ScreenUnit {
    double scale = 1.0;
    const char* name = "";
};

ScreenUnit unitOf(Holding holding) {
    if (holding == Holding::extinction) return {1e3, "1/km"};
    return {1e3, "g/m³"};
}

std::string amount(double value, const ScreenUnit& unit) {
    return fmt::format("{} {}", numberText(value * unit.scale, 3), unit.name);
}

/// The bins that are drawn: whole decades around those that hold any.
struct Window {
    int from = 0, to = 0;
};

Window windowOf(const FieldHistogram& histogram) {
    constexpr int kPer = FieldHistogram::kBinsPerDecade;
    Window window{FieldHistogram::kBins, 0};
    for (int i = 0; i < FieldHistogram::kBins; ++i) {
        if (histogram.cells[static_cast<std::size_t>(i)] == 0) continue;
        window.from = std::min(window.from, i / kPer * kPer);
        window.to = (i / kPer + 1) * kPer;
    }
    return window;
}

/// Bin and count under the mouse.
void readOut(const FieldHistogram& histogram, Window window, const plot::Frame& frame) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const glm::dvec2 at(static_cast<double>(mouse.x), static_cast<double>(mouse.y));
    if (!wantsTooltip() || !frame.contains(at)) return;
    const ScreenUnit unit = unitOf(histogram.holding);
    const double share = plot::axisShare(frame.x, frame.toAxes(at).x);
    const int bin = std::clamp(window.from + static_cast<int>(share * (window.to - window.from)),
                               window.from, window.to - 1);
    const auto bound = [&](int i) {
        return FieldHistogram::lowerBound(histogram.holding, i) * unit.scale;
    };
    nextTooltipBeside(lastItem());
    ImGui::SetTooltip(
        "%s to %s %s: %llu cells\nCells of the volume that is shown, before the "
        "mixing scale.",
        numberText(bound(bin), 3).c_str(), numberText(bound(bin + 1), 3).c_str(), unit.name,
        static_cast<unsigned long long>(histogram.cells[static_cast<std::size_t>(bin)]));
}

}  // namespace

plot::Figure histogramFigure(const FieldHistogram& histogram) {
    const Window window = windowOf(histogram);
    plot::Figure figure;
    if (window.from >= window.to) return figure;
    const ScreenUnit unit = unitOf(histogram.holding);
    const auto bound = [&](int i) {
        return FieldHistogram::lowerBound(histogram.holding, i) * unit.scale;
    };
    const bool sized = histogram.holding == Holding::extinction;
    figure.x.label = fmt::format("{}, {}", sized ? "Extinction" : "Mass content", unit.name);
    figure.x.from = bound(window.from);
    figure.x.to = bound(window.to);
    figure.y.label = "Cells";
    figure.x.logarithmic = figure.y.logarithmic = true;
    plot::Curve steps;
    steps.ink = plot::Ink::blue;
    steps.filledBelow = true;
    double most = 1.0;
    for (int i = window.from; i < window.to; ++i) {
        const auto cells = static_cast<double>(histogram.cells[static_cast<std::size_t>(i)]);
        most = std::max(most, cells);
        for (const int side : {i, i + 1}) {
            steps.points.emplace_back(bound(side), std::max(cells, kLeastCells));
        }
    }
    figure.y.from = kLeastCells;
    figure.y.to = std::pow(10.0, std::floor(std::log10(most)) + 1.0);
    figure.curves.push_back(std::move(steps));
    return figure;
}

void drawHistogram(const FieldHistogram& histogram) {
    const Window window = windowOf(histogram);
    if (window.from >= window.to) return;
    const ScreenUnit unit = unitOf(histogram.holding);
    const bool sized = histogram.holding == Holding::extinction;
    ImGui::TextDisabled("%s", sized ? "Extinction" : "Mass content");
    ImGui::SameLine();
    ImGui::Text("%s to %s",
                numberText(static_cast<double>(histogram.least) * unit.scale, 3).c_str(),
                amount(static_cast<double>(histogram.most), unit).c_str());
    const ImVec2 size{std::max(1.0f, ImGui::GetContentRegionAvail().x),
                      kHeightEms * ImGui::GetFontSize()};
    const ShownPlot shown = showPlot("fields.histogram", histogramFigure(histogram), size, false);
    readOut(histogram, window, shown.frame);
}

}  // namespace neph::ui
