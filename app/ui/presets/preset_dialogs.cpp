// preset_dialogs.cpp: a name for a preset, its title and description, the path of one to open.
#include "app/ui/presets/preset_dialogs.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <utility>

#include "app/ui/presets/preset_commands.h"
#include "app/ui/widgets/dialogue.h"
#include "app/ui/widgets/places.h"
#include "app/ui/widgets/theme.h"
#include "core/base/error.h"
#include "core/preset/preset_files.h"

namespace neph::ui {
namespace {

constexpr float kFieldEms = 24.0f;

/// What a name would mean, below the field for it.
struct Verdict {
    bool fits = true;
    bool warns = false;
    std::string text;
};

Verdict verdictOn(const PresetBrowser& presets) {
    const std::string& name = presets.name;
    if (const std::string fault = presetNameFault(name); !fault.empty()) {
        return {false, !name.empty(), fault};
    }
    const PresetNameUse use = presetNameUse(name);
    if (presets.dialog == PresetDialog::rename) {
        if (name == presets.subject) return {false, false, "its name now"};
        if (use == PresetNameUse::free) return {true, false, "this name is free"};
        return {false, true, "there is a preset of this name"};
    }
    switch (use) {
        case PresetNameUse::own:
            return {true, true, "you have a preset of this name: it will be replaced"};
        case PresetNameUse::bundled:
            return {true, true, "hides the bundled preset of this name until yours is deleted"};
        case PresetNameUse::free:
            break;
    }
    return {true, false, "a new preset of your own"};
}

std::string_view titleOf(PresetDialog dialog) {
    switch (dialog) {
        case PresetDialog::saveAs:
            return "Save preset as";
        case PresetDialog::rename:
            return "Rename preset";
        case PresetDialog::describe:
            return "Title and description";
        case PresetDialog::open:
            break;
    }
    return "Preset from file";
}

bool saveUnderName(Session& session, const PresetBrowser& presets) {
    return session.savePreset(presets.name, true, presets.text);
}

bool rename(Session& session, PresetBrowser& presets) {
    const std::string from = presets.subject, to = presets.name;
    changePresets(session, presets, [&] {
        renamePreset(from, to);
        if (session.presetName == from) session.presetName = to;
        return fmt::format("Preset {} is now {}", from, to);
    });
    return true;
}

bool describe(Session& session, PresetBrowser& presets) {
    changePresets(session, presets, [&] {
        describePreset(presets.subject, presets.text);
        return "Described " + presets.subject;
    });
    return true;
}

bool carryOut(Session& session, PresetBrowser& presets) {
    switch (presets.dialog) {
        case PresetDialog::saveAs:
            return saveUnderName(session, presets);
        case PresetDialog::rename:
            return rename(session, presets);
        case PresetDialog::describe:
            return describe(session, presets);
        case PresetDialog::open:
            break;
    }
    const std::uint64_t before = session.messages.size();
    applyPreset(session, presets, presets.name);
    const auto& messages = session.messages;
    return messages.size() > before && messages.back().kind != Message::Kind::error;
}

/// A line to type in; true when Enter was pressed.
bool drawLine(const char* label, const char* hint, std::string& text, const char* placeName) {
    wantGlyphs(text);
    ImGui::TextUnformatted(label);
    ImGui::SetNextItemWidth(itemWidth(kFieldEms));
    ImGui::PushID(label);
    const bool entered =
        ImGui::InputTextWithHint("##line", hint, &text, ImGuiInputTextFlags_EnterReturnsTrue);
    ImGui::PopID();
    place(placeName);
    return entered;
}

void drawVerdict(const Verdict& verdict) {
    const ImVec4 plain = ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled);
    const ImVec4 colour = !verdict.warns ? plain : (verdict.fits ? warningColour() : errorColour());
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + itemWidth(kFieldEms));
    ImGui::TextUnformatted(verdict.text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

bool drawWords(PresetText& text) {
    const bool entered =
        drawLine("Title", "one line, shown with the card", text.title, "preset_dialog.title");
    ImGui::TextUnformatted("Description");
    ImGui::InputTextMultiline("##description", &text.description,
                              {itemWidth(kFieldEms), 4.5f * ImGui::GetFontSize()});
    place("preset_dialog.description");
    return entered;
}

/// What is typed; true when Enter was pressed on a line.
bool drawFieldsOf(PresetBrowser& presets, bool opening, Verdict& verdict) {
    bool entered = false;
    const bool hasName =
        presets.dialog == PresetDialog::saveAs || presets.dialog == PresetDialog::rename;
    if (opening) ImGui::SetKeyboardFocusHere(presets.dialog == PresetDialog::describe ? 1 : 0);
    if (hasName) {
        entered |= drawLine("Name", "", presets.name, "preset_dialog.name");
        verdict = verdictOn(presets);
        drawVerdict(verdict);
    }
    if (presets.dialog == PresetDialog::saveAs || presets.dialog == PresetDialog::describe) {
        entered |= drawWords(presets.text);
    }
    if (presets.dialog == PresetDialog::open) {
        entered |= drawLine("File", "a .json file with a look", presets.name, "preset_dialog.name");
        verdict = {!presets.name.empty(), false,
                   "Can be dropped on the window as well, or pasted (Ctrl+Shift+V)"};
        drawVerdict(verdict);
    }
    return entered;
}

const char* doneLabel(const PresetBrowser& presets) {
    if (presets.dialog == PresetDialog::rename) return "Rename";
    if (presets.dialog == PresetDialog::open) return "Load";
    const bool replaces =
        presets.dialog == PresetDialog::saveAs && presetNameUse(presets.name) == PresetNameUse::own;
    return replaces ? "Replace" : "Save";
}

}  // namespace

void drawPresetDialogs(const PanelContext& context, PresetBrowser& presets) {
    const bool opening = std::exchange(presets.openDialog, false);
    const std::string title = std::string(titleOf(presets.dialog)) + "###preset dialog";
    if (opening) ImGui::OpenPopup("###preset dialog");
    if (!beginModal(title.c_str())) return;
    Verdict verdict;
    const bool entered = drawFieldsOf(presets, opening, verdict);
    ImGui::Spacing();
    ImGui::BeginDisabled(!verdict.fits);
    const float width = 7.0f * ImGui::GetFontSize();
    const bool done = ImGui::Button(doneLabel(presets), {width, 0.0f});
    place("preset_dialog.ok");
    ImGui::EndDisabled();
    if (verdict.fits && (done || entered) && carryOut(context.session(), presets)) {
        presets.listed = presets.revealed = false;
        ImGui::CloseCurrentPopup();
    }
    ImGui::SameLine();
    const bool escape = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
    if (ImGui::Button("Cancel", {width, 0.0f}) || escape) ImGui::CloseCurrentPopup();
    place("preset_dialog.cancel");
    ImGui::EndPopup();
}

}  // namespace neph::ui
