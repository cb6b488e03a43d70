// strict_json.h: JSON from untrusted sources: file size, nesting depth and duplicate keys are
// checked, and every fault becomes an Error that names the file.
//
// Templates on the JSON type of the caller, so that this header needs no JSON library.
#pragma once
#include <fmt/format.h>

#include <cstddef>
#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace neph {

inline constexpr int kMaxJsonDepth = 16;  ///< files that the program writes have at most 6

/// The text of a file of at most `maxBytes`; `what` says what it should contain ("a preset").
/// Throws Error.
std::string readJsonText(const std::filesystem::path& file, std::string_view what,
                         std::size_t maxBytes);

/// The warning for an unknown key that is ignored.
std::string unknownJsonKey(std::string_view where, std::string_view key,
                           std::span<const std::string_view> known);

/// The double that JSON writes with the same digits as the float.
double asWritten(float value);

/// Follows the events of the parser: the depth of nesting, and the keys seen in each open object.
template <typename Json>
class JsonWatch {
  public:
    explicit JsonWatch(std::string_view where) : where_(where) {}

    bool operator()(int depth, typename Json::parse_event_t event, Json& value) {
        using Event = typename Json::parse_event_t;
        if (event == Event::object_start || event == Event::array_start) open(depth);
        if (event == Event::object_end || event == Event::array_end) keys_.pop_back();
        if (event == Event::key) addKey(value.template get<std::string>());
        return true;
    }

  private:
    void open(int depth) {
        if (depth >= kMaxJsonDepth) {
            throw Error({where_, "is nested too deeply",
                         fmt::format("more than {} levels", kMaxJsonDepth),
                         "what this program writes", ""});
        }
        keys_.emplace_back();
    }
    void addKey(const std::string& key) {
        if (keys_.back().insert(key).second) return;
        throw Error({where_, fmt::format("key \"{}\" stands twice", key), "", "each key once",
                     "remove one of the two"});
    }

    std::string where_;
    std::vector<std::set<std::string>> keys_;
};

/// Throws Error.
template <typename Json>
Json parseStrictJson(std::string_view text, std::string_view where) {
    try {
        return Json::parse(text.begin(), text.end(), JsonWatch<Json>(where));
    } catch (const typename Json::exception& fault) {
        std::string_view told = fault.what();
        const std::size_t bracket = told.find("] ");
        if (bracket != told.npos) told.remove_prefix(bracket + 2);
        throw Error({std::string(where), "is not valid JSON", std::string(told), "", ""});
    }
}

/// The beginning of a value, for error messages.
template <typename Json>
std::string excerpt(const Json& value) {
    constexpr std::size_t kLength = 60;
    std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
    if (text.size() > kLength) text = text.substr(0, kLength) + " ...";
    return text;
}

/// For a value of the wrong type or out of range. Throws Error.
[[noreturn]] inline void refuseJson(std::string_view where, std::string_view key,
                                    const std::string& found, std::string_view expected) {
    throw Error({std::string(where), fmt::format("\"{}\" cannot take this value", key), found,
                 std::string(expected), ""});
}

/// `value` if it is an object. Throws Error.
template <typename Json>
const Json& jsonObject(const Json& value, std::string_view key, std::string_view where) {
    if (value.is_object()) return value;
    refuseJson(where, key, excerpt(value), "an object in braces");
}

/// Text under `key`, empty if the key is absent. Throws Error.
template <typename Json>
std::string jsonText(const Json& object, std::string_view key, std::string_view where) {
    const auto found = object.find(std::string(key));
    if (found == object.end()) return {};
    if (found->is_string()) return found->template get<std::string>();
    refuseJson(where, key, excerpt(*found), "text in quotes");
}

/// Throws Error unless `document` is an object of this `type` and `version`; `what` says what it
/// should be ("a Nephoscope preset").
template <typename Json>
void checkJsonHeader(const Json& document, std::string_view where, std::string_view what,
                     std::string_view type, int version) {
    if (!document.is_object()) {
        throw Error({std::string(where), fmt::format("is not {}", what), excerpt(document),
                     "an object in braces", ""});
    }
    const auto key = document.find("type");
    if (key == document.end() || *key != type) {
        throw Error({std::string(where), fmt::format("is not {}", what),
                     key == document.end() ? "no \"type\"" : "type " + excerpt(*key),
                     fmt::format("\"type\": \"{}\"", type), ""});
    }
    const auto number = document.find("version");
    if (number == document.end() || *number != version) {
        throw Error({std::string(where), "is of a version that is not known",
                     number == document.end() ? "no \"version\"" : "version " + excerpt(*number),
                     fmt::format("\"version\": {}", version), ""});
    }
}

}  // namespace neph
