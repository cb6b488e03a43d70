// file_kind.cpp: recognises our documents by their "type". A document that is damaged further down
// is still recognised, so that the message is about the damage.
#include "core/session/file_kind.h"

#include <algorithm>
#include <fstream>
#include <string>
#include <string_view>

#include "core/preset/preset_format.h"
#include "core/session/session_file.h"

namespace neph {
namespace {

constexpr std::size_t kHead = 4096;
constexpr std::string_view kSpace = " \t\r\n";

/// The quoted value after the key `"type"` and a colon; empty if there is none.
std::string_view typeIn(std::string_view text) {
    constexpr std::string_view kKey = "\"type\"";
    const auto skip = [&](std::size_t count) {
        text.remove_prefix(std::min(count, text.size()));
        text.remove_prefix(std::min(text.find_first_not_of(kSpace), text.size()));
    };
    skip(0);
    if (!text.starts_with('{')) return {};
    skip(std::min(text.find(kKey), text.size()));
    skip(kKey.size());
    if (!text.starts_with(':')) return {};
    skip(1);
    if (!text.starts_with('"')) return {};
    text.remove_prefix(1);
    return text.substr(0, text.find('"'));
}

}  // namespace

FileKind kindOfFile(const std::filesystem::path& path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return FileKind::data;
    std::string head(kHead, '\0');
    std::ifstream stream(path, std::ios::binary);
    stream.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(stream.gcount()));
    const std::string_view type = typeIn(head);
    if (type == kPresetType) return FileKind::preset;
    return type == kSessionType ? FileKind::session : FileKind::data;
}

}  // namespace neph
