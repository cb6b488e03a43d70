// json_object.h: checked access to an object of a scene file. Unknown keys, values of the wrong
// type and values outside their range are errors.
#pragma once
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/names.h"
#include "core/base/strict_json.h"

namespace neph::validate {

using Json = nlohmann::ordered_json;

/// Both ends are allowed values.
struct Range {
    double low = 0.0, high = 0.0;
};

/// An object and its place in the file, for messages. `known` are all keys that it may have.
/// Getters with a fallback return it if the key is absent. All functions throw Error.
struct Object {
    const Json& json;
    std::string where;

    Object(const Json& value, std::string where_, std::initializer_list<std::string_view> known)
        : json(value), where(std::move(where_)) {
        if (!json.is_object()) {
            throw Error({where, "is not an object", excerpt(json), "an object in braces", ""});
        }
        const std::vector<std::string_view> names(known);
        for (const auto& [key, unused] : json.items()) {
            if (std::ranges::find(names, key) != names.end()) continue;
            const std::string_view near = nearestName(key, names);
            throw Error({where, fmt::format("key \"{}\" is not known", key), "",
                         fmt::format("one of {}", fmt::join(names, ", ")),
                         near.empty() ? "" : fmt::format("did you mean \"{}\"?", near)});
        }
    }

    const Json* find(std::string_view key) const {
        const auto found = json.find(std::string(key));
        return found == json.end() ? nullptr : &*found;
    }
    bool has(std::string_view key) const { return find(key) != nullptr; }
    const Json& require(std::string_view key, std::string_view expected) const {
        if (const Json* value = find(key)) return *value;
        throw Error({where, fmt::format("\"{}\" is missing", key), "", std::string(expected), ""});
    }
    double number(std::string_view key, Range range) const {
        const std::string expected = fmt::format("a number from {} to {}", range.low, range.high);
        const Json& value = require(key, expected);
        const double number =
            value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
        if (!(number >= range.low && number <= range.high)) {
            refuseJson(where, key, excerpt(value), expected);
        }
        return number;
    }
    double number(std::string_view key, Range range, double fallback) const {
        return has(key) ? number(key, range) : fallback;
    }
    int integer(std::string_view key, int low, int high, int fallback) const {
        const double value = number(key, {static_cast<double>(low), static_cast<double>(high)},
                                    static_cast<double>(fallback));
        if (value != std::floor(value)) {
            refuseJson(where, key, fmt::format("{}", value), "a whole number");
        }
        return static_cast<int>(value);
    }
    bool flag(std::string_view key, bool fallback) const {
        const Json* value = find(key);
        if (value == nullptr) return fallback;
        if (!value->is_boolean()) refuseJson(where, key, excerpt(*value), "true or false");
        return value->get<bool>();
    }
    /// Empty if there is no such key.
    std::string text(std::string_view key) const { return jsonText(json, key, where); }
    std::string requiredText(std::string_view key) const {
        require(key, "text in quotes");
        return text(key);
    }
    /// One of `words`; the first if there is no such key.
    std::string word(std::string_view key, std::span<const std::string_view> words) const {
        const std::string found = text(key);
        if (!has(key)) return std::string(words.front());
        if (std::ranges::find(words, found) != words.end()) return found;
        const std::string_view near = nearestName(found, words);
        throw Error({where, fmt::format("\"{}\" cannot take this value", key), found,
                     fmt::format("one of {}", fmt::join(words, ", ")),
                     near.empty() ? "" : fmt::format("did you mean \"{}\"?", near)});
    }
    /// Empty if there is no such key.
    const Json& list(std::string_view key, std::size_t most) const {
        static const Json kNone = Json::array();
        const Json* value = find(key);
        if (value == nullptr) return kNone;
        if (value->is_array() && value->size() <= most) return *value;
        refuseJson(where, key,
                   value->is_array() ? fmt::format("{} items", value->size()) : excerpt(*value),
                   fmt::format("a list in brackets with at most {} items", most));
    }
    /// Place of item `index` of a list, for messages.
    std::string below(std::string_view key, std::size_t index) const {
        return fmt::format("{}: {}[{}]", where, key, index);
    }
};

}  // namespace neph::validate
