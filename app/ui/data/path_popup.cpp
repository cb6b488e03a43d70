// path_popup.cpp: the file browser drawn: a line for the path, the folder's list, what to do with
// it.
//
// What is typed before the line has the keyboard, in a frame that takes long, is taken from ImGui's
// queue, so that no key is lost.
#include "app/ui/data/path_popup.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <utility>

#include "app/ui/widgets/input.h"
#include "app/ui/widgets/places.h"
#include "app/ui/widgets/theme.h"

namespace neph::ui {
namespace {

struct Words {
    const char *title, *hint, *button;
};
/// In the order of BrowseFor. The part after ### is the popup's name.
constexpr std::array<Words, 5> kWords{{
    {"Open data###files",
     "A file, or a folder with the files of one series. Ctrl or Shift and a click take several.",
     "Open"},
    {"Open session###files", "A session file; its data are opened with it.", "Open"},
    {"Save session###files", "Data, looks, cameras, bookmarks and the path are kept.", "Save"},
    {"Where are the data?###files", "The file that has moved, or the folder it is in now.",
     "Look there"},
    {"Open ensemble###files",
     "The folder that holds the members, or several runs: Ctrl or Shift and a click take several.",
     "Open"},
}};

std::string sizeText(std::uint64_t bytes) {
    constexpr std::array kUnits{"B", "KiB", "MiB", "GiB", "TiB"};
    auto size = static_cast<double>(bytes);
    std::size_t unit = 0;
    for (; size >= 1024.0 && unit + 1 < kUnits.size(); ++unit) size /= 1024.0;
    return fmt::format("{:.{}f} {}", size, unit > 0 && size < 10.0 ? 1 : 0, kUnits.at(unit));
}

/// What ImGui has for whatever line has the keyboard, as UTF-8.
std::string typedNow() {
    std::string typed;
    for (const ImWchar c : ImGui::GetIO().InputQueueCharacters) {
        const auto code = static_cast<unsigned>(c);
        if (code < 32 || code == 127) continue;
        if (code < 0x80) {
            typed += static_cast<char>(code);
            continue;
        }
        if (code < 0x800) {
            typed += static_cast<char>(0xC0U | (code >> 6U));
        } else {
            typed += static_cast<char>(0xE0U | (code >> 12U));
            typed += static_cast<char>(0x80U | ((code >> 6U) & 0x3FU));
        }
        typed += static_cast<char>(0x80U | (code & 0x3FU));
    }
    return typed;
}

void setText(ImGuiInputTextCallbackData& data, const std::string& text) {
    data.DeleteChars(0, data.BufTextLen);
    data.InsertChars(0, text.c_str());
}

/// Moves the mark in the list, and puts its name on the line.
void moveMark(FileBrowser& browser, int step) {
    const int last = static_cast<int>(shownEntries(browser).size()) - 1;
    if (last < 0) return;
    const int from = browser.marked < 0 && step < 0 ? last + 1 : browser.marked;
    choose(browser, std::clamp(from + step, 0, last), false, false);
}

int onLine(ImGuiInputTextCallbackData* data) {
    auto& browser = *static_cast<FileBrowser*>(data->UserData);
    switch (data->EventFlag) {
        case ImGuiInputTextFlags_CallbackCompletion:
            browser.line.assign(data->Buf, static_cast<std::size_t>(data->BufTextLen));
            setText(*data, completed(browser));
            break;
        case ImGuiInputTextFlags_CallbackHistory:
            moveMark(browser, data->EventKey == ImGuiKey_UpArrow ? -1 : 1);
            setText(*data, browser.line);
            break;
        case ImGuiInputTextFlags_CallbackEdit: {
            const std::string text(data->Buf, static_cast<std::size_t>(data->BufTextLen));
            data->DeleteChars(0, static_cast<int>(laterPath(text)));
            browser.narrows = true;
            browser.selectsName = false;
            browser.marked = -1;
            browser.chosen.clear();
            browser.replaces = false;
            browser.fault.clear();
            break;
        }
        default:
            break;
    }
    browser.line.assign(data->Buf, static_cast<std::size_t>(data->BufTextLen));
    if (!browser.early.empty() && browser.selectsName) {
        typeOn(browser, std::exchange(browser.early, {}));
        setText(*data, browser.line);
        browser.toEnd = true;
    } else if (!browser.early.empty()) {  // before what was typed since
        data->InsertChars(std::min(browser.earlyAt, data->BufTextLen), browser.early.c_str());
        browser.early.clear();
        browser.narrows = true;
    }
    if (browser.toEnd) {
        browser.line.assign(data->Buf, static_cast<std::size_t>(data->BufTextLen));
        const NamePart name = namePart(browser);
        data->CursorPos = data->SelectionEnd = static_cast<int>(name.to);
        data->SelectionStart = static_cast<int>(browser.selectsName ? name.from : name.to);
        browser.toEnd = false;
    }
    return 0;
}

/// True when what stands on the line is to be opened.
bool drawLine(FileBrowser& browser) {
    if (std::exchange(browser.focus, false)) {
        ImGui::SetKeyboardFocusHere();
        browser.awaitsKeys = true;
    }
    ImGui::SetNextItemWidth(-1.0f);
    const std::string typed = typedNow();  // before ImGui uses it up
    std::string edited = browser.line;     // ImGui's own while it calls onLine, which sets the line
    // ImGui's undo does not know what onLine changes, and would reach beyond the text.
    const bool entered = ImGui::InputText(
        "##path", &edited,
        ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackCompletion |
            ImGuiInputTextFlags_CallbackHistory | ImGuiInputTextFlags_CallbackEdit |
            ImGuiInputTextFlags_CallbackAlways | ImGuiInputTextFlags_NoUndoRedo,
        onLine, &browser);
    browser.line = edited;
    wantGlyphs(browser.line);
    place("files.line");
    if (ImGui::IsItemActive() && std::exchange(browser.awaitsKeys, false)) {
        browser.early = typed;  // which ImGui passes over in the frame that gives the keyboard
        const NamePart name = namePart(browser);
        browser.earlyAt = static_cast<int>(browser.selectsName ? name.from : name.to);
        if (!pressed(ImGuiKey_Enter)) return false;
        typeOn(browser, std::exchange(browser.early, {}));
        return true;
    }
    if (entered) browser.focus = browser.toEnd = true;
    if (ImGui::IsItemActive() || entered) return entered;
    const bool inList =
        !ImGui::IsWindowFocused() && ImGui::IsWindowFocused(ImGuiFocusedFlags_ChildWindows);
    if (inList && pressed(ImGuiKey_Backspace)) goUp(browser);
    typeOn(browser, typed);
    return pressed(ImGuiKey_Enter);
}

/// A row of the list. True when it was double-clicked.
bool drawRow(FileBrowser& browser, int row, FileEntry& entry) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const bool good = fits(browser, entry);
    if (!good)
        ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyle().Colors[ImGuiCol_TextDisabled]);
    wantGlyphs(entry.name);
    const std::string label = entry.name + (entry.folder ? "/" : "");
    const bool on = browser.chosen.contains(entry.name);
    bool opened = false;
    if (ImGui::Selectable(
            label.c_str(), on,
            ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowDoubleClick)) {
        const ImGuiIO& io = ImGui::GetIO();
        const bool several = (browser.purpose == BrowseFor::data && !entry.folder) ||
                             browser.purpose == BrowseFor::members;
        choose(browser, row, several && io.KeyCtrl, several && io.KeyShift);
        browser.focus = browser.toEnd = true;
        opened = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    }
    place("file:" + entry.name);
    if (row == browser.marked && !ImGui::IsItemVisible()) ImGui::SetScrollHereY();
    ImGui::TableNextColumn();
    if (!entry.folder) ImGui::TextUnformatted(sizeText(entry.bytes).c_str());
    ImGui::TableNextColumn();
    if (entry.changed != 0) {
        ImGui::TextUnformatted(
            fmt::format("{:%Y-%m-%d %H:%M}", fmt::localtime(entry.changed)).c_str());
    }
    if (!good) ImGui::PopStyleColor();
    return opened;
}

