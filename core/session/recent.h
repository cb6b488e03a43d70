// recent.h: data and sessions that were opened lately.
//
// An entry has the absolute names of what was opened together, one a line.
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace neph {

inline constexpr std::size_t kMaxRecent = 12;

/// The entry for what was named; empty for a bundled sample and where there is nothing to remember.
std::string recentEntry(std::span<const std::string> named);

std::vector<std::string> namesIn(std::string_view entry);

/// Puts an entry before the others, once, and forgets the oldest beyond kMaxRecent.
void addRecent(std::vector<std::string>& recent, const std::string& entry);

/// Short text for a list: "wrfout_d01 and 3 more", and where it lies: "/data/run".
struct RecentLabel {
    std::string name, folder;
};
RecentLabel labelOf(std::string_view entry);

/// Whether all of it is still there.
bool isThere(std::string_view entry);

}  // namespace neph
