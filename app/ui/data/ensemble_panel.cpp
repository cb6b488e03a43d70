// ensemble_panel.cpp: asks for what is shown, and draws the map with the value under the mouse.
#include "app/ui/data/ensemble_panel.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <cmath>
#include <utility>

#include "app/ui/widgets/input.h"
#include "app/ui/widgets/places.h"
#include "app/ui/widgets/plot_canvas.h"
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

/// As large as suits the window.
ImVec2 plotSize(const EnsembleDepths& depths) {
    const float em = ImGui::GetFontSize();
    const float height = std::max(12.0f * em, ImGui::GetIO().DisplaySize.y - kAroundMapEms * em);
    const glm::vec2 extent(depths.grid.extentM());
    const float map = std::min(kMapWidthEms * em, height * extent.x / extent.y);
    return {map + 12.0f * em, map * extent.y / extent.x + 7.0f * em};
}

void redraw(EnsemblePanel& panel) {
    if (!panel.depths || !std::exchange(panel.stale, false)) return;
    panel.figure = ensembleFigure(*panel.depths, panel.map, static_cast<double>(panel.threshold));
}

/// "probability 0.75 at x 42.5 km, y 61.5 km, 35.02 N 97.11 W".
std::string valueText(const EnsemblePanel& panel, glm::ivec2 column) {
    const EnsembleDepths& depths = *panel.depths;
    const auto at =
        static_cast<std::size_t>(column.y) * static_cast<std::size_t>(depths.grid.size.x) +
        static_cast<std::size_t>(column.x);
    const glm::dvec2 km = kKmOfM * depths.centreM(at);
    std::string text =
        fmt::format("{} {} at x {} km, y {} km",
                    panel.map == EnsembleMap::probability ? "probability" : "optical depth",
                    std::isnan(panel.figure.field->values[at])
                        ? "not known"
                        : numberText(static_cast<double>(panel.figure.field->values[at])),
                    numberText(km.x, 6), numberText(km.y, 6));
    if (!panel.places.empty() && !std::isnan(panel.places[at].latitudeDeg)) {
        text += ", " + geoText(panel.places[at]);
    }
    return text;
}

void drawMap(const EnsemblePanel& panel) {
    const ShownPlot plot = showPlot("ensemble.image", panel.figure, plotSize(*panel.depths));
    std::string under = " ";
    if (plot.hoveredAt) {
        const RegularGrid& grid = panel.depths->grid;
        const glm::dvec2 cells =
            (*plot.hoveredAt / kKmOfM - glm::dvec2(grid.originM)) / glm::dvec2(grid.spacingM);
        const glm::ivec2 most = glm::ivec2(grid.size) - 1;
        under = valueText(panel, glm::clamp(glm::ivec2(glm::floor(cells)), glm::ivec2(0), most));
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
        } else if ((ending == ".png" || ending == ".svg") && context.services.savePlots) {
            context.services.savePlots(file.string(), {panel.figure}, {});
        } else {
            throw Error({.where = panel.file,
                         .what = "has no ending of a map",
                         .expected = ".nc, .csv, .png or .svg"});
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
    tooltip(
        "NetCDF (.nc) and a table (.csv) hold all three maps, a plot (.png, .svg) the one shown.");
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
    drawMap(panel);
    for (const std::string& member : depths.without) {
        ImGui::TextDisabled("%s has no such time", member.c_str());
    }
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + plotSize(depths).x);
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
            redraw(panel);
            drawState(panel);
            if (panel.depths) drawDepths(context, panel);
        }
    }
    ImGui::End();
    if (!shown) stopReading(panel);
}

}  // namespace neph::ui
