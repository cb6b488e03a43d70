// thumbnail.h: where the thumbnail of a preset is cached.
//
// In the user's cache folder, named by a hash of the preset file and the program version, so that
// an edited preset or a new version gets a new one. `nephoscope thumbnails` makes them.
#pragma once
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>

#include "core/preset/preset.h"

namespace neph {

inline constexpr glm::ivec2 kThumbnailPx{192, 108};

/// The file, whether or not it exists; empty if the preset cannot be read or there is no cache
/// folder.
std::optional<std::filesystem::path> thumbnailFile(const PresetEntry& preset);

}  // namespace neph
