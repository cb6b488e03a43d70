// recent.cpp: a short list of recently opened names.
#include "core/session/recent.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/base/error.h"
#include "core/dataset/member_list.h"

namespace neph {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxEntryBytes = 65536;  // in the settings: some hundred names

constexpr std::string_view kMembersLine = "members:\n";

bool isThereAs(const std::string& name, bool run) {
    std::error_code error;
    if (fs::exists(name, error)) return true;
    try {
        return run && !filesOfRun(name).empty();
    } catch (const Error&) {
        return false;
    }
}

}  // namespace

/// Absolute, so that the entry works from any folder.
std::string recentEntry(std::span<const std::string> named, bool members) {
    std::string entry;
    for (const std::string& name : named) {
        if (!isThereAs(name, members) || name.find('\n') != name.npos) return {};
        fs::path path = fs::absolute(name).lexically_normal();
        if (!path.has_filename()) path = path.parent_path();
        entry += (entry.empty() ? "" : "\n") + path.string();
    }
    if (members && !entry.empty()) entry.insert(0, kMembersLine);
    return entry.size() > kMaxEntryBytes ? std::string() : entry;
}

bool namesRuns(std::string_view entry) {
    return entry.starts_with(kMembersLine);
}

std::vector<std::string> namesIn(std::string_view entry) {
    std::vector<std::string> names;
    if (namesRuns(entry)) entry.remove_prefix(kMembersLine.size());
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
    const std::string all =
        names.size() == 1 ? name : fmt::format("{} and {} more", name, names.size() - 1);
    return {namesRuns(entry) ? "Ensemble: " + all : all, first.parent_path().string()};
}

bool isThere(std::string_view entry) {
    return std::ranges::all_of(namesIn(entry), [run = namesRuns(entry)](const std::string& name) {
        return isThereAs(name, run);
    });
}

}  // namespace neph
