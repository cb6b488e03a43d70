// droplet_cache.h: droplets that were computed before, as files.
//
// A file is a header and the numbers in this machine's byte order, with a checksum. Whatever is odd
// about a file (length, version, radius, a flipped bit), it counts as absent.
#pragma once
#include <filesystem>
#include <optional>

#include "core/optics/droplets.h"

namespace neph {

/// Raised with every change of droplets.cpp or mie.cpp that changes numbers; part of the file name.
inline constexpr unsigned kDropletCacheVersion = 1;

/// A file of userCacheDir() for the radius; empty when there is no home.
std::filesystem::path dropletCacheFile(float effectiveRadiusM);

/// None when the file is absent or not what was written for exactly this radius.
std::optional<DropletOptics> readDropletCache(const std::filesystem::path& path,
                                              float effectiveRadiusM);

/// Makes the folder, writes aside and renames. Returns false where that cannot be done.
bool writeDropletCache(const std::filesystem::path& path, const DropletOptics& optics);

}  // namespace neph
