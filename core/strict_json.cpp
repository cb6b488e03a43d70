// strict_json.cpp: nlohmann-json with the checks that it leaves to its user.
#include "core/strict_json.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <set>

#include "core/error.h"

namespace neph {
namespace {

/// Watches the parser's events: the depth of nesting, and the keys seen in each open object.
class Watch {
  public:
    explicit Watch(std::string_view where) : where_(where) {}

    bool operator()(int depth, Json::parse_event_t event, Json& value) {
        using Event = Json::parse_event_t;
        if (event == Event::object_start || event == Event::array_start) open(depth);
        if (event == Event::object_end || event == Event::array_end) keys_.pop_back();
        if (event == Event::key) addKey(value.get_ref<const std::string&>());
        return true;
    }

  private:
    void open(int depth) {
        if (depth >= kMaxJsonDepth) {
            throw Error({where_, "is nested too deeply",
                         fmt::format("more than {} levels", kMaxJsonDepth), "at most 3 levels",
                         ""});
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

std::string withoutPrefix(std::string_view message) {
    const std::size_t bracket = message.find("] ");
    return std::string(bracket == std::string_view::npos ? message : message.substr(bracket + 2));
}

}  // namespace

Json parseStrictJson(std::string_view text, std::string_view where) {
    try {
        return Json::parse(text.begin(), text.end(), Watch(where));
    } catch (const Json::exception& fault) {
        throw Error({std::string(where), "is not valid JSON", withoutPrefix(fault.what()), "", ""});
    }
}

std::string readSmallFile(const std::filesystem::path& file) {
    std::error_code error;
    if (std::filesystem::is_directory(file, error)) {
        throw Error({file.string(), "cannot be read", "a folder", "a JSON file", ""});
    }
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw Error({file.string(), "cannot be read", std::strerror(errno), "", ""});
    std::string text(kMaxJsonBytes + 1, '\0');
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(stream.gcount()));
    if (text.size() > kMaxJsonBytes) {
        throw Error({file.string(), "is too large for a preset", "more than 1 MiB",
                     "a JSON file of a few KiB", ""});
    }
    return text;
}

std::string excerpt(const Json& value) {
    constexpr std::size_t kLength = 60;
    std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
    if (text.size() > kLength) text = text.substr(0, kLength) + " ...";
    return text;
}

}  // namespace neph