bool drawList(FileBrowser& browser, float height) {
    constexpr ImGuiTableFlags kFlags =
        ImGuiTableFlags_ScrollY | ImGuiTableFlags_BordersOuter | ImGuiTableFlags_RowBg;
    if (!ImGui::BeginTable("##list", 3, kFlags, {0.0f, height})) return false;
    const float em = ImGui::GetFontSize();
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn("Name", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("Size", ImGuiTableColumnFlags_WidthFixed, 5.0f * em);
    ImGui::TableSetupColumn("Changed", ImGuiTableColumnFlags_WidthFixed, 8.5f * em);
    ImGui::TableHeadersRow();
    const std::vector<int> shown = shownEntries(browser);
    int opened = -1;
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(shown.size()));
    while (clipper.Step()) {
        for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) {
            const int index = shown[static_cast<std::size_t>(row)];
            if (drawRow(browser, row, browser.entries[static_cast<std::size_t>(index)]))
                opened = row;
        }
    }
    if (shown.empty()) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextDisabled(browser.entries.empty() ? "This folder is empty" : "No matching name");
    }
    ImGui::EndTable();
    return opened >= 0;
}

/// The row below the list. True for the button that opens.
bool drawButtons(FileBrowser& browser, const Words& words, bool& left) {
    if (ImGui::Button("Up")) goUp(browser);
    place("files.up");
    ImGui::SameLine();
    const bool several = browser.chosen.size() > 1;
    std::string told = browser.fault;
    if (told.empty() && browser.replaces) told = "This file already exists.";
    if (told.empty() && several) told = fmt::format("{} chosen", browser.chosen.size());
    const char* button = browser.replaces ? "Replace it" : words.button;
    const float em = ImGui::GetFontSize();
    const float buttons = 13.0f * em;
    const float room = ImGui::GetContentRegionAvail().x - buttons;
    const float before = ImGui::GetCursorPosX();
    ImGui::PushTextWrapPos(before + room);
    ImGui::TextUnformatted(told.c_str());
    ImGui::PopTextWrapPos();
    ImGui::SameLine(before + room);
    const bool opened = ImGui::Button(button, {6.0f * em, 0.0f});
    place("files.open");
    ImGui::SameLine();
    left = ImGui::Button("Cancel", {6.0f * em, 0.0f});
    place("files.cancel");
    return opened;
}

