// compare_figures.cpp: the errors of A against B over the image's corner, and as colours in its
// place.
#include "app/ui/compare/compare_figures.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include <chrono>

#include "app/ui/compare/error_colours.h"
#include "app/ui/widgets/reference_text.h"
#include "core/base/number_text.h"

namespace neph::ui {
namespace {

// In letters.
constexpr float kWidthEms = 19.0f, kMarginEms = 0.7f, kValuesEms = 5.5f, kTopEms = 3.0f;
constexpr float kOpacity = 0.80f;

void row(const char* label, const std::string& value, bool current) {
    ImGui::TextDisabled("%s", label);
    ImGui::SameLine(kValuesEms * ImGui::GetFontSize());
    current ? ImGui::TextUnformatted(value.c_str()) : ImGui::TextDisabled("%s", value.c_str());
}

void drawRows(const CompareErrors& errors) {
    const PairFigures& figures = *errors.figures();
    const ImageErrors& of = figures.errors;
    const bool current = errors.current();
    row("bias", percentText(of.bias, of.biasSigma), current);
    row("relRMSE", percentText(of.relRmse, of.relRmseSigma), current);
    row("relMSE", numberText(of.relMse, 3), current);
    row("p95", numberText(100.0 * of.p95, 3) + " %", current);
    row("HDR-FLIP",
        fmt::format("{}, p95 {}", numberText(figures.flip, 3), numberText(figures.flipP95, 3)),
        current);
    if (of.noise > 0.0) {
        ImGui::TextDisabled("relRMSE without noise of %s %%",
                            numberText(100.0 * of.noise, 2).c_str());
    } else {
        ImGui::TextDisabled("with all noise of both");
    }
}

void drawState(const CompareErrors& errors) {
    ImGui::PushTextWrapPos(0.0f);
    if (!errors.fault().empty()) {
        ImGui::TextDisabled("%s", errors.fault().c_str());
    } else if (errors.figures()) {
        drawRows(errors);
    }
    if (!errors.seen().whole) {
        ImGui::TextDisabled("Both images have to be complete first");
    } else if (!errors.figures() && errors.busy()) {
        ImGui::TextDisabled("Computing ...");
    }
    if (const auto& traced = errors.seen().traced) {
        ImGui::TextDisabled("B: %s", referenceText(*traced).c_str());
    }
    ImGui::PopTextWrapPos();
}

void drawFigures(const CompareErrors& errors, const Area& area) {
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos({area.lower.x + kMarginEms * em, area.lower.y + kTopEms * em});
    const float room = area.size().x - 2.0f * kMarginEms * em;
    ImGui::SetNextWindowSize({std::clamp(room, 1.0f, kWidthEms * em), 0.0f});
    ImGui::SetNextWindowBgAlpha(kOpacity);
    // Without inputs: the mouse reaches the image through it.
    if (ImGui::Begin("##figures", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                         ImGuiWindowFlags_NoFocusOnAppearing |
                         ImGuiWindowFlags_NoBringToFrontOnFocus)) {
        ImGui::TextUnformatted("A against B");
        drawState(errors);
    }
    ImGui::End();
}

void drawColours(const CompareErrors& errors, const Area& area) {
    if (errors.texture == 0 || !errors.figures()) return;
    drawErrorColours(area, errors.texture, errors.figures()->scale, "(A \u2212 B) / B");
}

void renewTexture(const Services& services, CompareErrors& errors) {
    if (errors.texture != 0 && services.dropImage) services.dropImage(errors.texture);
    errors.texture = 0;
    if (errors.figures() && services.showImage) {
        errors.texture = services.showImage(errors.figures()->colours).texture;
    }
}

}  // namespace

void drawCompareErrors(const PanelContext& context, const CompareState& compare,
                       CompareErrors& errors) {
    if (!comparesImages(compare)) return;
    if (errors.poll(CompareErrors::Clock::now())) renewTexture(context.services, errors);
    if (errors.busy()) context.next.again(kLookS);
    const Area area = context.layout().image;
    if (compare.mode == CompareMode::error) drawColours(errors, area);
    drawFigures(errors, area);
}

}  // namespace neph::ui
