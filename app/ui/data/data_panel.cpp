// data_panel.cpp: what is open, which part of it is shown how finely, and what memory that takes.
#include "app/ui/data/data_panel.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/ui/widgets/input.h"
#include "app/ui/widgets/places.h"
#include "app/ui/widgets/theme.h"
#include "core/dataset/grid_text.h"
#include "core/volume/memory_setting.h"

namespace neph::ui {
namespace {

constexpr double kMPerKm = 1000.0;
constexpr float kLabelEms = 4.0f;
constexpr std::size_t kMostPaths = 12;  // in a tooltip

void wrapped(const std::string& text) {
    ImGui::PushTextWrapPos(0.0f);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
}

/// A label, and beside it where all values begin the place for one.
void label(const char* text) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", text);
    ImGui::SameLine(ImGui::GetStyle().WindowPadding.x + kLabelEms * ImGui::GetFontSize());
}

void fact(const char* name, const std::string& value) {
    label(name);
    wrapped(value);
}

std::vector<std::filesystem::path> filesOf(const DatasetInfo& info) {
    std::vector<std::filesystem::path> files;
    for (const TimeInfo& when : info.times) {
        if (files.empty() || files.back() != when.file) files.push_back(when.file);
    }
    return files;
}

std::string pathsText(const DatasetInfo& info) {
    const std::vector<std::filesystem::path> files = filesOf(info);
    std::string paths;
    for (std::size_t i = 0; i < std::min(files.size(), kMostPaths); ++i) {
        paths += (i > 0 ? "\n" : "") + files[i].string();
    }
    if (files.size() > kMostPaths) paths += fmt::format("\nand {} more", files.size() - kMostPaths);
    wantGlyphs(paths);
    return paths;
}

/// Names of the series' files, full paths in the tooltip.
void drawFiles(const DatasetInfo& info, int time) {
    const std::vector<std::filesystem::path> files = filesOf(info);
    const auto current = static_cast<std::size_t>(time);
    if (current >= info.times.size()) return;
    const std::string more =
        files.size() > 1 ? fmt::format("  (of {} files)", files.size()) : std::string();
    fact("File", info.times[current].file.filename().string() + more);
    tooltip(pathsText(info));
}

/// What of an ensemble is shown, and from which files.
void drawMember(const Ensemble& ensemble, int member, int time) {
    if (member == kMeanMember) {
        fact("Member", fmt::format("mean of {} members", ensemble.membersAt(time).size()));
        tooltip(
            "The mean content of each cell. It is smoother than any member: thin cloud where some "
            "of them have cloud, and not a cloud that could be.");
        return;
    }
    fact("Member",
         fmt::format("{}, {} of {}", ensemble.nameOf(member), member + 1, ensemble.count()));
    if (const auto own = ensemble.timeIn(member, time)) drawFiles(ensemble.infoOf(member), *own);
}

void drawDomain(const DatasetInfo& info) {
    const std::string scheme = info.scheme.empty() ? "" : ", " + info.scheme;
    fact("Model", info.model + scheme);
    fact("Grid", fmt::format("{} \u00d7 {} \u00d7 {} cells of {}", info.size.x, info.size.y,
                             info.size.z, cellWidthText(info, " \u00d7 ")));
    if (info.times.size() < 2) return fact("Time", info.times.front().label);
    fact("Times", fmt::format("{}, from {} to {}, {}", info.times.size(), info.times.front().label,
                              info.times.back().label, timeStepText(info)));
}

void drawPlan(const VolumeSummary& shown, const DatasetInfo& info, const MemoryBudget& budget) {
    const ReadPlan& plan = shown.plan;
    const std::string how = describe(plan, info);
    ImGui::PushStyleColor(ImGuiCol_Text, plan.coarsening > 1
                                             ? warningColour()
                                             : ImGui::GetStyleColorVec4(ImGuiCol_Text));
    const bool stated = plan.coarsening > 1 || !plan.nested.empty();
    const std::string full = stated ? "" : "At full resolution";
    fact("Shown", how.empty() ? full : how + (full.empty() ? "" : " ") + full);
    ImGui::PopStyleColor();
    fact("Takes", fmt::format("{} of {}, and for images {} of {}", memoryText(plan.machineBytes),
                              memoryText(budget.machine), memoryText(plan.gpuBytes),
                              memoryText(budget.gpu)));
    tooltip(
        "Fields are held in the machine's memory; the renderer holds them once more, with what "
        "it makes of them, in the memory for images. Data that would take more than either "
        "are averaged to coarser columns.");
}

/// The whole domain, metres.
BoxM domainOf(const DatasetInfo& info, const VolumeSummary& shown) {
    const glm::dvec2 extent = info.extentM();
    return {{0.0, 0.0, shown.domainHeightsM.x}, {extent.x, extent.y, shown.domainHeightsM.y}};
}

/// One axis of the region; true when the user has let go of a change.
bool editAxis(const char* name, float& lowKm, float& highKm, double leastM, double mostM) {
    const auto least = static_cast<float>(leastM / kMPerKm);
    const auto most = static_cast<float>(mostM / kMPerKm);
    label(name);
    ImGui::SetNextItemWidth(-1.0f);
    ImGui::PushID(name);
    ImGui::DragFloatRange2("##range", &lowKm, &highKm, (most - least) / 400.0f, least, most,
                           "%.4g km", nullptr, ImGuiSliderFlags_AlwaysClamp);
    const bool done = ImGui::IsItemDeactivatedAfterEdit();
    place(std::string("data.") + name);
    tooltip(
        "The part of the domain that is shown, from its south-west corner; drag, or "
        "Ctrl+click to type. A smaller part is shown more finely where the whole is coarsened.");
    ImGui::PopID();
    return done;
}

void editRegion(Session& session, DataEdits& edits, const DatasetInfo& info,
                const VolumeSummary& shown) {
    const BoxM domain = domainOf(info, shown);
    BoxM chosen = session.region().value_or(domain);
    chosen.lowerM = glm::max(chosen.lowerM, domain.lowerM);
    chosen.upperM = glm::min(chosen.upperM, domain.upperM);
    // While the mouse is on it the draft is shown; else what is chosen.
    if (!edits.holdsRegion) {
        edits.regionKm = {chosen.lowerM / kMPerKm, chosen.upperM / kMPerKm};
    }
    bool done = false, active = false;
    for (int axis = 0; axis < 3; ++axis) {
        constexpr std::array kLabels{"East", "North", "Height"};
        done |= editAxis(kLabels.at(static_cast<std::size_t>(axis)), edits.regionKm[0][axis],
                         edits.regionKm[1][axis], domain.lowerM[axis], domain.upperM[axis]);
        active |= ImGui::IsAnyItemActive();
    }
    edits.holdsRegion = active;
    if (!done) return;
    BoxM region{glm::dvec3(edits.regionKm[0]) * kMPerKm, glm::dvec3(edits.regionKm[1]) * kMPerKm};
    const glm::dvec3 least = glm::dvec3(info.spacingM, shown.grid.spacingM.z);
    region.upperM = glm::max(region.upperM, region.lowerM + least);
    session.setRegion(region);
}

void drawButtons(Session& session, const VolumeSummary& shown) {
    ImGui::BeginDisabled(!session.region());
    if (ImGui::Button("Whole domain")) session.setRegion({});
    ImGui::EndDisabled();
    ImGui::SameLine();
    ImGui::BeginDisabled(!shown.clouds);
    if (ImGui::Button("Around the clouds")) showAroundClouds(session);
    ImGui::EndDisabled();
}

void editMemory(const PanelContext& context, DataEdits& edits) {
    label("Memory");
    ImGui::SetNextItemWidth(-1.0f);
    const std::string hint = memoryText(context.session().budget().machine);
    if (ImGui::InputTextWithHint("##memory", hint.c_str(), &edits.memory,
                                 ImGuiInputTextFlags_EnterReturnsTrue)) {
        context.requests.memory = edits.memory;
    }
    place("data.memory");
    tooltip(
        "How much memory the times that are held may take: 2GiB, 512MiB, or 50% of what is "
        "free; empty for a quarter of what is free. Enter sets it, now and for the next time "
        "the program starts.");
}

void drawCache(const Session& session) {
    fact("Held",
         fmt::format("{} of {} times, {} of {}", session.timesHeld(), session.info()->times.size(),
                     memoryText(session.cache().bytes()), memoryText(session.cache().limit())));
    tooltip("Times in memory are shown at once; the time bar marks them.");
}

/// What is open, in a width of so many pixels: "Data: wrfout_d01_2013..., 13 times".
std::string headline(const DatasetInfo& info, int time, float width) {
    const std::size_t count = info.times.size();
    const auto current = std::min(static_cast<std::size_t>(std::max(time, 0)), count - 1);
    const std::string file = info.times[current].file.filename().string();
    const std::string times = fmt::format(", {} time{}", count, count == 1 ? "" : "s");
    const float room = width - ImGui::CalcTextSize(("Data: " + times).c_str()).x;
    return "Data: " + shortened(file, room) + times;
}

/// One line, which says what is open and unfolds the rest. True when that is to be drawn.
bool drawHeader(const PanelContext& context) {
    const Session& session = context.session();
    const DatasetInfo* info = session.info();
    const VolumeSummary* shown = session.shown();
    const bool open = info != nullptr && shown != nullptr && !info->times.empty();
    const float em = ImGui::GetFontSize();
    const std::string words =
        open ? headline(*info, session.document.time, ImGui::GetContentRegionAvail().x - 2.0f * em)
             : "Data: none yet";
    const bool coarse = open && shown->plan.coarsening > 1;
    if (coarse) ImGui::PushStyleColor(ImGuiCol_Text, warningColour());
    ImGui::SetNextItemOpen(context.settings.dataDetails);
    context.settings.dataDetails = ImGui::CollapsingHeader((words + "###data").c_str());
    if (coarse) ImGui::PopStyleColor();
    place("data.header");
    if (open && !context.settings.dataDetails) {
        tooltip(pathsText(*info) + (coarse ? "\n" + describe(shown->plan, *info) : "") +
                "\nClick for grid, region and memory");
    }
    return context.settings.dataDetails;
}

}  // namespace

