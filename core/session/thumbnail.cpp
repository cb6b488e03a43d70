// thumbnail.cpp: derives a file name from the content of a preset.
#include "core/session/thumbnail.h"

#include <fmt/format.h>

#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>

#include "core/base/hash.h"
#include "core/base/resources.h"

namespace neph {

std::optional<std::filesystem::path> thumbnailFile(const PresetEntry& preset) {
    const auto cache = userCacheDir();
    std::ifstream stream(preset.file, std::ios::binary);
    if (!cache || !stream) return {};
    const std::string content{std::istreambuf_iterator<char>(stream), {}};
    const std::uint64_t key = hashOf(content + std::string(versionText()));
    return *cache / "thumbnails" / fmt::format("{:016x}.png", key);
}

}  // namespace neph
