// fields_phase.cpp: a phase function on logarithmic axes: polar with forward to the right, or
// over the angle. Whole decades; one line per wavelength where they differ.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <numbers>

#include "app/ui/fields/fields_plots.h"
#include "app/ui/widgets/input.h"
#include "app/ui/widgets/places.h"
#include "core/base/number_text.h"
#include "core/look/sun.h"
#include "core/optics/phase_functions.h"

namespace neph::ui {
namespace {

constexpr float kHeightEms = 8.0f, kTextEms = 6.6f;
constexpr int kPoints = 256;  // of a curve; the table has four times as many
constexpr std::array kWavelengths{IM_COL32(235, 90, 80, 255), IM_COL32(90, 200, 110, 255),
                                  IM_COL32(90, 140, 245, 255)};  // 650, 550 and 450 nm

struct Decades {
    double lo = 0.0, hi = 1.0;
    float share(float value) const {
        const double at = std::log10(std::max(1e-12, static_cast<double>(value)));
        return static_cast<float>(std::clamp((at - lo) / (hi - lo), 0.0, 1.0));
    }
};

Decades decadesOf(const PhaseTable& table) {
    float least = table.front().g, most = table.front().g;
    for (const glm::vec3& value : table) {
        least = std::min({least, value.r, value.g, value.b});
        most = std::max({most, value.r, value.g, value.b});
    }
    Decades decades{std::floor(std::log10(static_cast<double>(std::max(least, 1e-12f)))),
                    std::ceil(std::log10(static_cast<double>(most)))};
    if (decades.hi <= decades.lo) decades.hi = decades.lo + 1.0;
    return decades;
}

/// Where angles and values lie on the screen.
struct Frame {
    ImVec2 lower, upper;
    Decades decades;
    bool polar = true;

