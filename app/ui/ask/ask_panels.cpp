// ask_panels.cpp: asks what the panels show, and draws the answers.
#include "app/ui/ask/ask_panels.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/ui/ask/ask_window.h"
#include "app/ui/ask/pointing.h"
#include "app/ui/widgets/input.h"
#include "app/ui/widgets/places.h"
#include "app/ui/widgets/plot_canvas.h"
#include "app/ui/widgets/theme.h"
#include "core/analysis/place.h"
#include "core/base/error.h"

namespace neph::ui {
namespace {

constexpr double kKmPerMetre = 1e-3;
constexpr std::array kParcels{"Surface", "Mixed layer", "Most unstable"};
constexpr std::array kSeriesNames{"Contents", "Updraft", "Heights", "Masses", "Cover"};

glm::dvec2 placeOf(AskState& ask, const DatasetInfo& info) {
    const glm::dvec2 extent = info.extentM();
    if (!ask.placed) ask.placeM = 0.5 * extent;
    return glm::clamp(ask.placeM, glm::dvec2(0.0), extent);
}

void askColumn(AskState& ask, const AskedTime& when) {
    const glm::dvec2 at = placeOf(ask, when.data->info());
    const ColumnQuestion question{when, columnAt(when.data->info(), at)};
    ask.column.ask(question, [&] {
        return [handle = handleOf(*when.data), time = when.time, at](const Progress&) {
            return readColumn(*handle, time, at);
        };
    });
}

/// Kilometres from the south-west corner, typed or dragged.
bool dragKm(const char* id, glm::dvec2& positionM, glm::dvec2 extentM) {
    glm::vec2 km(positionM * kKmPerMetre);
    ImGui::SetNextItemWidth(9.0f * ImGui::GetFontSize());
    const bool changed = ImGui::DragFloat2(id, &km.x, 0.1f, 0.0f, 0.0f, "%.1f km");
    place(id);
    if (changed) {
        positionM = glm::clamp(glm::dvec2(km) / kKmPerMetre, glm::dvec2(0.0), extentM);
    }
    return changed;
}

void drawColumnHead(AskState& ask, const DatasetInfo& info) {
    glm::dvec2 at = placeOf(ask, info);
    if (dragKm("x, y##ask.place", at, info.extentM())) {
        ask.placeM = at;
        ask.placed = true;
    }
    ImGui::SameLine();
    ImGui::SetNextItemWidth(9.0f * ImGui::GetFontSize());
    int parcel = static_cast<int>(ask.parcel);
    if (ImGui::Combo("parcel", &parcel, kParcels.data(), static_cast<int>(kParcels.size()))) {
        ask.parcel = static_cast<ParcelSource>(parcel);
    }
    place("ask.parcel");
    ImGui::SameLine();
    ImGui::TextDisabled("a click on the image moves it");
}

void drawColumnTabs(const AskState& ask, const AskedTime& when) {
    const ColumnReport& report = *ask.column.value();
    if (!ImGui::BeginTabBar("##column")) return;
    const ImVec2 size = plotRoom();
    if (report.sounding && ImGui::BeginTabItem("Skew-T")) {
        showPlot("ask.skew_t", skewTFigure(report, ask.parcel, "", timeOf(when)), size);
        ImGui::EndTabItem();
    }
    if (report.wind && ImGui::BeginTabItem("Hodograph")) {
        showPlot("ask.hodograph", hodographFigure(report), size);
        ImGui::EndTabItem();
    }
    if (ImGui::BeginTabItem("Hydrometeors")) {
        showPlot("ask.profile", profileFigure(report, timeOf(when)), size);
        ImGui::EndTabItem();
    }
    ImGui::EndTabBar();
}

std::vector<plot::Figure> columnFigures(const AskState& ask, const AskedTime& when) {
    const ColumnReport& report = *ask.column.value();
    std::vector<plot::Figure> figures;
    if (report.sounding) figures.push_back(skewTFigure(report, ask.parcel, "", timeOf(when)));
    if (report.wind) figures.push_back(hodographFigure(report));
    figures.push_back(profileFigure(report, timeOf(when)));
    return figures;
}

bool quantityCombo(const char* label, Quantity& quantity, const DatasetInfo& there) {
    bool changed = false;
    ImGui::SetNextItemWidth(12.0f * ImGui::GetFontSize());
    if (ImGui::BeginCombo(label, std::string(info(quantity).label).c_str())) {
        for (const QuantityInfo& row : kQuantities) {
            const std::string lack = lackOf(row.quantity, there);
            ImGui::BeginDisabled(!lack.empty());
            if (ImGui::Selectable(std::string(row.label).c_str(), row.quantity == quantity)) {
                quantity = row.quantity;
                changed = true;
            }
            ImGui::EndDisabled();
            if (!lack.empty()) tooltip(lack);
        }
        ImGui::EndCombo();
    }
    place(label);
    return changed;
}

/// From west to east through the place, until a line is drawn.
void placeLine(AskState& ask, const DatasetInfo& info) {
    SectionCut& section = ask.section;
    const glm::dvec2 extent = info.extentM();
    if (!ask.lineGiven) {
        const double y = placeOf(ask, info).y;
        section.fromM = {0.0, y};
        section.toM = {extent.x, y};
    }
    section.fromM = glm::clamp(section.fromM, glm::dvec2(0.0), extent);
    section.toM = glm::clamp(section.toM, glm::dvec2(0.0), extent);
}

void drawSectionPlace(AskState& ask, const DatasetInfo& info) {
    SectionCut& section = ask.section;
    int kind = section.vertical ? 0 : 1;
    ImGui::RadioButton("vertical", &kind, 0);
    ImGui::SameLine();
    ImGui::RadioButton("at a height", &kind, 1);
    section.vertical = kind == 0;
    ImGui::SameLine();
    if (!section.vertical) {
        auto km = static_cast<float>(section.heightM * kKmPerMetre);
        ImGui::SetNextItemWidth(10.0f * ImGui::GetFontSize());
        if (ImGui::SliderFloat("##ask.height", &km, 0.0f, 20.0f, "%.2f km")) {
            section.heightM = static_cast<double>(km) / kKmPerMetre;
        }
        place("ask.height");
        return;
    }
    if (dragKm("from##ask.from", section.fromM, info.extentM())) ask.lineGiven = true;
    ImGui::SameLine();
    if (dragKm("to##ask.to", section.toM, info.extentM())) ask.lineGiven = true;
    ImGui::SameLine();
    if (ImGui::Button(ask.drawing ? "Drag over the image" : "Draw")) ask.drawing = !ask.drawing;
    place("ask.draw");
}

void drawSectionHead(AskState& ask, const DatasetInfo& there) {
    SectionCut& section = ask.section;
    drawSectionPlace(ask, there);
    quantityCombo("in colours", section.shown, there);
    ImGui::SameLine();
    bool contours = !section.contours.empty();
    if (ImGui::Checkbox("contours of", &contours)) {
        section.contours.assign(contours ? 1 : 0, Quantity::temperature);
    }
    if (section.contours.empty()) return;
    ImGui::SameLine();
    quantityCombo("##contours", section.contours.front(), there);
}

plot::Figure figureOf(const SectionQuestion& asked, const CrossSection& section) {
    std::string subtitle = timeOf(asked.when);
    if (!section.vertical) {
        subtitle += fmt::format(", {:g} m above sea level", section.heightM);
    }
    const QuantityInfo& shown = info(asked.cut.shown);
    return sectionFigure(section, {}, fmt::format("{}, {}", shown.label, shown.unit), subtitle);
}

/// The time of the data that one of a member's own is.
int timeShown(const Session& session, int own) {
    const Ensemble* ensemble = session.ensemble();
    if (ensemble == nullptr) return own;
    const int times = static_cast<int>(session.info()->times.size());
    for (int time = 0; time < times; ++time) {
        if (ensemble->timeIn(session.document.member, time) == own) return time;
    }
    return session.document.time;
}

}  // namespace

void drawColumnPanel(const PanelContext& context, AskState& ask, bool& shown) {
    ask.column.poll();
    const auto when = askedTimeOf(context.session());
    const bool open = beginAsk("Column", shown, {52.0f, 32.0f}, {1.0f, 0.0f}, context);
    if (open) drawNoRun(when);
    if (open && when) {
        drawColumnHead(ask, when->data->info());
        askColumn(ask, *when);
        drawState(context, ask.column);
        if (ask.column.value()) {
            drawColumnTabs(ask, *when);
            saveButtons(context, "column", columnFigures(ask, *when),
                        columnTable(*ask.column.value()));
        }
    }
    ImGui::End();
}

void drawSectionPanel(const PanelContext& context, AskState& ask, bool& shown) {
    ask.cut.poll();
    const auto when = askedTimeOf(context.session());
    const bool open = beginAsk("Section", shown, {56.0f, 26.0f}, {0.0f, 1.0f}, context);
    if (open) drawNoRun(when);
    if (open && when) {
        const DatasetInfo there = when->data->infoAt(when->time);
        placeLine(ask, there);
        drawSectionHead(ask, there);
        const SectionCut& cut = ask.section;
        if (!ask.drawing && (!cut.vertical || glm::distance(cut.fromM, cut.toM) > 1.0)) {
            ask.cut.ask({*when, cut}, [&] {
                return [handle = handleOf(*when->data), time = when->time,
                        cut](const Progress& progress) {
                    return readSection(*handle, time, cut, progress);
                };
            });
        }
        drawState(context, ask.cut);
        if (ask.cut.value() && !ask.cut.busy() && ask.cut.asked()) {
            const plot::Figure figure = figureOf(*ask.cut.asked(), *ask.cut.value());
            showPlot("ask.section_plot", figure, plotRoom());
            saveButtons(context, "section", {figure}, sectionTable(*ask.cut.value()));
        }
    }
    ImGui::End();
}

void drawSeriesPanel(const PanelContext& context, AskState& ask, bool& shown) {
    ask.series.poll();
    const auto when = askedTimeOf(context.session());
    const bool open = beginAsk("Series", shown, {48.0f, 20.0f}, {0.5f, 1.0f}, context);
    if (open) drawNoRun(when);
    if (open && when) {
        ask.series.ask({when->data}, [&] {
            return [handle = handleOf(*when->data)](const Progress& progress) {
                SeriesSoFar series;
                const auto& times = handle->info().times;
                for (std::size_t i = 0; i < times.size(); ++i) {
                    const auto share = static_cast<double>(i) / static_cast<double>(times.size());
                    if (!goOn(progress, share)) throw Cancelled{};
                    series.points.push_back(readSeriesPoint(*handle, static_cast<int>(i)));
                    series.labels.push_back(times[i].label);
                }
                return series;
            };
        });
        int kind = static_cast<int>(ask.kind);
        ImGui::SetNextItemWidth(10.0f * ImGui::GetFontSize());
        ImGui::Combo("##ask.kind", &kind, kSeriesNames.data(),
                     static_cast<int>(kSeriesNames.size()));
        place("ask.kind");
        ask.kind = static_cast<SeriesKind>(kind);
        ImGui::SameLine();
        ImGui::TextDisabled("a click goes to that time");
        drawState(context, ask.series);
        if (const auto& series = ask.series.value(); series && !series->points.empty()) {
            plot::Figure figure = seriesFigure(series->points, ask.kind, "");
            const double nowMin =
                when->data->info().times.at(static_cast<std::size_t>(when->time)).seconds / 60.0;
            plot::Curve now;
            now.ink = plot::Ink::faint;
            now.width = 3.0;
            now.points = {{nowMin, figure.y.from}, {nowMin, figure.y.to}};
            figure.curves.insert(figure.curves.begin(), now);
            const ShownPlot plot = showPlot("ask.series_plot", figure, plotRoom());
            if (plot.clickedAt) {
                const double at = 60.0 * plot.clickedAt->x;
                const auto nearest = std::ranges::min_element(
                    series->points, {},
                    [at](const SeriesPoint& point) { return std::abs(point.seconds - at); });
                context.session().document.time = timeShown(context.session(), nearest->time);
            }
            saveButtons(context, "series", {seriesFigure(series->points, ask.kind, "")},
                        seriesTable(series->points, series->labels));
        }
    }
    ImGui::End();
}

}  // namespace neph::ui
