// format.cpp: facts of tooltips, and values from the clipboard.
#include "app/ui/widgets/format.h"

#include <fmt/format.h>

#include <algorithm>

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
    const ParameterValue ofPreset = valueOf(preset, row);
    if (ofPreset != defaultOf(row)) text += " · preset " + screenText(row, ofPreset);
    return text;
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
    if (row.displayScale == 1.0) return parseValue(row, text, "The clipboard");
    // On screen the number is another: read it without bounds, which setValue looks after.
    Parameter onScreen = row;
    onScreen.range = {row.range.lo * row.displayScale, row.range.hi * row.displayScale};
    onScreen.unit = row.displayUnit;
    const ParameterValue shown = parseValue(onScreen, text, "The clipboard");
    const double si = static_cast<double>(std::get<float>(shown)) / row.displayScale;
    return static_cast<float>(std::clamp(si, row.range.lo, row.range.hi));
}

}  // namespace neph::ui
