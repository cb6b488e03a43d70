// compare_figures.cpp: the errors of A against B over the image's corner, and as colours in its
// place.
#include "app/ui/compare/compare_figures.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <chrono>

#include "app/ui/widgets/places.h"
#include "app/ui/widgets/reference_text.h"
#include "core/base/number_text.h"

namespace neph::ui {
namespace {

// In letters.
constexpr float kWidthEms = 19.0f, kMarginEms = 0.7f, kValuesEms = 5.5f, kTopEms = 3.0f;
constexpr float kBarEms = 22.0f, kBarHeightEms = 0.7f;
constexpr float kOpacity = 0.80f;
constexpr int kBarSteps = 64;
constexpr ImU32 kPlate = IM_COL32(20, 22, 26, 210);
constexpr ImU32 kText = IM_COL32(235, 238, 242, 255);

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
        ImGui::TextDisabled("Both images have to be there in full first");
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
    ImGui::SetNextWindowSize({kWidthEms * em, 0.0f});
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

ImU32 colourAt(double error, const ErrorScale& scale) {
    const glm::vec3 colour = errorColour(error, scale);
    return ImGui::GetColorU32({colour.x, colour.y, colour.z, 1.0f});
}

/// Below the image of errors: what its colours mean.
void drawLegend(const Area& area, const ErrorScale& scale) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const float em = ImGui::GetFontSize();
    const float width = std::min(kBarEms * em, 0.6f * area.size().x);
    const ImVec2 at{(area.lower.x + area.upper.x - width) / 2.0f, area.upper.y - 3.2f * em};
    list.AddRectFilled({at.x - 3.0f * em, at.y - 0.6f * em},
                       {at.x + width + 3.0f * em, at.y + 2.4f * em}, kPlate, 0.4f * em);
    const float step = width / kBarSteps;
    for (int i = 0; i < kBarSteps; ++i) {
        const double error = scale.most * (2.0 * (i + 0.5) / kBarSteps - 1.0);
        const float x = at.x + step * static_cast<float>(i);
        list.AddRectFilled({x, at.y}, {x + step + 0.5f, at.y + kBarHeightEms * em},
                           colourAt(error, scale));
    }
    const std::string most = numberText(100.0 * scale.most, 3);
    const std::array<std::string, 3> labels{"-" + most + " %", "(A \u2212 B) / B", most + " %"};
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const ImVec2 size = ImGui::CalcTextSize(labels[i].c_str());
        const float middle = at.x + width * static_cast<float>(i) / 2.0f;
        list.AddText({middle - size.x / 2.0f, at.y + 0.9f * em}, kText, labels[i].c_str());
    }
}

void drawColours(const CompareErrors& errors, const Area& area) {
    if (errors.texture == 0 || !errors.figures()) return;
    ImGui::GetBackgroundDrawList()->AddImage(
        reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(errors.texture)),
        {area.lower.x, area.lower.y}, {area.upper.x, area.upper.y});
    drawLegend(area, errors.figures()->scale);
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
