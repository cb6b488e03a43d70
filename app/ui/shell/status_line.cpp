// status_line.cpp: the newest message; how long the image took, what it is made of and in which
// memory.
#include "app/ui/shell/status_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui.h>

#include "app/ui/widgets/fixed_window.h"
#include "app/ui/widgets/input.h"
#include "app/ui/widgets/places.h"
#include "app/ui/widgets/reference_text.h"
#include "app/ui/widgets/theme.h"
#include "core/volume/memory_setting.h"
#include "core/volume/scale_data.h"

namespace neph::ui {
namespace {

constexpr float kLeastMessageEms = 14.0f;

/// "march, 512 steps, 16 samples", "slicing, 320 planes, draft".
std::string workText(const FrameReport& report) {
    const EngineTraits& engine = traitsOf(report.engine);
    std::string work;
    if (engine.refinement == Refinement::converges) {
        work = fmt::format("{}, {}", engine.label, referenceText(report.reference));
    } else {
        work = fmt::format("{}, {}", engine.id, countText(report.planes, engine.unit));
    }
    if (engine.refinement == Refinement::averages) {
        work += ", " + countText(report.samples, "sample");
    }
    return work + (report.full ? "" : ", draft");
}

/// "light at 6 cycles, 1.3 % to go", "light ± 0.6 %" of full transport; of other light how far it
/// is off.
std::string lightText(const FrameReport& report) {
    if (!report.light) return report.error ? std::string() : report.knownError;
    const LightProgress& light = *report.light;
    if (!light.settled) {
        return fmt::format("light at {}, {:.1f} % to go", countText(light.cycles, "cycle"),
                           100.0 * light.remaining);
    }
    std::string text = light.chance < 0.0
                           ? "light settled"
                           : fmt::format("light \u00b1 {:.1f} %", 100.0 * light.chance);
    constexpr double kWorthSaying = 0.1;
    if (light.underResolved > kWorthSaying) {
        text += fmt::format(", {:.0f} % under-resolved", 100.0 * light.underResolved);
    }
    return text;
}

/// In motion frames per second say more.
std::string timeText(const FrameReport& report, bool animates) {
    const bool moves = animates || ImGui::IsAnyMouseDown();
    const std::string time = fmt::format("{:.0f} ms", report.milliseconds);
    if (!moves) return time;
    return fmt::format("{}, {:.0f} fps", time, static_cast<double>(ImGui::GetIO().Framerate));
}

std::string memoryText(const FrameReport& report) {
    const std::string own = neph::memoryText(residentBytes());
    if (report.gpuBytes == 0) return own;
    return own + " + " + neph::memoryText(report.gpuBytes) + " GPU";
}

/// The most telling first: where there is no room the last are left out.
std::vector<std::string> frameTexts(const FrameReport& report, bool animates) {
    if (report.sizePx.x == 0) return {memoryText(report), report.device};
    const std::string size = fmt::format("{} \u00d7 {} px", report.sizePx.x, report.sizePx.y);
    // How long a pass took is no measure of anything.
    if (traitsOf(report.engine).refinement == Refinement::converges) {
        return {workText(report), size, memoryText(report), report.device};
    }
    std::vector<std::string> texts{timeText(report, animates), size, workText(report)};
    if (std::string light = lightText(report); !light.empty()) texts.push_back(std::move(light));
    texts.push_back(memoryText(report));
    texts.push_back(report.device);
    return texts;
}

/// "Error now: 3.1 % ± 0.4 (bias -0.2 %)", with dots while it gets better.
std::string errorNow(const FrameReport& report) {
    if (!report.error) return report.measuring ? "Measuring the error ..." : "";
    return "Error now: " + errorText(*report.error) + (report.measuring ? " ..." : "");
}

std::string firstLine(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

struct Said {
    std::string text;
    ImVec4 colour;
};

Said newest(const Session& session) {
    const ImVec4 usual = ImGui::GetStyleColorVec4(ImGuiCol_Text);
    if (session.loading()) {
        return {
            fmt::format("{}  {:.0f} %", session.loadingLabel(), 100.0 * session.loadingFraction()),
            usual};
    }
    if (session.messages.empty()) {
        return {session.info() == nullptr ? "No data" : session.info()->model, usual};
    }
    const Message& message = session.messages.back();
    const bool error = message.kind == Message::Kind::error;
    const bool warning = message.kind == Message::Kind::warning;
    return {firstLine(message.text), error ? errorColour() : warning ? warningColour() : usual};
}

/// Said as long as it is so: the image is not all that the data have.
std::string coarsenedText(const VolumeSummary* shown) {
    if (shown == nullptr || shown->plan.coarsening == 1) return {};
    return fmt::format("coarsened {0} \u00d7 {0}", shown->plan.coarsening);
}

float widthOf(const std::string& text) {
    return ImGui::CalcTextSize(text.c_str()).x;
}

/// Why what is shown is not to scale, a line each; empty where it is.
std::string offScaleText(const Session& session) {
    const VolumeSummary* shown = session.shown();
    if (shown == nullptr || session.info() == nullptr) return {};
    const ScaleData data = scaleDataOf(*session.info(), *shown);
    return fmt::format("{}", fmt::join(notToScale(session.document.look, data), "\n"));
}

/// What there is room for, side by side.
std::string fitting(const std::vector<std::string>& texts, float room) {
    std::string line;
    for (const std::string& text : texts) {
        const std::string longer = line + (line.empty() ? "" : "    ") + text;
        if (widthOf(longer) > room) break;
        line = longer;
    }
    return line;
}

/// Words that are said for as long as they are so, before the figures of the frame.
struct Standing {
    std::string text, place, tooltip;
    ImVec4 colour;
};

std::vector<Standing> standing(const Session& session, const FrameReport& report) {
    std::vector<Standing> all;
    const auto add = [&all](Standing one) {
        if (!one.text.empty()) all.push_back(std::move(one));
    };
    const VolumeSummary* shown = session.shown();
    add({coarsenedText(shown), "status.coarsened",
         shown == nullptr ? "" : describe(shown->plan, *session.info()), warningColour()});
    const std::string off = offScaleText(session);
    add({off.empty() ? "" : "Not to scale", "status.scale",
         "The image does not show water and ice as the data have them:\n" + off,
         ImGui::GetStyleColorVec4(ImGuiCol_Text)});
    add({report.previewSamples > 0 ? previewText(report.previewSamples) : "", "status.preview",
         previewMeaning(), warningColour()});
    add({errorNow(report), "status.error",
         report.error ? meaningOf(*report.error)
                      : "The reference of this view is being traced, at low resolution",
         ImGui::GetStyleColorVec4(ImGuiCol_Text)});
    return all;
}

void drawMessage(const Session& session, const Area& area, float end, bool& showMessages) {
    // The message yields to the frame, not the other way round.
    ImGui::PushClipRect({area.lower.x, area.lower.y}, {end, area.upper.y}, true);
    const Said said = newest(session);
    wantGlyphs(said.text);
    ImGui::TextColored(said.colour, "%s", said.text.c_str());
    ImGui::PopClipRect();
    place("status.message");
    if (ImGui::IsItemClicked()) showMessages = !showMessages;
    if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    tooltip(said.text + "\n\nClick for the list of messages");
}

}  // namespace

void drawStatus(const PanelContext& context, const FrameReport& report, bool& showMessages) {
    const Session& session = context.session();
    const Area area = context.layout().status;
    const float em = ImGui::GetFontSize();
    if (beginFixed("##status", area.lower, area.size())) {
        const std::vector<std::string> texts = frameTexts(report, context.next.animates);
        const std::vector<Standing> words = standing(session, report);
        const float margin = ImGui::GetStyle().WindowPadding.x;
        float taken = 0.0f;
        for (const Standing& one : words) taken += widthOf(one.text) + em;
        const float room = area.size().x - kLeastMessageEms * em - 2.0f * margin;
        const std::string frame = fitting(texts, room - taken);
        const float at = area.size().x - margin - widthOf(frame) - taken;
        ImGui::SetCursorPosY((area.size().y - ImGui::GetTextLineHeight()) / 2.0f);
        drawMessage(session, area, at - em, showMessages);
        ImGui::SameLine(at);
        for (const Standing& one : words) {
            ImGui::TextColored(one.colour, "%s", one.text.c_str());
            place(one.place);
            tooltip(one.tooltip);
            ImGui::SameLine(0.0f, em);
        }
        ImGui::TextDisabled("%s", frame.c_str());
        place("status.frame");
        tooltip(fmt::format("{}", fmt::join(texts, "\n")));
    }
    ImGui::End();
}

}  // namespace neph::ui
