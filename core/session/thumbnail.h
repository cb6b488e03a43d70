// thumbnail.h: where the small picture of a preset is kept.
//
// In the user's cache folder, named by what the preset's file holds and by the program's version,
// so that a preset that was edited or a program that draws otherwise gets a new one.
// `nephoscope thumbnails` makes them.
#pragma once
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>

#include "core/preset/preset.h"

namespace neph {

inline constexpr glm::ivec2 kThumbnailPx{192, 108};

/// Whether or not there is one yet; none where the preset cannot be read or there is no cache
/// folder.
std::optional<std::filesystem::path> thumbnailFile(const PresetEntry& preset);

}  // namespace neph