void carryOut(const PanelContext& context, SessionDialogs& dialogs,
              const std::vector<std::string>& names) {
    switch (dialogs.browser.purpose) {
        case BrowseFor::data:
            openFiles(context, dialogs, names);
            break;
        case BrowseFor::session:
            openSessionFile(context, dialogs, names.front());
            break;
        case BrowseFor::saveSession:
            saveSessionFile(context, dialogs, names.front());
            break;
        case BrowseFor::moved:
            if (dialogs.waiting) answer(*dialogs.waiting, names.front());
            break;
        case BrowseFor::members:
            openMembers(context, names);
            break;
    }
}

}  // namespace

void drawPathPopup(const PanelContext& context, SessionDialogs& dialogs) {
    FileBrowser& browser = dialogs.browser;
    const bool opens = std::exchange(dialogs.opensBrowser, false);
    if (opens) ImGui::OpenPopup("###files");
    const Words& words = kWords.at(static_cast<std::size_t>(browser.purpose));
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos({display.x / 2.0f, display.y / 2.0f}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize(
        {std::min(48.0f * em, display.x - 2.0f * em), std::min(34.0f * em, display.y - 2.0f * em)});
    if (!ImGui::BeginPopupModal(words.title, nullptr,
                                ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings)) {
        return;
    }
    ImGui::PushTextWrapPos(0.0f);
    ImGui::TextDisabled("%s", words.hint);
    ImGui::PopTextWrapPos();
    bool wanted = drawLine(browser);
    refresh(browser);
    const float below = ImGui::GetFrameHeightWithSpacing() + ImGui::GetStyle().ItemSpacing.y;
    wanted |= drawList(browser, std::max(4.0f * em, ImGui::GetContentRegionAvail().y - below));
    bool left = false;
    wanted |= drawButtons(browser, words, left);
    left |= !opens && pressed(ImGuiKey_Escape);
    const auto names = wanted && !left ? accept(browser) : std::nullopt;
    if (left || names) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    if (names) carryOut(context, dialogs, *names);
}

}  // namespace neph::ui
