// droplet_cache.h: files of droplet optics that were computed before.
//
// A file is a header and numbers in the byte order of this machine, with a checksum. A file with
// any fault (length, version, radius, a flipped bit) counts as absent.
#pragma once
#include <filesystem>
#include <optional>

#include "core/optics/droplets.h"

namespace neph {

/// Increase it with every change of droplets.cpp or mie.cpp that changes numbers; part of the file
/// name.
inline constexpr unsigned kDropletCacheVersion = 1;

/// File in userCacheDir() for the radius; empty without a home directory.
std::filesystem::path dropletCacheFile(float effectiveRadiusM);

/// Empty if the file is absent or was not written for exactly this radius.
std::optional<DropletOptics> readDropletCache(const std::filesystem::path& path,
                                              float effectiveRadiusM);

/// Creates the folder and replaces the file. Returns false if that fails.
bool writeDropletCache(const std::filesystem::path& path, const DropletOptics& optics);

}  // namespace neph
