// recent.cpp: a short list of recently opened names.
#include "core/session/recent.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace neph {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxEntryBytes = 65536;  // in the settings: some hundred names

}  // namespace

/// Absolute, so that the entry works from any folder.
std::string recentEntry(std::span<const std::string> named) {
    std::string entry;
    for (const std::string& name : named) {
        std::error_code error;
        if (!fs::exists(name, error) || name.find('\n') != name.npos) return {};
        fs::path path = fs::absolute(name).lexically_normal();
        if (!path.has_filename()) path = path.parent_path();
        entry += (entry.empty() ? "" : "\n") + path.string();
    }
    return entry.size() > kMaxEntryBytes ? std::string() : entry;
}

std::vector<std::string> namesIn(std::string_view entry) {
    std::vector<std::string> names;
    while (!entry.empty()) {
        const std::size_t end = std::min(entry.find('\n'), entry.size());
        if (end > 0) names.emplace_back(entry.substr(0, end));
        entry.remove_prefix(std::min(end + 1, entry.size()));
    }
    return names;
}

void addRecent(std::vector<std::string>& recent, const std::string& entry) {
    if (entry.empty()) return;
    std::erase(recent, entry);
    recent.insert(recent.begin(), entry);
    if (recent.size() > kMaxRecent) recent.resize(kMaxRecent);
}

RecentLabel labelOf(std::string_view entry) {
    const std::vector<std::string> names = namesIn(entry);
    if (names.empty()) return {};
    const fs::path first = names.front();
    const std::string name = first.has_filename() ? first.filename().string() : first.string();
    return {names.size() == 1 ? name : fmt::format("{} and {} more", name, names.size() - 1),
            first.parent_path().string()};
}

bool isThere(std::string_view entry) {
    return std::ranges::all_of(namesIn(entry), [](const std::string& name) {
        std::error_code error;
        return fs::exists(name, error);
    });
}

}  // namespace neph