void showAroundClouds(Session& session) {
    const VolumeSummary* shown = session.shown();
    if (shown == nullptr || !shown->clouds) return;
    BoxM region = withMargin(*shown->clouds);
    const BoxM domain = domainOf(*session.info(), *shown);
    region.lowerM = glm::max(region.lowerM, domain.lowerM);
    region.upperM = glm::min(region.upperM, domain.upperM);
    session.setRegion(region);
}

void drawData(const PanelContext& context, DataEdits& edits) {
    Session& session = context.session();
    const DatasetInfo* info = session.info();
    const VolumeSummary* shown = session.shown();
    if (!drawHeader(context) || info == nullptr || shown == nullptr) return;
    if (const Ensemble* ensemble = session.ensemble()) {
        drawMember(*ensemble, session.document.member, session.document.time);
    } else {
        drawFiles(*info, session.document.time);
    }
    drawDomain(*info);
    ImGui::Spacing();
    drawPlan(*shown, *info, session.budget());
    ImGui::Spacing();
    editRegion(session, edits, *info, *shown);
    drawButtons(session, *shown);
    ImGui::Spacing();
    editMemory(context, edits);
    if (info->times.size() > 1) drawCache(session);
    ImGui::Checkbox("Follow new times", &session.follow);
    place("data.follow");
    tooltip(
        "From the last time to a new last one, as soon as a file that is still being written "
        "has it. New times are noticed in any case.");
}

}  // namespace neph::ui
