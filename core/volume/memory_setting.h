// memory_setting.h: how much memory volumes may take: what this machine has free, and what the user
// typed.
//
// Sizes are bytes; on screen and on the command line KiB, MiB and GiB, or a share of what is free.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/volume/read_plan.h"

namespace neph {

/// Memory that can be had now without swapping: MemAvailable, or what a control group leaves where
/// that is less. Everything where neither is known.
std::uint64_t freeMachineBytes();

/// Memory that this program occupies now; 0 where that is not known.
std::uint64_t residentBytes();

/// What a control group of version 2 or 1 leaves: its limit less what is used and cannot be
/// reclaimed. Everything where `folder` names no limit.
std::uint64_t controlGroupFreeBytes(const std::filesystem::path& folder);

/// "2GiB", "512 MiB", "800M", a number of bytes, or "50%" of `freeBytes`; none for empty text,
/// which leaves the choice to the program. Throws Error for anything else and for less than 1 MiB.
std::optional<std::uint64_t> parseMemory(std::string_view text, std::uint64_t freeBytes);

/// For example "512 MiB", "3.1 GiB".
std::string memoryText(std::uint64_t bytes);

/// Bounds of volumes on this machine: as `setting` says, else a quarter of what is free, so that
/// the volumes held, the one that is being made and what a renderer on the CPU makes of it have
/// room. Throws Error for a setting that cannot be read.
MemoryBudget memoryBudget(std::string_view setting, std::uint64_t gpuBytes);

}  // namespace neph
