// output_panel.cpp: the export dialogue, and the notice of the export that runs or has ended.
#include "app/ui/output/output_panel.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>

#include "app/ui/output/output_run.h"
#include "app/ui/widgets/dialogue.h"
#include "app/ui/widgets/input.h"
#include "app/ui/widgets/places.h"
#include "app/ui/widgets/theme.h"

namespace neph::ui {
namespace {

constexpr float kDialogueEms = 34.0f, kLabelEms = 9.0f, kNoticeEms = 26.0f;
constexpr int kMostSidePx = 65535;  // as the command line takes them

/// A label in a column of its own; what follows stands beside it.
void label(const char* text) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(text);
    ImGui::SameLine(kLabelEms * ImGui::GetFontSize());
}

/// Width of the dialogue, and of what stands beside a label.
float widthOfDialogue() {
    return dialogueWidth(kDialogueEms);
}
float widthBeside() {
    return widthOfDialogue() - (kLabelEms + 2.0f) * ImGui::GetFontSize();
}

void radioBeside(const char* text) {
    beside(text, widthOfDialogue(), ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x);
}

/// One of several, greyed with a reason where it cannot be.
template <typename Choice>
void choice(const char* text, const char* name, Choice& value, Choice own,
            const std::string& reason = {}) {
    ImGui::BeginDisabled(!reason.empty());
    if (ImGui::RadioButton(text, value == own)) value = own;
    ImGui::EndDisabled();
    place(name);
    if (!reason.empty()) tooltip(reason);
}

void drawWhat(const Session& session, ExportSettings& settings) {
    const DatasetInfo* info = session.info();
    const std::size_t times = info == nullptr ? 0 : info->times.size();
    const CameraPath& path = session.document.path;
    label("Export");
    choice("This image", "export.image", settings.what, ExportWhat::image);
    const std::string all = times > 1 ? fmt::format("All {} times", times) : "All times";
    radioBeside(all.c_str());
    choice(all.c_str(), "export.times", settings.what, ExportWhat::times,
           times > 1 ? "" : "The data have only one time");
    radioBeside("Camera path");
    choice("Camera path", "export.path", settings.what, ExportWhat::path,
           path.keys.empty() ? "There is no camera path: set its keys in the camera panel" : "");
}

void drawFormat(ExportSettings& settings) {
    label("Format");
    choice("PNG", "export.png", settings.format, ExportFormat::png);
    radioBeside("EXR");
    choice("EXR", "export.exr", settings.format, ExportFormat::exr);
    tooltip("Linear light, for further processing");
    radioBeside("MP4 video");
    std::string reason;
    if (settings.what == ExportWhat::image) {
        reason = "A video is made of all times, or of images along the path";
    } else if (!findProgram("ffmpeg")) {
        reason = "A video needs the program ffmpeg, which is not on the PATH: apt install ffmpeg";
    }
    choice("MP4 video", "export.mp4", settings.format, ExportFormat::mp4, reason);
}

void drawSize(glm::ivec2 window, ExportSettings& settings) {
    const std::string own = fmt::format("As in the window, {} \u00d7 {}", window.x, window.y);
    const std::array<const char*, 4> names{own.c_str(), "1920 \u00d7 1080", "3840 \u00d7 2160",
                                           "Other"};
    const float width = widthBeside();
    label("Size");
    ImGui::SetNextItemWidth(width);
    int index = static_cast<int>(settings.size);
    if (ImGui::Combo("##size", &index, names.data(), static_cast<int>(names.size()))) {
        settings.size = static_cast<ExportSize>(index);
    }
    place("export.size");
    if (settings.size == ExportSize::own) {
        label("Pixels");
        ImGui::SetNextItemWidth(width);
        ImGui::InputInt2("##pixels", &settings.ownPx.x);
        settings.ownPx = glm::clamp(settings.ownPx, 1, kMostSidePx);
        place("export.pixels");
    }
    label("Rays per pixel");
    ImGui::SetNextItemWidth(width);
    int rays = settings.supersample - 1;
    if (ImGui::Combo("##rays", &rays,
                     "1\0"
                     "2 \u00d7 2\0"
                     "3 \u00d7 3\0"
                     "4 \u00d7 4\0")) {
        settings.supersample = rays + 1;
    }
    tooltip("More rays smooth the edges and take proportionally longer");
    place("export.supersample");
}

void drawQuality(const Session& session, const ExportScene& scene, ExportSettings& settings) {
    const float width = widthBeside();
    if (traitsOf(session.document.look.engine).refinement == Refinement::averages) {
        label("Samples");
        ImGui::SetNextItemWidth(width);
        ImGui::SliderInt("##samples", &settings.samples, 1, 64, "%d",
                         ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
        tooltip("Samples averaged per pixel: more give less noise");
        place("export.samples");
    }
    if (settings.format == ExportFormat::mp4 || settings.what == ExportWhat::path) {
        label("Frame rate");
        ImGui::SetNextItemWidth(width);
        ImGui::InputDouble("##fps", &settings.fps, 1.0, 5.0, "%.3g per second");
        noteNumberField();
        settings.fps = std::clamp(settings.fps, 0.1, 240.0);
        place("export.fps");
    }
    if (settings.format != ExportFormat::mp4) {
        label("Background");
        ImGui::Checkbox("Transparent, without sky and ground", &settings.transparent);
        place("export.transparent");
    }
    if (!scene.split) return;
    label("Compare");
    ImGui::Checkbox("Both sides, as in the window", &settings.bothSides);
    place("export.compare");
}

/// How many images there will be.
int countOf(const Session& session, const ExportSettings& settings) {
    if (settings.what == ExportWhat::times && session.info() != nullptr) {
        return static_cast<int>(session.info()->times.size());
    }
    if (settings.what == ExportWhat::image) return 1;
    return static_cast<int>(durationS(session.document.path) * settings.fps + 1e-6) + 1;
}

/// Name, what will be made, or why it cannot be.
bool drawFile(const Session& session, const ExportScene& scene, ExportSettings& settings) {
    label("File");
    ImGui::SetNextItemWidth(widthBeside());
    wantGlyphs(settings.file);
    ImGui::InputText("##file", &settings.file);
    place("export.file");
    if (!ImGui::IsItemActive()) {
        settings.file = withEnding(settings.file, settings.format).string();
    }
    ImGui::PushTextWrapPos(widthOfDialogue() - ImGui::GetFontSize());
    const std::string fault = exportFault(settings, session);
    if (!fault.empty()) {
        ImGui::TextColored(warningColour(), "%s", fault.c_str());
    } else {
        const glm::ivec2 size = sizeOf(settings, scene);
        const int count = countOf(session, settings);
        const bool video = settings.format == ExportFormat::mp4;
        const std::string length =
            video ? fmt::format(", {}", durationText(count / settings.fps)) : std::string();
        ImGui::TextDisabled("%s", fmt::format("{} image{} of {} \u00d7 {} pixels{}; "
                                              "a number is added to a name that is taken",
                                              count, count == 1 ? "" : "s", size.x, size.y, length)
                                      .c_str());
    }
    ImGui::PopTextWrapPos();
    return fault.empty();
}

/// The bar of the export that runs, with a button to stop it.
void drawProgress(ExportJob& job) {
    const float room = ImGui::GetContentRegionAvail().x;
    const float button = std::min(6.0f * ImGui::GetFontSize(), room / 2.0f);
    ImGui::ProgressBar(static_cast<float>(job.fraction()), {room - button, 0.0f},
                       job.text().c_str());
    ImGui::SameLine();
    if (ImGui::Button("Cancel", {-1.0f, 0.0f})) job.cancel();
    place("export.cancel");
}

/// How it ended.
void drawEnd(OutputState& output) {
    const ExportJob& job = *output.job;
    const std::string file = job.file().string();
    ImGui::PushTextWrapPos(ImGui::GetContentRegionAvail().x + ImGui::GetCursorPosX());
    switch (job.state()) {
        case ExportJob::State::done:
            ImGui::TextUnformatted(
                job.done() > 1
                    ? fmt::format("Wrote {} images, the last is {}", job.done(), file).c_str()
                    : ("Wrote " + file).c_str());
            break;
        case ExportJob::State::cancelled:
            ImGui::TextUnformatted(stoppedText(job).c_str());
            break;
        default:
            ImGui::TextColored(errorColour(), "The export failed");
            ImGui::TextUnformatted(job.fault().c_str());
    }
    ImGui::PopTextWrapPos();
    if (job.state() == ExportJob::State::done && !file.empty()) {
        if (ImGui::Button("Copy path")) ImGui::SetClipboardText(file.c_str());
        place("export.copy_path");
        if (!output.open) ImGui::SameLine();
    }
    if (output.open) return;
    const bool close = ImGui::Button("Close");
    place("export.dismiss");
    if (close) output.job.reset();
}

void drawDialogue(const PanelContext& context, OutputState& output, const ExportScene& scene) {
    const Session& session = context.session();
    ExportSettings& settings = output.settings;
    if (settings.file.empty()) settings.file = defaultExportFile().string();
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({display.x / 2.0f, display.y / 2.0f}, ImGuiCond_Appearing,
                            {0.5f, 0.5f});
    ImGui::SetNextWindowSizeConstraints({widthOfDialogue(), 0.0f},
                                        {widthOfDialogue(), dialogueRoom().y});
    if (ImGui::Begin("Export", &output.open,
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse |
                         ImGuiWindowFlags_NoSavedSettings)) {
        const bool running = exports(output);
        ImGui::BeginDisabled(running);
        drawWhat(session, settings);
        drawFormat(settings);
        drawSize(scene.windowPx, settings);
        drawQuality(session, scene, settings);
        const bool can = drawFile(session, scene, settings);
        ImGui::EndDisabled();
        ImGui::Separator();
        if (running) {
            drawProgress(*output.job);
        } else {
            if (output.job) drawEnd(output);
            ImGui::BeginDisabled(!can);
            if (ImGui::Button("Export", {8.0f * ImGui::GetFontSize(), 0.0f})) {
                startExport(context, output, settings, scene);
            }
            place("export.start");
            ImGui::EndDisabled();
            ImGui::SameLine();
            if (ImGui::Button("Close")) output.open = false;
            place("export.close");
        }
        if (ImGui::IsWindowFocused() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)) &&
            !ImGui::IsAnyItemActive()) {
            output.open = false;
        }
    }
    ImGui::End();
}

