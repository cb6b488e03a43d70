// parameter_format.cpp: JSON of values, each by the kind of its row.
#include "core/look/parameter_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/strict_json.h"

namespace neph {
namespace {

/// Keeps the order of keys. Numbers are kept as float, so that a float written in its shortest form
/// reads back bit for bit.
using Json = nlohmann::basic_json<nlohmann::ordered_map, std::vector, std::string, bool,
                                  std::int64_t, std::uint64_t, float>;

Json toJson(const Parameter& row, const ParameterValue& value) {
    switch (row.kind) {
        case ParameterKind::toggle:
            return std::get<bool>(value);
        case ParameterKind::integer:
            return std::get<int>(value);
        case ParameterKind::choice:
            return formatValue(row, value);
        case ParameterKind::colour: {
            const auto& colour = std::get<glm::vec3>(value);
            return Json::array({colour.r, colour.g, colour.b});
        }
        case ParameterKind::number:
            break;
    }
    return std::get<float>(value);
}

std::optional<glm::vec3> toColour(const Json& value) {
    if (!value.is_array() || value.size() != 3) return {};
    glm::vec3 colour{0.0f};
    for (int i = 0; i < 3; ++i) {
        const Json& item = value[static_cast<std::size_t>(i)];
        if (!item.is_number()) return {};
        colour[i] = item.get<float>();
    }
    return colour;
}

std::optional<int> toChoice(const Parameter& row, const Json& value) {
    if (!value.is_string()) return {};
    const auto found =
        std::ranges::find(row.choices, value.get_ref<const std::string&>(), &Choice::id);
    if (found == row.choices.end()) return {};
    return static_cast<int>(found - row.choices.begin());
}

std::optional<int> toInteger(const Json& value) {
    if (!value.is_number()) return {};
    const auto number = value.get<double>();
    if (std::abs(number) > 1e9 || number != std::floor(number)) return {};
    return static_cast<int>(number);
}

std::optional<ParameterValue> toValue(const Parameter& row, const Json& value) {
    switch (row.kind) {
        case ParameterKind::toggle:
            if (value.is_boolean()) return value.get<bool>();
            return {};
        case ParameterKind::integer:
            return toInteger(value);
        case ParameterKind::choice:
            return toChoice(row, value);
        case ParameterKind::colour:
            return toColour(value);
        case ParameterKind::number:
            break;
    }
    if (!value.is_number()) return {};
    return value.get<float>();
}

}  // namespace

std::string formatParameters(std::span<const Parameter> rows, const ParameterSet& values) {
    Json object = Json::object();
    for (const Parameter& row : rows) object[row.id] = toJson(row, valueOf(values, row));
    return object.dump();
}

ParsedParameters parseParameters(std::string_view json, std::span<const Parameter> rows,
                                 std::string_view where, ParameterSet& values,
                                 std::vector<std::string>& warnings) {
    const Json object = parseStrictJson<Json>(json, where);
    std::vector<std::string_view> known;
    for (const Parameter& row : rows) known.push_back(row.id);
    ParsedParameters parsed;
    for (const auto& [key, value] : object.items()) {
        const Parameter* replaced = replacedInCells(key);
        const auto row =
            std::ranges::find(rows, replaced == nullptr ? key : replaced->id, &Parameter::id);
        if (row == rows.end()) {
            warnings.push_back(unknownJsonKey(where, key, known));
            continue;
        }
        auto read = toValue(*row, value);
        if (!read) {
            throw Error({std::string(where),
                         fmt::format("parameter {} cannot take this value", key), excerpt(value),
                         rangeText(*row), ""});
        }
        if (replaced != nullptr) {
            if (object.contains(row->id)) continue;  // the file has both: the newer one counts
            read = asLookCells(std::get<float>(*read));
            parsed.inMetres |= noiseScaleField(*row);
        }
        setValue(values, *row, *read, where);
        parsed.named.push_back(&*row);
    }
    return parsed;
}

}  // namespace neph
