// status_line.cpp: what is shown and how long it took; the newest message.
#include <fmt/format.h>
#include <imgui.h>

#include "app/ui/panels.h"

namespace neph::ui {
namespace {

/// "march, 512 steps, 16 samples", "slicing, 320 planes".
std::string workText(const FrameReport& report) {
    if (report.engine == Engine::slicing) return fmt::format("slicing, {} planes", report.planes);
    return fmt::format("march, {} steps, {} sample{}", report.planes, report.samples,
                       report.samples == 1 ? "" : "s");
}

std::string frameText(const FrameReport& report) {
    if (report.sizePx.x == 0) return {};
    return fmt::format("{:.0f} ms   {} x {} px   {}{}   {}", report.milliseconds, report.sizePx.x,
                       report.sizePx.y, workText(report), report.full ? "" : "   (draft)",
                       report.device);
}

std::string firstLine(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

std::string dataText(const Session& session) {
    if (session.loading()) {
        return fmt::format("{}  {:.0f} %", session.loadingLabel(),
                           100.0 * session.loadingFraction());
    }
    if (!session.messages.empty()) return firstLine(session.messages.back().text);
    return session.info() == nullptr ? "No data" : session.info()->model;
}

/// Said as long as it is so: the picture is not all that the data have.
std::string coarsenedText(const VolumeSummary* shown) {
    if (shown == nullptr || shown->plan.coarsening == 1) return {};
    return fmt::format("coarsened {0} x {0}   ", shown->plan.coarsening);
}

}  // namespace

void drawStatus(Ui& ui) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    if (beginFixed("##status", {0.0f, display.y - statusHeight()}, {display.x, statusHeight()})) {
        const std::string frame = frameText(ui.report);
        const std::string coarsened = coarsenedText(ui.session().shown());
        const float frameWidth = ImGui::CalcTextSize((coarsened + frame).c_str()).x;
        const float at = display.x - frameWidth - ImGui::GetStyle().WindowPadding.x;
        // The message gives way to the frame, not the other way round.
        ImGui::PushClipRect({0.0f, display.y - statusHeight()},
                            {at - ImGui::GetFontSize(), display.y}, true);
        ImGui::TextUnformatted(dataText(ui.session()).c_str());
        if (ImGui::IsItemClicked()) ui.showMessages = !ui.showMessages;
        ImGui::PopClipRect();
        ImGui::SameLine(at);
        ImGui::TextColored({0.95f, 0.80f, 0.45f, 1.0f}, "%s", coarsened.c_str());
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%s",
                              describe(ui.session().shown()->plan, *ui.session().info()).c_str());
        }
        ImGui::SameLine(0.0f, 0.0f);
        ImGui::TextDisabled("%s", frame.c_str());
    }
    ImGui::End();
}

}  // namespace neph::ui
