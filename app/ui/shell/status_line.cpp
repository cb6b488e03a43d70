// status_line.cpp: the newest message; how long the picture took, what it is made of and in which
// memory.
#include <fmt/format.h>
#include <imgui.h>

#include "app/ui/shell/panels.h"
#include "app/ui/widgets/layout.h"
#include "app/ui/widgets/places.h"
#include "app/ui/widgets/theme.h"
#include "core/volume/memory_setting.h"

namespace neph::ui {
namespace {

constexpr float kLeastMessageEms = 14.0f;

/// "march, 512 steps, 16 samples", "slicing, 320 planes, draft".
std::string workText(const FrameReport& report) {
    const EngineTraits& engine = traitsOf(report.engine);
    std::string work;
    if (engine.sampling == Sampling::converges) {
        work = fmt::format("{}, {}", engine.label, pathsText(report.reference));
    } else {
        work = fmt::format("{}, {}", engine.id, countText(report.planes, engine.unit));
    }
    if (engine.sampling == Sampling::averages) {
        work += ", " + countText(report.samples, "sample");
    }
    return work + (report.full ? "" : ", draft");
}

/// In motion frames a second say more.
std::string timeText(const Ui& ui) {
    const bool moves = ui.animates || ImGui::IsAnyMouseDown();
    const std::string time = fmt::format("{:.0f} ms", ui.report.milliseconds);
    if (!moves) return time;
    return fmt::format("{}, {:.0f} fps", time, static_cast<double>(ImGui::GetIO().Framerate));
}

std::string memoryText(const Ui& ui) {
    const std::string own = neph::memoryText(residentBytes());
    if (ui.report.gpuBytes == 0) return own;
    return own + " + " + neph::memoryText(ui.report.gpuBytes) + " GPU";
}

/// The most telling first: where there is no room the last are left out.
std::vector<std::string> frameTexts(const Ui& ui) {
    const FrameReport& report = ui.report;
    if (report.sizePx.x == 0) return {memoryText(ui), report.device};
    const std::string size = fmt::format("{} \u00d7 {} px", report.sizePx.x, report.sizePx.y);
    // How long a pass took is no measure of anything.
    if (traitsOf(report.engine).sampling == Sampling::converges) {
        return {workText(report), size, memoryText(ui), report.device};
    }
    return {timeText(ui), size, workText(report), memoryText(ui), report.device};
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

/// Said as long as it is so: the picture is not all that the data have.
std::string coarsenedText(const VolumeSummary* shown) {
    if (shown == nullptr || shown->plan.coarsening == 1) return {};
    return fmt::format("coarsened {0} \u00d7 {0}", shown->plan.coarsening);
}

float widthOf(const std::string& text) {
    return ImGui::CalcTextSize(text.c_str()).x;
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

void drawMessage(Ui& ui, const Area& area, float end) {
    // The message gives way to the frame, not the other way round.
    ImGui::PushClipRect({area.lower.x, area.lower.y}, {end, area.upper.y}, true);
    const Said said = newest(ui.session());
    ImGui::TextColored(said.colour, "%s", said.text.c_str());
    ImGui::PopClipRect();
    place("status.message");
    if (ImGui::IsItemClicked()) ui.showMessages = !ui.showMessages;
    if (ImGui::IsItemHovered()) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
        ImGui::SetTooltip("%s\n\nClick for the list of messages", said.text.c_str());
    }
}

}  // namespace

void drawStatus(Ui& ui) {
    const Area area = layoutOf(ui).status;
    const float em = ImGui::GetFontSize();
    if (beginFixed("##status", area.lower, area.size())) {
        const std::vector<std::string> texts = frameTexts(ui);
        const std::string coarsened = coarsenedText(ui.session().shown());
        const float margin = ImGui::GetStyle().WindowPadding.x;
        const float gap = coarsened.empty() ? 0.0f : em;
        const float room = area.size().x - kLeastMessageEms * em - 2.0f * margin;
        const std::string frame = fitting(texts, room - widthOf(coarsened) - gap);
        const float at = area.size().x - margin - widthOf(frame) - gap - widthOf(coarsened);
        ImGui::SetCursorPosY((area.size().y - ImGui::GetTextLineHeight()) / 2.0f);
        drawMessage(ui, area, at - em);
        ImGui::SameLine(at);
        ImGui::TextColored(warningColour(), "%s", coarsened.c_str());
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%s",
                              describe(ui.session().shown()->plan, *ui.session().info()).c_str());
        }
        ImGui::SameLine(0.0f, gap);
        ImGui::TextDisabled("%s", frame.c_str());
        place("status.frame");
        if (ImGui::IsItemHovered()) {
            std::string all;
            for (const std::string& text : texts) all += (all.empty() ? "" : "\n") + text;
            ImGui::SetTooltip("%s", all.c_str());
        }
    }
    ImGui::End();
}

}  // namespace neph::ui
