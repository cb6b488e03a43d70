// fields_histogram.cpp: cells by how much they hold, over whole decades; heights are logarithmic,
// because a few dense cells matter as much as many thin ones.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/ui/fields/fields_plots.h"
#include "app/ui/widgets/input.h"
#include "core/base/number_text.h"

namespace neph::ui {
namespace {

constexpr float kHeightEms = 3.2f;

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

float heightOf(std::uint64_t cells) {
    return cells == 0 ? 0.0f : std::log10(static_cast<float>(cells)) + 0.3f;
}

void drawBars(const FieldHistogram& histogram, Window window, ImVec2 lower, ImVec2 upper) {
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddRectFilled(lower, upper, ImGui::GetColorU32(ImGuiCol_FrameBg, 0.6f));
    float most = 0.0f;
    for (const std::uint64_t cells : histogram.cells) most = std::max(most, heightOf(cells));
    const float width = (upper.x - lower.x) / static_cast<float>(window.to - window.from);
    for (int i = window.from; i < window.to; ++i) {
        const float left = lower.x + static_cast<float>(i - window.from) * width;
        if (i > window.from && i % FieldHistogram::kBinsPerDecade == 0) {
            list->AddLine({left, lower.y}, {left, upper.y},
                          ImGui::GetColorU32(ImGuiCol_TextDisabled, 0.35f));
        }
        const float share = heightOf(histogram.cells[static_cast<std::size_t>(i)]) / most;
        if (share <= 0.0f) continue;
        list->AddRectFilled({left, upper.y - share * (upper.y - lower.y)},
                            {left + std::max(1.0f, width - 1.0f), upper.y},
                            ImGui::GetColorU32(ImGuiCol_PlotHistogram));
    }
}

void readOut(const FieldHistogram& histogram, Window window, ImVec2 lower, ImVec2 upper) {
    if (!wantsTooltip()) return;
    const ScreenUnit unit = unitOf(histogram.holding);
    const float share = (ImGui::GetIO().MousePos.x - lower.x) / (upper.x - lower.x);
    const int bin = std::clamp(
        window.from + static_cast<int>(share * static_cast<float>(window.to - window.from)),
        window.from, window.to - 1);
    const auto bound = [&](int i) {
        return FieldHistogram::lowerBound(histogram.holding, i) * unit.scale;
    };
    nextTooltipBeside(lastItem());
    ImGui::SetTooltip(
        "%s to %s %s: %llu cells\nCells of the volume that is shown, heights logarithmic; before "
        "the mixing scale.",
        numberText(bound(bin), 3).c_str(), numberText(bound(bin + 1), 3).c_str(), unit.name,
        static_cast<unsigned long long>(histogram.cells[static_cast<std::size_t>(bin)]));
}

}  // namespace

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
    const ImVec2 lower = ImGui::GetCursorScreenPos();
    const ImVec2 size{std::max(1.0f, ImGui::GetContentRegionAvail().x),
                      kHeightEms * ImGui::GetFontSize()};
    const ImVec2 upper{lower.x + size.x, lower.y + size.y};
    ImGui::InvisibleButton("##histogram", size);
    drawBars(histogram, window, lower, upper);
    readOut(histogram, window, lower, upper);
    const std::string from =
        numberText(FieldHistogram::lowerBound(histogram.holding, window.from) * unit.scale, 3);
    const std::string to = amount(FieldHistogram::lowerBound(histogram.holding, window.to), unit);
    const float left = ImGui::GetCursorPosX();
    ImGui::TextDisabled("%s", from.c_str());
    ImGui::SameLine(left + size.x - ImGui::CalcTextSize(to.c_str()).x);
    ImGui::TextDisabled("%s", to.c_str());
}

}  // namespace neph::ui
