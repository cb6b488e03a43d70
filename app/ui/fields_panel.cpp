// fields_panel.cpp: a row a field: visible, swatch, mixing scale; unfolded, the rest of its rows.
#include <fmt/format.h>
#include <imgui.h>

#include "app/ui/panels.h"
#include "app/ui/parameter_widget.h"

namespace neph::ui {
namespace {

const Parameter& row(Species s, std::string_view name) {
    return parameter(fmt::format("{}.{}", info(s).id, name));
}

/// Why a field cannot be seen whatever its settings; empty when it can.
std::string absence(const Session& session, Species s) {
    if (!session.shown()) return "No data yet";
    const auto index = static_cast<std::size_t>(s);
    if (!session.shown()->present[index]) {
        return fmt::format("The model has no {}", info(s).id);
    }
    if (!session.shown()->anything[index]) {
        return fmt::format("There is no {} at this time", info(s).id);
    }
    return {};
}

bool inHeader(const Parameter& r) {
    return r.id.ends_with(".visible") || r.id.ends_with(".colour") ||
           r.id.ends_with(".mixing_scale");
}

void unfolded(Species s, Look& look) {
    ImGui::Indent();
    for (const Parameter& r : lookTable()) {
        if (r.species == s && !inHeader(r) && applies(r, look)) parameterWidget(r, look);
    }
    ImGui::Unindent();
    ImGui::Spacing();
}

/// The row of a field; true when it is unfolded.
bool header(Species s, Look& look) {
    const float em = ImGui::GetFontSize();
    const float start = ImGui::GetCursorPosX();
    const bool open = ImGui::TreeNodeEx("##fold", ImGuiTreeNodeFlags_NoTreePushOnOpen |
                                                      ImGuiTreeNodeFlags_FramePadding |
                                                      ImGuiTreeNodeFlags_AllowItemOverlap);
    ImGui::SameLine(start + 1.5f * em);
    parameterEditor(row(s, "visible"), look);
    ImGui::SameLine();
    parameterEditor(row(s, "colour"), look);
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(info(s).label.data(), info(s).label.data() + info(s).label.size());
    ImGui::SameLine(start + 9.0f * em);
    ImGui::SetNextItemWidth(-1.0f);
    parameterEditor(row(s, "mixing_scale"), look);
    return open;
}

void field(Session& session, Species s) {
    const std::string reason = absence(session, s);
    ImGui::PushID(static_cast<int>(s));
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, reason.empty() ? 1.0f : 0.45f);
    ImGui::BeginGroup();
    const bool open = header(s, session.document.look);
    ImGui::EndGroup();
    ImGui::PopStyleVar();
    if (open && !reason.empty()) ImGui::TextDisabled("%s", reason.c_str());
    if (open) unfolded(s, session.document.look);
    ImGui::PopID();
}

}  // namespace

void drawFields(Ui& ui) {
    const float em = ImGui::GetFontSize();
    ImGui::TextDisabled("Fields");
    ImGui::SameLine(ImGui::GetCursorPosX() + 9.0f * em);
    ImGui::TextDisabled("Mixing scale");
    ImGui::Separator();
    for (int s = 0; s < kSpeciesCount; ++s) field(ui.session(), static_cast<Species>(s));
}

}  // namespace neph::ui
