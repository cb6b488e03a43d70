// pins_panel.cpp: the list of pins, with what is there at the time that is shown.
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "app/ui/ask/ask_panels.h"
#include "app/ui/ask/ask_window.h"
#include "app/ui/ask/pointing.h"
#include "app/ui/widgets/places.h"
#include "core/analysis/place.h"

namespace neph::ui {
namespace {

constexpr std::array kShown{Quantity::condensate, Quantity::temperature, Quantity::upwardWind,
                            Quantity::windSpeed, Quantity::reflectivity};

/// Of the cell that a pin lies in; NaN where the data have none.
double valueAt(const ColumnReport& report, Quantity quantity, double heightM) {
    const Profile* profile = report.find(quantity);
    if (profile == nullptr) return std::numeric_limits<double>::quiet_NaN();
    const auto nearest = std::ranges::min_element(
        report.heightsM, {}, [&](double middle) { return std::abs(middle - heightM); });
    return profile->values[static_cast<std::size_t>(nearest - report.heightsM.begin())];
}

void askPins(AskState& ask, const AskedTime& when, const std::vector<Pin>& pins) {
    std::vector<glm::dvec3> positions;
    for (const Pin& pin : pins) positions.push_back(pin.positionM);
    ask.pinned.ask({when, positions}, [&] {
        return
            [handle = handleOf(*when.data), time = when.time, positions](const Progress& progress) {
                std::vector<ColumnReport> reports;
                const glm::dvec2 extent = handle->info().extentM();
                for (const glm::dvec3& position : positions) {
                    const double share =
                        static_cast<double>(reports.size()) / static_cast<double>(positions.size());
                    if (!goOn(progress, share)) throw Cancelled{};
                    const glm::dvec2 at = glm::clamp(glm::dvec2(position), glm::dvec2(0.0), extent);
                    reports.push_back(readColumn(*handle, time, at));
                }
                return reports;
            };
    });
}

plot::Table tableOf(const std::vector<Pin>& pins, const std::vector<ColumnReport>& reports,
                    const AskedTime& when) {
    plot::Table table;
    table.comments.push_back("Time: " + timeOf(when));
    plot::Column label{"label", {}, {}};
    std::array<plot::Column, 5> place{plot::Column{"x [m]", {}, {}},
                                      {"y [m]", {}, {}},
                                      {"height [m]", {}, {}},
                                      {"latitude [degrees_north]", {}, {}},
                                      {"longitude [degrees_east]", {}, {}}};
    for (const Pin& pin : pins) {
        label.texts.push_back(pin.label);
        const auto geo = geoOf(when.data->info(), when.time, glm::dvec2(pin.positionM));
        const double none = std::numeric_limits<double>::quiet_NaN();
        const std::array values{pin.positionM.x, pin.positionM.y, pin.positionM.z,
                                geo ? geo->latitudeDeg : none, geo ? geo->longitudeDeg : none};
        for (std::size_t i = 0; i < values.size(); ++i) place[i].numbers.push_back(values[i]);
    }
    table.columns.push_back(std::move(label));
    for (plot::Column& column : place) table.columns.push_back(std::move(column));
    for (const QuantityInfo& row : kQuantities) {
        plot::Column column{fmt::format("{} [{}]", row.id, row.unit), {}, {}};
        for (std::size_t i = 0; i < pins.size(); ++i) {
            column.numbers.push_back(valueAt(reports[i], row.quantity, pins[i].positionM.z));
        }
        const bool any =
            std::ranges::any_of(column.numbers, [](double value) { return std::isfinite(value); });
        if (any) table.columns.push_back(std::move(column));
    }
    return table;
}

std::string valuesText(const ColumnReport& report, double heightM) {
    std::string text;
    for (const Quantity quantity : kShown) {
        const double value = valueAt(report, quantity, heightM);
        if (!std::isfinite(value)) continue;
        text += fmt::format("{}{:.3g} {}", text.empty() ? "" : ", ", value, info(quantity).unit);
    }
    return text;
}

/// One line: its label, which can be typed, where it is and what is there. False: to be removed.
bool drawPin(Pin& pin, const ColumnReport* report) {
    ImGui::SetNextItemWidth(7.0f * ImGui::GetFontSize());
    ImGui::InputText("##label", &pin.label);
    place("ask.pin_label");
    ImGui::SameLine();
    const bool keep = !ImGui::SmallButton("x");
    place("ask.unpin");
    ImGui::SameLine();
    const glm::dvec3 km = 1e-3 * pin.positionM;
    ImGui::Text("%.1f, %.1f, %.2f km", km.x, km.y, km.z);
    if (report == nullptr) return keep;
    ImGui::SameLine();
    ImGui::TextDisabled("%s", valuesText(*report, pin.positionM.z).c_str());
    return keep;
}

}  // namespace

void drawPinsPanel(const PanelContext& context, AskState& ask, bool& shown) {
    ask.pinned.poll();
    const auto when = askedTimeOf(context.session());
    std::vector<Pin>& pins = context.session().document.pins;
    const bool open = beginAsk("Pins", shown, {50.0f, 14.0f}, {0.5f, 0.0f}, context);
    if (open) drawNoRun(when);
    if (open && pins.empty()) {
        ImGui::TextWrapped("Shift+P pins what the mouse points at.");
    }
    if (open && when && !pins.empty()) {
        askPins(ask, *when, pins);
        const auto& asked = ask.pinned.asked();
        const bool current = ask.pinned.value() && !ask.pinned.busy() && asked &&
                             ask.pinned.value()->size() == pins.size();
        for (std::size_t i = 0; i < pins.size();) {
            ImGui::PushID(static_cast<int>(i));
            const ColumnReport* report = current ? &(*ask.pinned.value())[i] : nullptr;
            const bool keep = drawPin(pins[i], report);
            ImGui::PopID();
            if (!keep) {
                pins.erase(pins.begin() + static_cast<std::ptrdiff_t>(i));
                break;
            }
            ++i;
        }
        drawState(context, ask.pinned);
        if (current && ask.pinned.value()->size() == pins.size() && !pins.empty()) {
            saveButtons(context, "pins", {}, tableOf(pins, *ask.pinned.value(), *when));
        }
    }
    ImGui::End();
}

}  // namespace neph::ui