/// The same where the dialogue is closed: in the image's upper right corner, which no overlay
/// has.
void drawNotice(OutputState& output, const PixelBox& image) {
    const ImGuiIO& io = ImGui::GetIO();
    const float em = ImGui::GetFontSize();
    const float room =
        static_cast<float>(image.size().x) / io.DisplayFramebufferScale.x - 2.0f * em;
    const ImVec2 corner{
        static_cast<float>(image.upper.x) / io.DisplayFramebufferScale.x - em,
        io.DisplaySize.y - static_cast<float>(image.upper.y) / io.DisplayFramebufferScale.y + em};
    ImGui::SetNextWindowPos(corner, ImGuiCond_Always, {1.0f, 0.0f});
    ImGui::SetNextWindowSize({std::clamp(room, 1.0f, kNoticeEms * em), 0.0f});
    if (ImGui::Begin("##export", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                         ImGuiWindowFlags_NoFocusOnAppearing)) {
        if (exports(output)) {
            drawProgress(*output.job);
        } else {
            drawEnd(output);
        }
    }
    ImGui::End();
}

/// Asked when the window is to close while an export runs.
void drawQuitQuestion(const PanelContext& context, OutputState& output) {
    const char* title = "An export is running";
    if (output.asksToQuit && !ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
    if (!beginModal(title)) return;
    const std::string how = output.job ? output.job->text() + ". " : std::string();
    ImGui::TextUnformatted((how + "What should become of it?").c_str());
    ImGui::TextDisabled("Finished images stay in any case.");
    ImGui::Spacing();
    if (ImGui::Button("Quit when it is done")) quitAfterExport(context, output);
    place("quit.after");
    beside("Stop it and quit");
    if (ImGui::Button("Stop it and quit")) quitAndStopExport(context, output);
    place("quit.stop");
    beside("Quit and let it go on");
    if (ImGui::Button("Quit and let it go on")) quitAndLeaveExport(context, output);
    place("quit.leave");
    tooltip("It goes on in the background, without a window, and stops by itself when it is done");
    beside("Cancel");
    const bool escape = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
    if (ImGui::Button("Cancel") || escape) output.asksToQuit = false;
    place("quit.cancel");
    if (!output.asksToQuit) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace

void drawOutput(const PanelContext& context, OutputState& output, const ExportScene& scene) {
    updateExport(context, output);
    drawQuitQuestion(context, output);
    if (output.open) {
        drawDialogue(context, output, scene);
    } else if (output.job) {
        drawNotice(output, imageBox(context.layout()));
    }
}

}  // namespace neph::ui
