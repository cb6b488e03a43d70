// fields_panel.cpp: liquid and ice, a row per field: visible, alone, swatch, mixing scale;
// unfolded, the rest of its parameters and what the data hold of it.
#include "app/ui/fields/fields_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include "app/ui/fields/fields_icons.h"
#include "app/ui/fields/fields_link.h"
#include "app/ui/fields/fields_plots.h"
#include "app/ui/widgets/colour_editor.h"
#include "app/ui/widgets/input.h"
#include "app/ui/widgets/parameter_widget.h"
#include "app/ui/widgets/places.h"

namespace neph::ui {
namespace {

// Columns of a row, from its left, in letters.
constexpr float kEyeEms = 1.4f, kSoloEms = 2.9f, kSwatchEms = 4.4f, kNameEms = 5.9f,
                kScaleEms = 10.2f;
constexpr float kButtonEms = 1.4f, kSwatchWidthEms = 1.2f;
constexpr float kLeastSliderEms = 2.5f;
constexpr float kAbsentAlpha = 0.45f;

const Parameter& row(Species s, std::string_view name) {
    return parameter(fmt::format("{}.{}", info(s).id, name));
}

/// Why a field cannot be seen whatever its settings, in short and in full; empty when it can.
struct Absence {
    std::string brief, full;
};

Absence absence(const Session& session, Species s) {
    const VolumeSummary* shown = session.shown();
    if (shown == nullptr) return {"no data yet", "There are no data yet."};
    const auto index = static_cast<std::size_t>(s);
    const DatasetInfo* series = session.info();
    if (!shown->present[index] && series != nullptr &&
        series->find(VariableRole::mixingRatio, s) != nullptr) {
        return {"not at this time", fmt::format("The file of this time has no {}.", info(s).id)};
    }
    if (!shown->present[index]) {
        return {"not in the data", fmt::format("The model has no {}.", info(s).id)};
    }
    if (!shown->anything[index]) {
        return {"none at this time",
                fmt::format("There is no {} at this time in what is shown.", info(s).id)};
    }
    return {};
}

void column(float start, float ems) {
    ImGui::SameLine(start + ems * ImGui::GetFontSize());
}

void drawEye(Session& session, Species s) {
    Look& look = session.document.look;
    const Parameter& visible = row(s, "visible");
    if (eyeButton("##eye", look.of(s).visible, kButtonEms * ImGui::GetFontSize())) {
        look.of(s).visible = !look.of(s).visible;
    }
    place(visible.id);
    parameterExtras(visible, session.document, session.presetLook);
}

void drawSolo(Session& session, FieldsState& state, Species s) {
    const bool solo = isSolo(session.document.look, s);
    if (letterButton("S", solo, kButtonEms * ImGui::GetFontSize())) toggleSolo(session, state, s);
    place(fmt::format("{}.solo", info(s).id));
    tooltip(solo ? "Shows the fields that were visible before"
                 : fmt::format("Solo: shows {} alone", info(s).id));
}

/// The colour that the image gives the field, and round it the field's own.
void drawSwatch(Session& session, Species s) {
    Look& look = session.document.look;
    const Parameter& colour = row(s, "colour");
    const bool natural = look.colour == ColourMode::natural;
    const glm::vec3 shown = natural ? glm::vec3(1.0f) : look.of(s).colour;
    if (swatchButton("##swatch", shown, look.of(s).colour,
                     kSwatchWidthEms * ImGui::GetFontSize())) {
        ImGui::OpenPopup("##colour");
    }
    place(colour.id);
    parameterExtras(colour, session.document, session.presetLook);
    if (!ImGui::BeginPopup("##colour")) return;
    ImGui::TextUnformatted((colour.group + ": " + colour.label).c_str());
    if (natural) {
        ImGui::TextDisabled("White in the image while Colour is Natural");
    }
    colourPicker(look.of(s).colour);
    ImGui::EndPopup();
}

void drawScale(Session& session, Species s) {
    const float least = kLeastSliderEms * ImGui::GetFontSize();
    ImGui::SetNextItemWidth(std::max(least, ImGui::GetContentRegionAvail().x - 1.0f));
    parameterEditor(row(s, "mixing_scale"), session.document, session.presetLook);
}

/// The label of the mixing scale.
void drawName(Session& session, Species s, const Absence& absent) {
    const std::string name(info(s).label);
    if (absent.brief.empty()) {
        parameterLabel(row(s, "mixing_scale"), name, session.document, session.presetLook);
        return;
    }
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(name.c_str());
    tooltip(absent.full);
}

/// The row of a field; true when it is unfolded.
bool header(Session& session, FieldsState& state, Species s, const Absence& absent) {
    const float start = ImGui::GetCursorPosX();
    const bool present = absent.brief.empty();
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, present ? 1.0f : kAbsentAlpha);
    changedMark(row(s, "mixing_scale"), session.document, session.presetLook);
    const bool open = ImGui::TreeNodeEx("##fold", ImGuiTreeNodeFlags_NoTreePushOnOpen |
                                                      ImGuiTreeNodeFlags_FramePadding |
                                                      ImGuiTreeNodeFlags_AllowItemOverlap);
    place(fmt::format("{}.fold", info(s).id));
    column(start, kEyeEms);
    drawEye(session, s);
    column(start, kSoloEms);
    drawSolo(session, state, s);
    column(start, kSwatchEms);
    drawSwatch(session, s);
    column(start, kNameEms);
    drawName(session, s, absent);
    column(start, kScaleEms);
    if (present || session.shown() == nullptr) {
        drawScale(session, s);
    } else {
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(absent.brief.c_str());
        tooltip(absent.full);
    }
    ImGui::PopStyleVar();
    return open;
}

bool drawsItself(const Parameter& r) {
    return r.id.ends_with(".visible") || r.id.ends_with(".colour") ||
           r.id.ends_with(".mixing_scale");
}

/// Said where parameters of a field do not act because of a mode of the whole image.
void drawUnused(const Parameter& r, const Look& look) {
    const std::string because(overruledBy(r, look));
    if (!because.empty()) ImGui::TextDisabled("Not used: %s", because.c_str());
}

void unfolded(const PanelContext& context, FieldsState& state, Species s, const Absence& absent) {
    Session& session = context.session();
    Look& look = session.document.look;
    ImGui::Indent();
    if (!absent.full.empty()) {
        ImGui::TextDisabled("%s", absent.full.c_str());
        parameterWidget(row(s, "mixing_scale"), session.document, session.presetLook);
    }
    for (const Parameter& r : lookTable()) {
        if (r.species != s || drawsItself(r) || !applies(r, look)) continue;
        drawUnused(r, look);
        if (r.id.ends_with(".noise_amount")) drawPhasePlot(context, state, s);
        parameterWidget(r, session.document, session.presetLook);
    }
    ImGui::Spacing();
    if (const VolumeSummary* shown = session.shown()) {
        drawHistogram(shown->histograms[static_cast<std::size_t>(s)]);
        drawDepth(state, session, s);
    }
    ImGui::Unindent();
    ImGui::Spacing();
}

void field(const PanelContext& context, FieldsState& state, Species s) {
    Session& session = context.session();
    Look& look = session.document.look;
    const Look before = look;
    const Absence absent = absence(session, s);
    ImGui::PushID(static_cast<int>(s));
    if (header(session, state, s, absent)) unfolded(context, state, s, absent);
    ImGui::PopID();
    if (linkOf(state, s)) follow(look, before, state.atPress, s);
}

void groupHead(FieldsState& state, const char* name, Species first) {
    const float start = ImGui::GetCursorPosX();
    const float em = ImGui::GetFontSize();
    bool& linked = linkOf(state, first);
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", name);
    column(start, kSwatchEms);
    ImGui::PushID(name);
    if (chainButton("##link", linked, kSwatchWidthEms * em)) linked = !linked;
    ImGui::PopID();
    place(fmt::format("fields.link:{}", info(first).liquid ? "liquid" : "ice"));
    tooltip(fmt::format(
        "{} fields together: what is changed of one is changed of all.\nMixing scale and constant "
        "radius by the same factor; radius source, albedo,\nphase function and noise to the same "
        "value. Colour, density and the eye\nstay each field's own.",
        linked ? "Unlink: now these" : "Link these"));
    column(start, kScaleEms);
    ImGui::TextDisabled("Mixing scale");
}

}  // namespace

void drawFields(const PanelContext& context, FieldsState& state) {
    if (!ImGui::CollapsingHeader("Fields", ImGuiTreeNodeFlags_DefaultOpen)) return;
    if (!ImGui::IsAnyItemActive()) state.atPress = context.session().document.look;
    for (const bool liquid : {true, false}) {
        groupHead(state, liquid ? "Liquid" : "Ice", liquid ? Species::cloud : Species::ice);
        for (int s = 0; s < kSpeciesCount; ++s) {
            const auto species = static_cast<Species>(s);
            if (info(species).liquid == liquid) field(context, state, species);
        }
    }
}

}  // namespace neph::ui