    ImVec2 middle() const { return {(lower.x + upper.x) / 2.0f, (lower.y + upper.y) / 2.0f}; }
    float radius() const { return std::min(upper.x - lower.x, upper.y - lower.y) / 2.0f; }
    /// `side` is -1 above the axis and 1 below it; over the angle it does not count.
    ImVec2 at(float theta, float value, float side) const {
        const float share = decades.share(value);
        if (polar) {
            const float r = share * radius();
            const ImVec2 from = middle();
            return {from.x + r * std::cos(theta), from.y + side * r * std::sin(theta)};
        }
        const float x = theta / std::numbers::pi_v<float>;
        return {lower.x + x * (upper.x - lower.x), upper.y - share * (upper.y - lower.y)};
    }
    /// The angle under a point of the screen, radians.
    float angleAt(ImVec2 point) const {
        if (polar) {
            return std::abs(std::atan2(point.y - middle().y, point.x - middle().x));
        }
        const float x = (point.x - lower.x) / (upper.x - lower.x);
        return std::clamp(x, 0.0f, 1.0f) * std::numbers::pi_v<float>;
    }
};

void drawGrid(ImDrawList* list, const Frame& frame) {
    const ImU32 line = ImGui::GetColorU32(ImGuiCol_TextDisabled, 0.35f);
    const auto count = static_cast<int>(frame.decades.hi - frame.decades.lo);
    for (int i = 1; i <= count; ++i) {
        const float share = static_cast<float>(i) / static_cast<float>(count);
        if (frame.polar) {
            list->AddCircle(frame.middle(), share * frame.radius(), line, 48);
        } else {
            const float y = frame.upper.y - share * (frame.upper.y - frame.lower.y);
            list->AddLine({frame.lower.x, y}, {frame.upper.x, y}, line);
        }
    }
    for (const float degrees : {0.0f, 45.0f, 90.0f, 135.0f, 180.0f}) {
        const auto value = static_cast<float>(std::pow(10.0, frame.decades.hi));
        const auto none = static_cast<float>(std::pow(10.0, frame.decades.lo));
        const float theta = glm::radians(degrees);
        for (const float side : {-1.0f, 1.0f}) {
            list->AddLine(frame.at(theta, none, side), frame.at(theta, value, side), line);
        }
    }
}

bool isGrey(const PhaseTable& table) {
    return std::ranges::all_of(table, [](const glm::vec3& p) { return p.r == p.g && p.g == p.b; });
}

void drawCurve(ImDrawList* list, const Frame& frame, const PhaseTable& table) {
    const bool grey = isGrey(table);
    for (int channel = 0; channel < (grey ? 1 : 3); ++channel) {
        const ImU32 colour = grey ? ImGui::GetColorU32(ImGuiCol_Text)
                                  : kWavelengths.at(static_cast<std::size_t>(channel));
        for (const float side : {-1.0f, 1.0f}) {
            for (int i = 0; i <= kPoints; ++i) {
                // As the table itself, close together where the peak is.
                const float x = static_cast<float>(i) / kPoints;
                const float theta = std::numbers::pi_v<float> * x * x;
                const glm::vec3 value = lookUp(table, std::cos(theta));
                list->PathLineTo(frame.at(theta, value[channel], side));
            }
            list->PathStroke(colour, ImDrawFlags_None, 1.3f);
            if (!frame.polar) break;
        }
    }
}

void drawMark(ImDrawList* list, const Frame& frame, const PhaseTable& table, float theta) {
    const ImU32 colour = ImGui::GetColorU32(ImGuiCol_CheckMark);
    const float value = lookUp(table, std::cos(theta)).g;
    const auto none = static_cast<float>(std::pow(10.0, frame.decades.lo));
    const ImVec2 at = frame.at(theta, value, -1.0f);
    list->AddLine(frame.at(theta, none, -1.0f), at, colour, 1.5f);
    list->AddCircleFilled(at, 0.22f * ImGui::GetFontSize(), colour);
}

std::string valueText(const PhaseTable& table, float theta) {
    const float value = lookUp(table, std::cos(theta)).g;
    return fmt::format("{} 1/sr", numberText(static_cast<double>(value), 3));
}

void drawNumbers(const PhaseCurve::Made& curve, const Frame& frame, float theta) {
    ImGui::BeginGroup();
    ImGui::TextDisabled("Sun to eye");
    ImGui::Text("%.1f°", static_cast<double>(glm::degrees(theta)));
    ImGui::TextUnformatted(valueText(curve.table, theta).c_str());
    ImGui::TextDisabled("Asymmetry");
    ImGui::Text("%.3f", static_cast<double>(curve.asymmetry));
    ImGui::TextDisabled("%d decades", static_cast<int>(frame.decades.hi - frame.decades.lo));
    ImGui::EndGroup();
}

void readOut(const PhaseCurve::Made& curve, const Frame& frame) {
    if (!wantsTooltip()) return;
    const float theta = frame.angleAt(ImGui::GetIO().MousePos);
    const std::string lines = isGrey(curve.table) ? "" : "\nRed, green, blue: 650, 550, 450 nm.";
    nextTooltipBeside({{frame.lower.x, frame.lower.y}, {frame.upper.x, frame.upper.y}});
    ImGui::SetTooltip(
        "%.1f°: %s%s\nPhase function, logarithmic, %s to %s 1/sr; 0° is forward. The dot is "
        "where\nsunlight scatters to the eye at the middle of the image. A click shows it %s.",
        static_cast<double>(glm::degrees(theta)), valueText(curve.table, theta).c_str(),
        lines.c_str(), numberText(std::pow(10.0, frame.decades.lo)).c_str(),
        numberText(std::pow(10.0, frame.decades.hi)).c_str(),
        frame.polar ? "over the angle" : "as a polar plot");
}

PhaseCurve::Made makeCurve(const PhaseSpec& spec) {
    return {spec, makePhaseTable(spec), phaseAsymmetry(spec)};
}

}  // namespace

double scatteringAngle(const Document& document, const Whereabouts& where) {
    const glm::dvec3 towardsSun = sunDirWorld(withSun(document.look, where));
    const glm::dvec3 forward =
        -compassDirWorld(document.camera.azimuthDeg, document.camera.elevationDeg);
    return std::acos(std::clamp(glm::dot(towardsSun, forward), -1.0, 1.0));
}

const PhaseCurve::Made* curveOf(FieldsState& state, const Look& look, Species species) {
    PhaseCurve& curve = state.curves[static_cast<std::size_t>(species)];
    const PhaseSpec& wanted = look.of(species).phase;
    if (curve.making.valid() &&
        curve.making.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
        curve.made = curve.making.get();
    }
    const bool current = curve.made && curve.made->spec == wanted;
    if (!current && !curve.making.valid()) {
        const bool slow = phaseFunction(wanted.kind).table != nullptr;
        const auto how = slow ? std::launch::async : std::launch::deferred;
        curve.making = std::async(how, makeCurve, wanted);
        if (how == std::launch::deferred) curve.made = curve.making.get();
    }
    return curve.made ? &*curve.made : nullptr;
}

void drawPhasePlot(const PanelContext& context, FieldsState& state, Species species) {
    const float em = ImGui::GetFontSize();
    const Document& document = context.session().document;
    const PhaseCurve::Made* curve = curveOf(state, document.look, species);
    if (state.curves[static_cast<std::size_t>(species)].making.valid()) context.next.again(kLookS);
    if (curve == nullptr) {
        ImGui::TextDisabled("Computing the phase function of droplets ...");
        return;
    }
    const float width = std::max(4.0f * em, ImGui::GetContentRegionAvail().x - kTextEms * em);
    const ImVec2 lower = ImGui::GetCursorScreenPos();
    const ImVec2 size{width, kHeightEms * em};
    const Frame frame{
        lower, {lower.x + size.x, lower.y + size.y}, decadesOf(curve->table), state.polar};
    if (ImGui::InvisibleButton("##phase", size)) state.polar = !state.polar;
    place(fmt::format("{}.phase_plot", info(species).id));
    readOut(*curve, frame);
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->PushClipRect(frame.lower, frame.upper, true);
    drawGrid(list, frame);
    drawCurve(list, frame, curve->table);
    const auto theta = static_cast<float>(scatteringAngle(document, context.session().where()));
    drawMark(list, frame, curve->table, theta);
    list->PopClipRect();
    ImGui::SameLine();
    drawNumbers(*curve, frame, theta);
}

}  // namespace neph::ui
