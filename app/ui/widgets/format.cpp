// format.cpp: facts of tooltips, and values from the clipboard.
#include "app/ui/widgets/format.h"

#include <fmt/format.h>

#include "app/ui/widgets/words.h"
#include "core/base/error.h"

namespace neph::ui {
namespace {

/// A bound of the range as a value.
ParameterValue bound(const Parameter& row, double value) {
    if (row.kind == ParameterKind::integer) return static_cast<int>(value);
    return static_cast<float>(value);
}

}  // namespace

std::string factsOf(const Parameter& row, const Look& preset) {
    std::string text;
    if (row.kind == ParameterKind::number || row.kind == ParameterKind::integer) {
        text = fmt::format("{} to {} · ", screenText(row, bound(row, row.range.lo)),
                           screenText(row, bound(row, row.range.hi)));
    }
    text += "default " + screenText(row, defaultOf(row));
    const ParameterValue ofPreset = startingValue(row, preset);
    if (ofPreset != defaultOf(row)) text += " · preset " + screenText(row, ofPreset);
    return text;
}

ParameterValue startingValue(const Parameter& row, const Look& preset) {
    return row.part == ParameterPart::sampling ? defaultOf(row) : valueOf(preset, row);
}

ParameterValue pastedValue(const Parameter& row, std::string_view text) {
    text = trimmed(text);
    const std::size_t equals = text.find('=');
    if (equals != std::string_view::npos) {
        return parseValue(row, trimmed(text.substr(equals + 1)), "The clipboard");
    }
    const std::string_view unit = trimmed(row.displayUnit);
    if (!unit.empty() && text.ends_with(unit)) {
        text = trimmed(text.substr(0, text.size() - unit.size()));
    }
    const bool number = row.kind == ParameterKind::number || row.kind == ParameterKind::integer;
    return parseScreenValue(row, number ? withDecimalPoint(text) : std::string(text),
                            "The clipboard");
}

}  // namespace neph::ui
