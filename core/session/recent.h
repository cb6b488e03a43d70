// recent.h: recently opened data and sessions.
//
// An entry has the absolute names of what was opened together, one per line; before the runs of an
// ensemble is the line "members:".
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace neph {

inline constexpr std::size_t kMaxRecent = 12;

/// The entry for what was named, as the runs of an ensemble if `members`; empty for a bundled
/// sample and if there is nothing to remember.
std::string recentEntry(std::span<const std::string> named, bool members = false);
/// Whether the names of an entry are the runs of an ensemble.
bool namesRuns(std::string_view entry);

std::vector<std::string> namesIn(std::string_view entry);

/// Moves an entry to the front and drops the oldest beyond kMaxRecent.
void addRecent(std::vector<std::string>& recent, const std::string& entry);

/// Label in a list, "wrfout_d01 and 3 more", and the folder, "/data/run".
struct RecentLabel {
    std::string name, folder;
};
RecentLabel labelOf(std::string_view entry);

/// Whether everything in the entry still exists.
bool isThere(std::string_view entry);

}  // namespace neph
