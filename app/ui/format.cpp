// format.cpp: formats and tooltips.
#include "app/ui/format.h"

#include <fmt/format.h>

namespace neph::ui {
namespace {

/// A bound of the range as a value.
ParameterValue bound(const Parameter& row, double value) {
    if (row.kind == ParameterKind::integer) return static_cast<int>(value);
    return static_cast<float>(value);
}

}  // namespace

std::string sliderFormat(const Parameter& row) {
    if (row.kind == ParameterKind::integer) return "%d";
    return "%.4g" + unitSuffix(row);
}

std::string tooltipOf(const Parameter& row) {
    std::string text = row.help + "\n";
    if (row.kind == ParameterKind::number || row.kind == ParameterKind::integer) {
        text += fmt::format("\n{} to {}", screenText(row, bound(row, row.range.lo)),
                            screenText(row, bound(row, row.range.hi)));
    }
    return text + fmt::format("\nDefault {}\n{}", screenText(row, defaultOf(row)), row.id);
}

}  // namespace neph::ui
