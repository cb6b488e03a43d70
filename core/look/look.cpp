// look.cpp: reading and writing parameters by their rows.
#include "core/look/look.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>

#include "core/base/error.h"
#include "core/base/names.h"
#include "core/base/number_text.h"
#include "core/grid/grid.h"

namespace neph {
namespace {

template <typename T>
T load(const Look& look, std::size_t offset) {
    T value;
    std::memcpy(&value, reinterpret_cast<const std::byte*>(&look) + offset, sizeof(T));
    return value;
}

template <typename T>
void store(Look& look, std::size_t offset, const T& value) {
    std::memcpy(reinterpret_cast<std::byte*>(&look) + offset, &value, sizeof(T));
}

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
            const auto found = std::find(row.choices.begin(), row.choices.end(), text);
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

}  // namespace

std::string rangeText(const Parameter& row) {
    switch (row.kind) {
        case ParameterKind::toggle:
            return "true or false";
        case ParameterKind::choice:
            return fmt::format("one of {}", fmt::join(row.choices, ", "));
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
    const auto table = lookTable();
    const auto found = std::find_if(table.begin(), table.end(),
                                    [&](const Parameter& row) { return row.id == id; });
    return found == table.end() ? nullptr : &*found;
}

std::string nearestParameterId(std::string_view id) {
    std::vector<std::string_view> ids;
    for (const Parameter& row : lookTable()) ids.push_back(row.id);
    return std::string(nearestName(id, ids));
}

const Parameter& parameter(std::string_view id) {
    if (const Parameter* row = findParameter(id)) return *row;
    const std::string near = nearestParameterId(id);
    throw Error(
        {"", fmt::format("there is no parameter {}", id), "", "",
         near.empty() ? "docs/parameters.md lists them all" : "did you mean " + near + "?"});
}

ParameterValue valueOf(const Look& look, const Parameter& row) {
    switch (row.kind) {
        case ParameterKind::toggle:
            return load<bool>(look, row.offset);
        case ParameterKind::integer:
        case ParameterKind::choice:
            return load<int>(look, row.offset);
        case ParameterKind::number:
            return load<float>(look, row.offset);
        case ParameterKind::colour:
            break;
    }
    return load<glm::vec3>(look, row.offset);
}

ParameterValue defaultOf(const Parameter& row) {
    static const Look defaults;
    return valueOf(defaults, row);
}

void setValue(Look& look, const Parameter& row, const ParameterValue& value,
              std::string_view where) {
    if (!fits(row, value)) refuse(row, describe(value), where);
    std::visit([&](const auto& v) { store(look, row.offset, v); }, value);
}

std::string formatValue(const Parameter& row, const ParameterValue& value) {
    if (row.kind == ParameterKind::choice) {
        return std::string(row.choices[static_cast<std::size_t>(std::get<int>(value))]);
    }
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
            return std::string(row.choiceLabels[static_cast<std::size_t>(std::get<int>(value))]);
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

void applyAssignment(Look& look, std::string_view assignment) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string_view::npos) {
        throw Error({"", fmt::format("cannot read the assignment '{}'", assignment), "",
                     "id=value, for example cloud.mixing_scale=0.5", ""});
    }
    const Parameter& row = parameter(assignment.substr(0, equals));
    setValue(look, row, parseValue(row, assignment.substr(equals + 1)));
}

bool applies(const Parameter& row, const Look& look) {
    if ((row.engines & bitOf(look.engine)) == 0) return false;
    if (row.ofConstantRadius) {
        return look.of(*row.species).radiusSource == RadiusSource::constant;
    }
    if (row.phaseMember == nullptr) return true;
    const auto kind = load<PhaseKind>(look, row.phaseOffset + offsetof(PhaseSpec, kind));
    return phaseReads(kind, row.phaseMember);
}

std::optional<Stage> firstDifference(const Look& a, const Look& b) {
    std::optional<Stage> first;
    for (const Parameter& row : lookTable()) {
        if (first && row.invalidates >= *first) continue;
        if (valueOf(a, row) != valueOf(b, row)) first = row.invalidates;
    }
    return first;
}

glm::dvec3 sunDirWorld(const Look& look) {
    return compassDirWorld(look.sunAzimuthDeg, look.sunElevationDeg);
}

}  // namespace neph
