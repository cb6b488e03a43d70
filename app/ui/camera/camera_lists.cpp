// camera_lists.cpp: bookmarks and the keys of the camera path, with what can be done to each.
#include "app/ui/camera/camera_lists.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

#include "app/ui/time/path_lead.h"
#include "app/ui/widgets/input.h"
#include "app/ui/widgets/places.h"
#include "core/base/error.h"
#include "core/camera/camera_format.h"
#include "core/camera/camera_path_edit.h"

namespace neph::ui {
namespace {

constexpr std::size_t kMaxName = 80;  // letters of a bookmark's name

/// What a row asks for: applied when all rows are drawn.
enum class Wish { none, go, put, rename, remove, up, down };
struct Asked {
    std::size_t row = 0;
    Wish wish = Wish::none;
};

/// Width of `count` square buttons at the end of a line.
float buttonsWidth(int count) {
    return static_cast<float>(count) *
           (ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x);
}

bool squareButton(const char* label, const char* help) {
    ImGui::SameLine(0.0f, ImGui::GetStyle().ItemInnerSpacing.x);
    const bool pressed = ImGui::Button(label, {ImGui::GetFrameHeight(), 0.0f});
    tooltip(help);
    return pressed;
}

void beginRename(CameraTools& tools, const std::vector<Bookmark>& bookmarks, std::size_t row) {
    tools.renaming = static_cast<int>(row);
    tools.name = bookmarks[row].name;
}

/// The name as it is typed; taken on Enter and where the user goes elsewhere, left on Esc.
void renameRow(CameraTools& tools, Bookmark& bookmark) {
    ImGui::SetNextItemWidth(-1.0f);
    if (!ImGui::IsAnyItemActive()) ImGui::SetKeyboardFocusHere();
    const bool entered =
        ImGui::InputText("##name", &tools.name,
                         ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    place("bookmark.name");
    const bool escaped = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
    if (!entered && !ImGui::IsItemDeactivated()) return;
    if (!escaped && !tools.name.empty()) bookmark.name = tools.name.substr(0, kMaxName);
    tools.renaming = -1;
}

Wish bookmarkMenu() {
    Wish wish = Wish::none;
    if (!ImGui::BeginPopupContextItem("##menu")) return wish;
    if (ImGui::MenuItem("Go there")) wish = Wish::go;
    if (ImGui::MenuItem("Put it here")) wish = Wish::put;
    if (ImGui::MenuItem("Rename")) wish = Wish::rename;
    if (ImGui::MenuItem("Delete")) wish = Wish::remove;
    ImGui::EndPopup();
    return wish;
}

Wish bookmarkRow(const Bookmark& bookmark, std::size_t row) {
    const float width = ImGui::GetContentRegionAvail().x - buttonsWidth(1);
    Wish wish = ImGui::Button(bookmark.name.c_str(), {width, 0.0f}) ? Wish::go : Wish::none;
    place(fmt::format("bookmark:{}", row));
    tooltip("Click to go there; right click to put it here, rename or delete it");
    const Wish chosen = bookmarkMenu();
    if (chosen != Wish::none) wish = chosen;
    if (squareButton("x", "Delete")) wish = Wish::remove;
    place(fmt::format("bookmark.delete:{}", row));
    return wish;
}

void carryOut(Document& document, CameraTools& tools, const Asked& asked) {
    std::vector<Bookmark>& bookmarks = document.bookmarks;
    Bookmark& bookmark = bookmarks[asked.row];
    if (asked.wish == Wish::go) document.camera = bookmark.pose;
    if (asked.wish == Wish::put) bookmark.pose = document.camera;
    if (asked.wish == Wish::rename) beginRename(tools, bookmarks, asked.row);
    if (asked.wish == Wish::remove) {
        bookmarks.erase(bookmarks.begin() + static_cast<std::ptrdiff_t>(asked.row));
        tools.renaming = -1;
    }
}

Wish keyRow(CameraPath& path, std::size_t row) {
    Wish wish = Wish::none;
    auto atS = static_cast<float>(path.keys[row].atS);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - buttonsWidth(5));
    const std::string format = fmt::format("{}.   %.1f s", row + 1);
    ImGui::DragFloat("##at", &atS, 0.05f, 0.0f, static_cast<float>(kMaxPathS), format.c_str());
    if (ImGui::IsItemEdited()) setKeyTime(path, row, static_cast<double>(atS));
    place(fmt::format("path.at:{}", row));
    tooltip("When the camera is there; drag, or Ctrl+click to type");
    if (squareButton(">", "Go there")) wish = Wish::go;
    place(fmt::format("path.go:{}", row));
    if (squareButton("=", "Put this key where the camera is now")) wish = Wish::put;
    ImGui::BeginDisabled(row == 0);
    if (squareButton("\u2191", "Earlier")) wish = Wish::up;
    ImGui::EndDisabled();
    ImGui::BeginDisabled(row + 1 == path.keys.size());
    if (squareButton("\u2193", "Later")) wish = Wish::down;
    ImGui::EndDisabled();
    if (squareButton("x", "Delete")) wish = Wish::remove;
    place(fmt::format("path.delete:{}", row));
    return wish;
}

/// Goes to a key by letting the path lead there, so that its time is shown as well.
void goToKey(Session& session, Playback& playback, const PathKey& key) {
    playback.playing = false;
    playback.atS = key.atS;
    leadAlongPath(session, playback);
}

void carryOutKey(Session& session, Playback& playback, const Asked& asked) {
    CameraPath& path = session.document.path;
    if (asked.wish == Wish::go) goToKey(session, playback, path.keys[asked.row]);
    if (asked.wish == Wish::put) path.keys[asked.row].pose = session.document.camera;
    if (asked.wish == Wish::up) swapWithNext(path, asked.row - 1);
    if (asked.wish == Wish::down) swapWithNext(path, asked.row);
    if (asked.wish == Wish::remove) {
        path.keys.erase(path.keys.begin() + static_cast<std::ptrdiff_t>(asked.row));
    }
    if (path.keys.empty()) playback.alongPath = false;
}

void pastePath(Session& session) {
    const char* text = ImGui::GetClipboardText();
    try {
        std::vector<std::string> warnings;
        session.document.path = parseCameraPath(text == nullptr ? "" : text, "clipboard", warnings);
        for (std::string& warning : warnings) {
            session.say(Message::Kind::warning, std::move(warning));
        }
    } catch (const Error& error) {
        session.say(Message::Kind::error, error.message());
    }
}

/// Duration, playing, and the path as text.
void drawWhole(const PanelContext& context, Playback& playback) {
    CameraPath& path = context.session().document.path;
    const float inner = ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::BeginDisabled(path.keys.size() < 2);
    const bool plays = playback.playing && playback.alongPath;
    const float width = ImGui::CalcTextSize("Pause").x + 2.0f * ImGui::GetStyle().FramePadding.x;
    if (ImGui::Button(plays ? "Pause" : "Play", {width, 0.0f})) {
        playback.alongPath = true;
        context.actions.run("time.play");
    }
    place("path.play");
    tooltip(
        "Shows the path. The camera comes back when it is left, or stays where the user moves it");
    ImGui::SameLine(0.0f, inner);
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 5.5f);
    auto whole = static_cast<float>(durationS(path));
    if (ImGui::DragFloat("##whole", &whole, 0.1f, 0.1f, static_cast<float>(kMaxPathS), "%.1f s")) {
        setDuration(path, static_cast<double>(whole));
    }
    place("path.duration");
    tooltip("How long the whole path takes: all keys are moved in proportion");
    ImGui::EndDisabled();
    ImGui::SameLine(0.0f, inner);
    if (ImGui::Button("Copy")) ImGui::SetClipboardText(formatCameraPath(path).c_str());
    place("path.copy");
    tooltip("The path as JSON, as `render --path FILE` takes it");
    ImGui::SameLine(0.0f, inner);
    if (ImGui::Button("Paste")) pastePath(context.session());
    place("path.paste");
    tooltip("A path from JSON in the clipboard");
    ImGui::Checkbox("With the data's times", &path.withTime);
    place("path.with_time");
    tooltip("From the first to the last time of the data while the path is played");
    if (!playback.led) return;
    ImGui::SameLine();
    if (ImGui::Button("Leave")) playback.alongPath = playback.playing = false;
    place("path.leave");
    tooltip("Back to the camera as it was before");
}

}  // namespace

