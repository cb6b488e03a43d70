// ensemble_panel.cpp: asks for what is shown, and draws the map with the value under the mouse.
#include "app/ui/data/ensemble_panel.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <cmath>
#include <cstdint>
#include <utility>

#include "app/ui/widgets/input.h"
#include "app/ui/widgets/places.h"
#include "app/ui/widgets/theme.h"
#include "core/base/atomic_file.h"
#include "core/base/number_text.h"
#include "core/base/resources.h"
#include "core/look/medium.h"
#include "core/volume/ensemble_drawing.h"
#include "core/volume/ensemble_file.h"

namespace neph::ui {
namespace {

constexpr float kMapWidthEms = 34.0f, kFieldEms = 6.0f;
constexpr float kAroundMapEms = 27.0f;  // above and below the map, of the window's height
constexpr double kKmOfM = 1e-3;

/// What the depths of the document are read of; nothing before there are data.
std::optional<EnsembleKey> keyOf(const Session& session) {
    if (session.ensemble() == nullptr || !session.held()) return {};
    const SpeciesVolume& volume = *session.held()->volume;
    EnsembleKey key{session.info(), session.document.time, session.request(), {}};
    key.request.member = 0;
    key.request.humidity = false;
    key.extinctionPerHeld =
        planMedium(session.document.look, volume.holdings(), volume.cellM()).extinctionPerHeld;
    return key;
}

/// Volumes of members that the session has in memory, so that these are not read again.
KnownVolumes knownOf(Session& session) {
    KnownVolumes held;
    for (int member = 0; member < session.ensemble()->count(); ++member) {
        const auto found = session.heldOf(member);
        held.push_back(found ? found->volume : nullptr);
    }
    return held;
}

void startReading(Session& session, EnsemblePanel& panel, const EnsembleKey& key) {
    const std::shared_ptr<Dataset> data = session.data()->anotherHandle();
    if (!data) {
        panel.fault = "These data can be read in one place at a time alone";
        panel.left = key;
        return;
    }
    if (!panel.jobs) panel.jobs = std::make_unique<Jobs>();
    panel.wantedOf = key;
    panel.fault.clear();
    auto work = [&panel, data, key, look = session.document.look,
                 known = knownOf(session)](const Progress& progress) {
        const auto depths = std::make_shared<const EnsembleDepths>(
            readEnsembleDepths(*ensembleOf(*data), key.time, key.request, look, known, progress));
        return Jobs::Finish([&panel, depths, key] {
            panel.depths = depths;
            panel.places = depths->places();
            panel.readOf = key;
            panel.wantedOf.reset();
            panel.stale = true;
        });
    };
    panel.jobs->start("Reading the members", std::move(work), [&panel, key](const Error& error) {
        panel.fault = error.message();
        panel.left = key;
        panel.wantedOf.reset();
    });
}

/// Starts reading what is shown, and takes what was read.
void update(const PanelContext& context, EnsemblePanel& panel) {
    if (panel.jobs) panel.jobs->poll();
    const std::optional<EnsembleKey> key = keyOf(context.session());
    if (!key) return;
    const bool known = panel.readOf == key || panel.wantedOf == key || panel.left == key;
    if (!known && !context.session().loading()) startReading(context.session(), panel, *key);
    if (panel.wantedOf) context.next.again(kLookS);
}

void stopReading(EnsemblePanel& panel) {
    if (panel.jobs) panel.jobs->cancel();
    panel.left = std::exchange(panel.wantedOf, {});
}

void drawChoices(EnsemblePanel& panel) {
    constexpr std::array kNames{"Probability", "Mean", "Spread"};
    for (std::size_t i = 0; i < kNames.size(); ++i) {
        const auto map = static_cast<EnsembleMap>(i);
        if (i > 0) ImGui::SameLine();
        if (ImGui::RadioButton(kNames[i], panel.map == map)) {
            panel.stale = panel.stale || panel.map != map;
            panel.map = map;
        }
        place(fmt::format("ensemble.map:{}", i));
    }
    ImGui::SameLine();
    ImGui::BeginDisabled(panel.map != EnsembleMap::probability);
    ImGui::TextUnformatted("of optical depth above");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(kFieldEms * ImGui::GetFontSize());
    if (ImGui::InputFloat("##threshold", &panel.threshold, 0.0f, 0.0f, "%.4g",
                          ImGuiInputTextFlags_EnterReturnsTrue)) {
        panel.threshold = std::max(0.0f, panel.threshold);
        panel.stale = true;
    }
    place("ensemble.threshold");
    ImGui::EndDisabled();
}

/// As wide as suits the window.
int mapWidthPx(const EnsembleDepths& depths) {
    const float em = ImGui::GetFontSize();
    const float height = std::max(10.0f * em, ImGui::GetIO().DisplaySize.y - kAroundMapEms * em);
    const glm::vec2 extent(depths.grid.extentM());
    return static_cast<int>(std::min(kMapWidthEms * em, height * extent.x / extent.y));
}

void redraw(const PanelContext& context, EnsemblePanel& panel) {
    if (!panel.depths || !std::exchange(panel.stale, false)) return;
    const auto threshold = static_cast<double>(panel.threshold);
    panel.values = mapOf(*panel.depths, panel.map, threshold);
    panel.drawn = drawEnsembleMap(*panel.depths, panel.map, threshold, mapWidthPx(*panel.depths));
    const Services& services = context.services;
    if (panel.texture != 0 && services.dropImage) services.dropImage(panel.texture);
    panel.texture = services.showImage ? services.showImage(panel.drawn.image).texture : 0;
}

/// "probability 0.75 at x 42.5 km, y 61.5 km, 35.02 N 97.11 W".
std::string valueText(const EnsemblePanel& panel, glm::ivec2 column) {
    const EnsembleDepths& depths = *panel.depths;
    const auto at =
        static_cast<std::size_t>(column.y) * static_cast<std::size_t>(depths.grid.size.x) +
        static_cast<std::size_t>(column.x);
    const glm::dvec2 km = kKmOfM * depths.centreM(at);
    std::string text = fmt::format(
        "{} {} at x {} km, y {} km",
        panel.map == EnsembleMap::probability ? "probability" : "optical depth",
        std::isnan(panel.values[at]) ? "not known"
                                     : numberText(static_cast<double>(panel.values[at])),
        numberText(km.x, 6), numberText(km.y, 6));
    if (!panel.places.empty() && !std::isnan(panel.places[at].latitudeDeg)) {
        text += ", " + geoText(panel.places[at]);
    }
    return text;
}

void drawMapImage(const EnsemblePanel& panel) {
    const glm::vec2 imagePx(panel.drawn.image.size);
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float scale = std::min({1.0f, display.x / imagePx.x, 0.8f * display.y / imagePx.y});
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::Image(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(panel.texture)),
                 {imagePx.x * scale, imagePx.y * scale});
    place("ensemble.image");
    std::string under = " ";
    if (ImGui::IsItemHovered()) {
        const ImVec2 mouse = ImGui::GetMousePos();
        const glm::dvec2 pixel((mouse.x - at.x) / scale, (mouse.y - at.y) / scale);
        const glm::ivec3 size = panel.depths->grid.size;
        const glm::ivec2 column = panel.drawn.columnAt(pixel, {size.x, size.y});
        if (column.x >= 0) under = valueText(panel, column);
    }
    ImGui::TextUnformatted(under.c_str());
}

void writeFile(const PanelContext& context, const EnsemblePanel& panel) {
    Session& session = context.session();
    const std::filesystem::path file = std::filesystem::absolute(panel.file);
    const std::string ending = file.extension().string();
    const auto threshold = static_cast<double>(panel.threshold);
    const std::string source = fmt::format("Nephoscope {}", versionText());
    try {
        if (ending == ".nc") {
            replaceFile(file, ensembleNetcdf(*panel.depths, threshold, source));
        } else if (ending == ".csv") {
            replaceFile(file, ensembleCsv(*panel.depths, threshold, source));
        } else if (ending == ".png" && context.services.savePng) {
            context.services.savePng(file, panel.drawn.image);
        } else {
            throw Error({.where = panel.file,
                         .what = "has no ending of a map",
                         .expected = ".nc, .csv or .png"});
        }
        session.say(Message::Kind::note, "Wrote " + file.string());
    } catch (const Error& error) {
        session.say(Message::Kind::error, error.message());
    }
}

void drawExport(const PanelContext& context, const EnsemblePanel& panel, std::string& file) {
    const float em = ImGui::GetFontSize();
    ImGui::SetNextItemWidth(24.0f * em);
    ImGui::InputText("##file", &file);
    place("ensemble.file");
    tooltip("NetCDF (.nc) and a table (.csv) hold all three maps, an image (.png) the one shown.");
    ImGui::SameLine();
    if (ImGui::Button("Write")) writeFile(context, panel);
    place("ensemble.write");
}

/// What is read, or why nothing is.
void drawState(EnsemblePanel& panel) {
    if (panel.wantedOf) {
        ImGui::ProgressBar(static_cast<float>(panel.jobs->fraction()),
                           {20.0f * ImGui::GetFontSize(), 0.0f}, "reading the members");
        ImGui::SameLine();
        if (ImGui::Button("Cancel")) stopReading(panel);
        place("ensemble.cancel");
    } else if (panel.left) {
        ImGui::TextColored(warningColour(), "%s",
                           panel.fault.empty() ? "Cancelled" : panel.fault.c_str());
        if (ImGui::Button("Read again")) panel.left.reset();
        place("ensemble.again");
    }
}

void drawDepths(const PanelContext& context, EnsemblePanel& panel) {
    const EnsembleDepths& depths = *panel.depths;
    drawMapImage(panel);
    for (const std::string& member : depths.without) {
        ImGui::TextDisabled("%s has no such time", member.c_str());
    }
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + static_cast<float>(panel.drawn.image.size.x));
    ImGui::TextDisabled("Optical depths are as images have them: %s", depths.scale.c_str());
    ImGui::PopTextWrapPos();
    drawExport(context, panel, panel.file);
}

}  // namespace

void drawEnsemble(const PanelContext& context, EnsemblePanel& panel, bool& shown) {
    const glm::vec2 corner = context.layout().image.lower;
    const float margin = 0.6f * ImGui::GetFontSize();
    ImGui::SetNextWindowPos({corner.x + margin, corner.y + margin}, ImGuiCond_Appearing);
    const auto flags = ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                       ImGuiWindowFlags_AlwaysAutoResize;
    if (ImGui::Begin("Ensemble map", &shown, flags)) {
        if (context.session().ensemble() == nullptr) {
            ImGui::TextUnformatted("The data are a single run: File > Open ensemble.");
        } else {
            update(context, panel);
            drawChoices(panel);
            redraw(context, panel);
            drawState(panel);
            if (panel.depths) drawDepths(context, panel);
        }
    }
    ImGui::End();
    if (!shown) stopReading(panel);
}

}  // namespace neph::ui
