// memory_setting.h: how much memory volumes may use: what this machine has free, and what the user
// has set.
//
// Sizes are in bytes; on screen and on the command line in KiB, MiB and GiB, or as a percentage of
// the free memory.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/volume/read_plan.h"

namespace neph {

/// Memory available without swapping: MemAvailable, or what a control group leaves if that is less.
/// The largest number if neither is known.
std::uint64_t freeMachineBytes();

/// Memory that this program occupies now; 0 if unknown.
std::uint64_t residentBytes();

/// Memory that a control group of version 2 or 1 leaves: its limit minus what is used and cannot be
/// reclaimed. The largest number if `folder` has no limit.
std::uint64_t controlGroupFreeBytes(const std::filesystem::path& folder);

/// Parses "2GiB", "512 MiB", "800M", a number of bytes, or "50%" of `freeBytes`; empty for empty
/// text, which leaves the choice to the program. Throws Error for anything else and for less than 1
/// MiB.
std::optional<std::uint64_t> parseMemory(std::string_view text, std::uint64_t freeBytes);

/// For example "512 MiB", "3.1 GiB".
std::string memoryText(std::uint64_t bytes);

/// Memory budget of volumes on this machine: as `setting` says, else a quarter of the free memory,
/// so that there is room for the volumes held, the one being read, and what a CPU renderer makes of
/// it. Throws Error for a setting that cannot be parsed.
MemoryBudget memoryBudget(std::string_view setting, std::uint64_t gpuBytes);

}  // namespace neph
