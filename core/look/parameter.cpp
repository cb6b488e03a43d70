// parameter.cpp: reading and writing parameters by their rows.
#include "core/look/parameter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>

#include "core/base/error.h"
#include "core/base/names.h"
#include "core/base/number_text.h"
#include "core/look/old_metres.h"

namespace neph {
namespace {

[[noreturn]] void refuse(const Parameter& row, std::string found, std::string_view where) {
    throw Error({std::string(where), fmt::format("parameter {} cannot take this value", row.id),
                 std::move(found), rangeText(row), ""});
}

bool inRange(const Parameter& row, double value) {
    // The bounds are decimal and the values float: admit the float nearest to a bound.
    const auto lo = static_cast<double>(static_cast<float>(row.range.lo));
    const auto hi = static_cast<double>(static_cast<float>(row.range.hi));
    return std::isfinite(value) && value >= std::min(lo, row.range.lo) &&
           value <= std::max(hi, row.range.hi);
}

bool fits(const Parameter& row, const ParameterValue& value) {
    switch (row.kind) {
        case ParameterKind::toggle:
            return std::holds_alternative<bool>(value);
        case ParameterKind::integer:
            return std::holds_alternative<int>(value) && inRange(row, std::get<int>(value));
        case ParameterKind::choice:
            return std::holds_alternative<int>(value) && std::get<int>(value) >= 0 &&
                   std::get<int>(value) < static_cast<int>(row.choices.size());
        case ParameterKind::number:
            return std::holds_alternative<float>(value) &&
                   inRange(row, static_cast<double>(std::get<float>(value)));
        case ParameterKind::colour:
            break;
    }
    if (!std::holds_alternative<glm::vec3>(value)) return false;
    const glm::vec3 c = std::get<glm::vec3>(value);
    return inRange(row, static_cast<double>(c.r)) && inRange(row, static_cast<double>(c.g)) &&
           inRange(row, static_cast<double>(c.b));
}

std::string describe(const ParameterValue& value) {
    if (const auto* b = std::get_if<bool>(&value)) return *b ? "true" : "false";
    if (const auto* i = std::get_if<int>(&value)) return fmt::format("{}", *i);
    if (const auto* f = std::get_if<float>(&value)) return fmt::format("{}", *f);
    const auto& c = std::get<glm::vec3>(value);
    return fmt::format("{},{},{}", c.r, c.g, c.b);
}

template <typename T>
std::optional<T> parseWhole(std::string_view text) {
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return {};
    return value;
}

std::optional<glm::vec3> parseColour(std::string_view text) {
    glm::vec3 colour{0.0f};
    for (int i = 0; i < 3; ++i) {
        const std::size_t comma = text.find(',');
        if ((i < 2) == (comma == std::string_view::npos)) return {};
        const auto channel = parseWhole<float>(text.substr(0, comma));
        if (!channel) return {};
        colour[i] = *channel;
        text.remove_prefix(i < 2 ? comma + 1 : text.size());
    }
    return colour;
}

std::optional<ParameterValue> tryParse(const Parameter& row, std::string_view text) {
    switch (row.kind) {
        case ParameterKind::toggle:
            if (text == "true" || text == "on" || text == "1") return true;
            if (text == "false" || text == "off" || text == "0") return false;
            return {};
        case ParameterKind::choice: {
            const auto found = std::ranges::find(row.choices, text, &Choice::id);
            if (found == row.choices.end()) return {};
            return static_cast<int>(found - row.choices.begin());
        }
        case ParameterKind::integer:
            return parseWhole<int>(text);
        case ParameterKind::number:
            return parseWhole<float>(text);
        case ParameterKind::colour:
            return parseColour(text);
    }
    return {};
}

std::string idsOf(const std::vector<Choice>& choices) {
    std::string list;
    for (const Choice& choice : choices) {
        list += list.empty() ? "" : ", ";
        list += choice.id;
    }
    return list;
}

const Choice& chosen(const Parameter& row, const ParameterValue& value) {
    return row.choices[static_cast<std::size_t>(std::get<int>(value))];
}

template <typename Owner>
const ParameterAccess<Owner>& accessIn(const Parameter& row) {
    assert(std::holds_alternative<ParameterAccess<Owner>>(row.access));
    return std::get<ParameterAccess<Owner>>(row.access);
}

template <typename Values>
std::optional<Stage> firstOf(std::span<const Parameter> rows, const Values& a, const Values& b) {
    std::optional<Stage> first;
    for (const Parameter& row : rows) {
        if (first && row.invalidates >= *first) continue;
        if (valueOf(a, row) != valueOf(b, row)) first = row.invalidates;
    }
    return first;
}

}  // namespace

std::string rangeText(const Parameter& row) {
    switch (row.kind) {
        case ParameterKind::toggle:
            return "true or false";
        case ParameterKind::choice:
            return "one of " + idsOf(row.choices);
        case ParameterKind::colour:
            return "three numbers from 0 to 1";
        case ParameterKind::integer:
            return fmt::format("a whole number from {} to {}", row.range.lo, row.range.hi);
        case ParameterKind::number:
            break;
    }
    const bool plain = row.unit.empty() || row.unit == "1";
    return fmt::format("a number from {} to {}{}{}", row.range.lo, row.range.hi, plain ? "" : " ",
                       plain ? "" : row.unit);
}

const Parameter* findParameter(std::string_view id) {
    const auto table = parameterTable();
    const auto found = std::ranges::find_if(table, [&](const Parameter& row) {
        return row.id == id || (!row.formerId.empty() && row.formerId == id);
    });
    return found == table.end() ? nullptr : &*found;
}

std::string nearestParameterId(std::string_view id) {
    std::vector<std::string_view> ids;
    for (const Parameter& row : parameterTable()) ids.push_back(row.id);
    return std::string(nearestName(id, ids));
}

const Parameter& parameter(std::string_view id) {
    if (const Parameter* row = findParameter(id)) return *row;
    if (const Parameter* row = replacedInCells(id)) {
        throw Error({"", fmt::format("there is no parameter {}, in metres, any more", id), "", "",
                     row->id + " has the length in cells of the data: divide the metres by the "
                               "horizontal spacing that `nephoscope info` tells"});
    }
    const std::string near = nearestParameterId(id);
    throw Error(
        {"", fmt::format("there is no parameter {}", id), "", "",
         near.empty() ? "docs/parameters.md lists them all" : "did you mean " + near + "?"});
}

const Parameter& parameterOfOption(std::string_view option) {
    const auto table = parameterTable();
    const auto found =
        std::ranges::find_if(table, [&](const Parameter& row) { return row.alias.name == option; });
    assert(found != table.end());
    return *found;
}

ParameterValue valueOf(const Look& look, const Parameter& row) {
    return accessIn<Look>(row).get(look);
}

ParameterValue valueOf(const ParameterSet& values, const Parameter& row) {
    if (row.part != ParameterPart::sampling) return valueOf(values.look, row);
    return accessIn<Sampling>(row).get(values.sampling);
}

ParameterValue defaultOf(const Parameter& row) {
    static const ParameterSet defaults;
    return valueOf(defaults, row);
}

void setValue(Look& look, const Parameter& row, const ParameterValue& value,
              std::string_view where) {
    if (!fits(row, value)) refuse(row, describe(value), where);
    accessIn<Look>(row).set(look, value);
}

void setValue(ParameterSet& values, const Parameter& row, const ParameterValue& value,
              std::string_view where) {
    if (row.part != ParameterPart::sampling) return setValue(values.look, row, value, where);
    if (!fits(row, value)) refuse(row, describe(value), where);
    accessIn<Sampling>(row).set(values.sampling, value);
}

std::string formatValue(const Parameter& row, const ParameterValue& value) {
    if (row.kind == ParameterKind::choice) return std::string(chosen(row, value).id);
    return describe(value);
}

std::string unitSuffix(const Parameter& row) {
    const bool apart = !row.displayUnit.empty() && row.displayUnit != "°";
    return (apart ? " " : "") + row.displayUnit;
}

std::string screenText(const Parameter& row, const ParameterValue& value) {
    switch (row.kind) {
        case ParameterKind::toggle:
            return std::get<bool>(value) ? "on" : "off";
        case ParameterKind::choice:
            return std::string(chosen(row, value).label);
        case ParameterKind::number:
            return numberText(static_cast<double>(std::get<float>(value)) * row.displayScale) +
                   unitSuffix(row);
        case ParameterKind::integer:
            return describe(value);
        case ParameterKind::colour:
            break;
    }
    const auto& c = std::get<glm::vec3>(value);
    const auto text = [](float x) { return numberText(static_cast<double>(x), 3); };
    return fmt::format("{}, {}, {}", text(c.r), text(c.g), text(c.b));
}

ParameterValue parseValue(const Parameter& row, std::string_view text, std::string_view where) {
    const auto value = tryParse(row, text);
    if (!value || !fits(row, *value)) refuse(row, std::string(text), where);
    return *value;
}

ParameterValue parseScreenValue(const Parameter& row, std::string_view text,
                                std::string_view where) {
    if (row.displayScale == 1.0) return parseValue(row, text, where);
    Parameter onScreen = row;
    onScreen.range = {row.range.lo * row.displayScale, row.range.hi * row.displayScale};
    onScreen.unit = row.displayUnit;
    const ParameterValue shown = parseValue(onScreen, text, where);
    const double si = static_cast<double>(std::get<float>(shown)) / row.displayScale;
    return static_cast<float>(std::clamp(si, row.range.lo, row.range.hi));
}

void applyAssignment(ParameterSet& values, std::string_view assignment) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string_view::npos) {
        throw Error({"", fmt::format("cannot read the assignment '{}'", assignment), "",
                     "id=value, for example cloud.mixing_scale=0.5", ""});
    }
    const Parameter& row = parameter(assignment.substr(0, equals));
    setValue(values, row, parseValue(row, assignment.substr(equals + 1)));
}

std::string formatAssignments(std::span<const Parameter> rows, const ParameterSet& values) {
    std::string text;
    for (const Parameter& row : rows) {
        text += (text.empty() ? "" : " ") + row.id + "=" + formatValue(row, valueOf(values, row));
    }
    return text;
}

bool applies(const Parameter& row, const Look& look) {
    return (row.engines & bitOf(look.engine)) != 0 && (!row.acts || row.acts(look));
}

std::string_view overruledBy(const Parameter& row, const Look& look) {
    const bool overruled = row.overruled.when != nullptr && row.overruled.when(look);
    return overruled ? row.overruled.because : std::string_view();
}

std::optional<Stage> firstDifference(const Look& a, const Look& b) {
    return firstOf(lookTable(), a, b);
}

std::optional<Stage> firstDifference(const ParameterSet& a, const ParameterSet& b) {
    return firstOf(parameterTable(), a, b);
}

}  // namespace neph
