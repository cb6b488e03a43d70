// strict_json.cpp: the parts that do not depend on a JSON library.
#include "core/base/strict_json.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include "core/base/names.h"

namespace neph {

std::string readJsonText(const std::filesystem::path& file, std::string_view what,
                         std::size_t maxBytes) {
    std::error_code error;
    if (std::filesystem::is_directory(file, error)) {
        throw Error({file.string(), "cannot be read", "a folder", "a JSON file", ""});
    }
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw Error({file.string(), "cannot be read", std::strerror(errno), "", ""});
    // One byte more than allowed shows that a file is too large without reading it all.
    std::string text(maxBytes + 1, '\0');
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(stream.gcount()));
    if (text.size() > maxBytes) {
        throw Error({file.string(), fmt::format("is too large for {}", what),
                     fmt::format("more than {} MiB", maxBytes >> 20U), "a JSON file", ""});
    }
    return text;
}

std::string unknownJsonKey(std::string_view where, std::string_view key,
                           std::span<const std::string_view> known) {
    const std::string_view near = nearestName(key, known);
    std::string text = fmt::format("{}: key \"{}\" is not known and was left out", where, key);
    if (!near.empty()) text += fmt::format("; did you mean \"{}\"?", near);
    return text;
}

// 0.1f converted to double would be written as 0.10000000149011612.
double asWritten(float value) {
    return std::strtod(fmt::format("{}", value).c_str(), nullptr);
}

}  // namespace neph
