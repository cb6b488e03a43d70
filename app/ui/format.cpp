// format.cpp: units, formats and tooltips.
#include "app/ui/format.h"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace neph::ui {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kUnits{{
    {"1", ""},
    {"um", "µm"},
    {"deg", "°"},
    {"kg m-3", "kg/m³"},
    {"m2 kg-1", "m²/kg"},
}};

std::string shown(const Parameter& row, double value) {
    const std::string unit = unitOnScreen(row.displayUnit);
    return fmt::format("{:.4g}{}{}", value * row.displayScale, unit.empty() ? "" : " ", unit);
}

std::string defaultText(const Parameter& row) {
    const ParameterValue value = defaultOf(row);
    switch (row.kind) {
        case ParameterKind::number:
            return shown(row, static_cast<double>(std::get<float>(value)));
        case ParameterKind::choice:
            return std::string(row.choiceLabels[static_cast<std::size_t>(std::get<int>(value))]);
        case ParameterKind::toggle:
            return std::get<bool>(value) ? "on" : "off";
        case ParameterKind::integer:
        case ParameterKind::colour:
            break;
    }
    return formatValue(row, value);
}

/// Whether a phase function has the parameter that stands at `suffix`; the order of PhaseKind.
bool phaseHas(PhaseKind kind, std::string_view suffix) {
    switch (kind) {
        case PhaseKind::isotropic:
        case PhaseKind::rayleigh:
            return false;
        case PhaseKind::henyeyGreenstein:
        case PhaseKind::cornetteShanks:
            return suffix == "g";
        case PhaseKind::doubleHenyeyGreenstein:
            return suffix == "g" || suffix == "g2" || suffix == "weight";
        case PhaseKind::draine:
            return suffix == "g" || suffix == "alpha";
        case PhaseKind::waterDroplets:
        case PhaseKind::roughAggregate:
        case PhaseKind::solidColumn:
            return suffix == "radius";
    }
    return true;
}

}  // namespace

std::string unitOnScreen(std::string_view unit) {
    for (const auto& [plain, pretty] : kUnits) {
        if (plain == unit) return std::string(pretty);
    }
    return std::string(unit);
}

std::string sliderFormat(const Parameter& row) {
    if (row.kind == ParameterKind::integer) return "%d";
    const std::string unit = unitOnScreen(row.displayUnit);
    if (unit.empty()) return "%.4g";
    return unit == "°" ? "%.4g°" : "%.4g " + unit;
}

std::string tooltipOf(const Parameter& row) {
    std::string text = row.help + "\n";
    if (row.kind == ParameterKind::number || row.kind == ParameterKind::integer) {
        text += fmt::format("\n{} to {}", shown(row, row.range.lo), shown(row, row.range.hi));
    }
    return text + fmt::format("\nDefault {}\n{}", defaultText(row), row.id);
}

bool applies(const Parameter& row, const Look& look) {
    const std::size_t at = row.id.find("phase_");
    if (at == std::string::npos) return true;
    const Parameter* kind = findParameter(row.id.substr(0, at + 5));
    if (kind == nullptr || kind->choices.data() != kPhaseIds.data()) return true;
    const auto chosen = static_cast<PhaseKind>(std::get<int>(valueOf(look, *kind)));
    return phaseHas(chosen, std::string_view(row.id).substr(at + 6));
}

}  // namespace neph::ui
