// format.cpp: numbers and tooltips from the rows of the look table.
#include "app/ui/format.h"

#include <fmt/format.h>

namespace neph::ui {
namespace {

bool hasUnit(const Parameter& row) {
    return !row.displayUnit.empty() && row.displayUnit != "1";
}

std::string shown(const Parameter& row, double value) {
    return fmt::format("{:.4g}{}{}", value * row.displayScale, hasUnit(row) ? " " : "",
                       hasUnit(row) ? row.displayUnit : "");
}

std::string defaultText(const Parameter& row) {
    const ParameterValue value = defaultOf(row);
    if (row.kind == ParameterKind::number) {
        return shown(row, static_cast<double>(std::get<float>(value)));
    }
    if (row.kind == ParameterKind::choice) {
        return std::string(row.choiceLabels[static_cast<std::size_t>(std::get<int>(value))]);
    }
    return formatValue(row, value);
}

}  // namespace

std::string sliderFormat(const Parameter& row) {
    if (row.kind == ParameterKind::integer) return "%d";
    return hasUnit(row) ? "%.4g " + row.displayUnit : "%.4g";
}

std::string tooltipOf(const Parameter& row) {
    std::string text = row.help + "\n";
    if (row.kind == ParameterKind::number || row.kind == ParameterKind::integer) {
        text += fmt::format("\n{} to {}", shown(row, row.range.lo), shown(row, row.range.hi));
    }
    return text + fmt::format("\nDefault: {}\n{}", defaultText(row), row.id);
}

}  // namespace neph::ui