void drawBookmarks(const PanelContext& context, CameraTools& tools) {
    const bool open = ImGui::TreeNodeEx(
        "Bookmarks", ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_DefaultOpen);
    place("camera.bookmarks");
    if (!open) return;
    Document& document = context.session().document;
    std::vector<Bookmark>& bookmarks = document.bookmarks;
    Asked asked;
    for (std::size_t row = 0; row < bookmarks.size(); ++row) {
        ImGui::PushID(static_cast<int>(row));
        if (tools.renaming == static_cast<int>(row)) {
            renameRow(tools, bookmarks[row]);
        } else if (const Wish wish = bookmarkRow(bookmarks[row], row); wish != Wish::none) {
            asked = {row, wish};
        }
        ImGui::PopID();
    }
    if (asked.wish != Wish::none) carryOut(document, tools, asked);
    if (ImGui::Button("Add a bookmark  (B)", {-1.0f, 0.0f})) context.actions.run("camera.bookmark");
    place("camera.bookmark");
    ImGui::TreePop();
}

void drawPath(const PanelContext& context, Playback& playback) {
    const bool open = ImGui::TreeNodeEx(
        "Path", ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_DefaultOpen);
    place("camera.path");
    if (!open) return;
    CameraPath& path = context.session().document.path;
    Asked asked;
    for (std::size_t row = 0; row < path.keys.size(); ++row) {
        ImGui::PushID(static_cast<int>(row));
        if (const Wish wish = keyRow(path, row); wish != Wish::none) asked = {row, wish};
        ImGui::PopID();
    }
    if (asked.wish != Wish::none) carryOutKey(context.session(), playback, asked);
    if (ImGui::Button("Add a key here  (K)", {-1.0f, 0.0f})) context.actions.run("camera.path_key");
    place("camera.path_key");
    drawWhole(context, playback);
    ImGui::TreePop();
}

}  // namespace neph::ui
