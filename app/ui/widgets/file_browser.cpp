// file_browser.cpp: lists, lines and choices.
#include "app/ui/widgets/file_browser.h"

#include <sys/stat.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string_view>

#include "app/ui/widgets/words.h"
#include "core/base/names.h"
#include "core/plugin/file_address.h"
#include "core/session/file_kind.h"
#include "core/session/session_file.h"

namespace neph::ui {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxEntries = 20000;  // of one folder

std::string tailOf(const std::string& line) {
    const std::size_t slash = line.rfind('/');
    return slash == line.npos ? line : line.substr(slash + 1);
}

std::string headOf(const std::string& line) {
    const std::size_t slash = line.rfind('/');
    return slash == line.npos ? std::string() : line.substr(0, slash + 1);
}

fs::path expanded(const std::string& line) {
    const char* home = std::getenv("HOME");
    if (home != nullptr && (line == "~" || line.starts_with("~/"))) {
        return home + line.substr(1);
    }
    return line;
}

/// The beginning of a NetCDF or HDF5 file.
bool hasMagic(const fs::path& file) {
    std::string head(4, '\0');
    std::ifstream(file, std::ios::binary).read(head.data(), 4);
    return head.starts_with("CDF") || head == "\x89HDF";
}

bool hasExtension(const FileBrowser& browser, const std::string& name) {
    return std::ranges::any_of(browser.extensions, [&](const std::string& extension) {
        return lower(name).ends_with("." + extension);
    });
}

FileEntry entryOf(const fs::directory_entry& item) {
    FileEntry entry;
    entry.name = item.path().filename().string();
    struct stat status {};
    if (::stat(item.path().c_str(), &status) != 0) return entry;
    entry.folder = S_ISDIR(status.st_mode);
    if (!entry.folder && !S_ISREG(status.st_mode))
        entry.fits = false;  // a device is not looked into
    entry.bytes = static_cast<std::uint64_t>(status.st_size);
    entry.changed = status.st_mtime;
    return entry;
}

bool before(const FileEntry& a, const FileEntry& b) {
    if (a.folder != b.folder) return a.folder;
    return lower(a.name) < lower(b.name);
}

void goTo(FileBrowser& browser, const fs::path& folder) {
    browser.line = folder.string();
    if (!browser.line.ends_with('/')) browser.line += '/';
    browser.narrows = false;
    browser.chosen.clear();
    browser.marked = browser.anchor = -1;
    browser.focus = browser.toEnd = true;
    refresh(browser);
}

std::optional<std::vector<std::string>> acceptTarget(FileBrowser& browser, fs::path path) {
    std::error_code error;
    if (path.extension().empty()) path += kSessionEnding;
    if (!fs::is_directory(fs::absolute(path).parent_path(), error)) {
        browser.fault = "There is no folder " + path.parent_path().string();
        return {};
    }
    if (fs::exists(path, error) && !browser.replaces) {
        browser.replaces = true;
        return {};
    }
    return {{path.string()}};
}

}  // namespace

void begin(FileBrowser& browser, BrowseFor purpose, const fs::path& start) {
    std::error_code error;
    browser.purpose = purpose;
    browser.fault.clear();
    browser.replaces = false;
    const bool known = !browser.folder.empty() && fs::is_directory(browser.folder, error);
    goTo(browser, known ? browser.folder : start);
    refresh(browser, true);
    browser.selectsName = purpose == BrowseFor::saveSession;
    if (browser.selectsName) browser.line += "session" + std::string(kSessionEnding);
}

fs::path pathOf(const FileBrowser& browser) {
    return expanded(browser.line);
}

void refresh(FileBrowser& browser, bool again) {
    std::error_code error;
    const std::string head = headOf(browser.line);
    const fs::path folder = fs::absolute(head.empty() ? "." : expanded(head)).lexically_normal();
    if ((folder == browser.folder && !again) || !fs::is_directory(folder, error)) return;
    browser.folder = folder;
    browser.entries.clear();
    browser.chosen.clear();
    browser.marked = browser.anchor = -1;
    for (const auto& item : fs::directory_iterator(folder, error)) {
        if (browser.entries.size() == kMaxEntries) break;
        FileEntry entry = entryOf(item);
        if (!entry.name.starts_with('.')) browser.entries.push_back(std::move(entry));
    }
    std::ranges::sort(browser.entries, before);
}

std::vector<int> shownEntries(const FileBrowser& browser) {
    const std::string wanted = browser.narrows ? lower(tailOf(browser.line)) : std::string();
    std::vector<int> shown;
    for (std::size_t i = 0; i < browser.entries.size(); ++i) {
        const bool agrees = lower(browser.entries[i].name).find(wanted) != std::string::npos;
        if (agrees) shown.push_back(static_cast<int>(i));
    }
    return shown;
}

std::size_t laterPath(const std::string& line) {
    if (const auto address = addressIn(line)) return *address;
    const std::size_t slashes = line.rfind("//");
    const std::size_t home = line.rfind("/~");
    std::size_t at = 0;
    if (slashes != line.npos) at = slashes + 1;
    if (home != line.npos) at = std::max(at, home + 1);
    return at;
}

NamePart namePart(const FileBrowser& browser) {
    const std::string& line = browser.line;
    const std::size_t from = headOf(line).size();
    const bool ends = browser.purpose == BrowseFor::saveSession && line.ends_with(kSessionEnding);
    return {from, std::max(from, line.size() - (ends ? kSessionEnding.size() : 0))};
}

void typeOn(FileBrowser& browser, const std::string& typed) {
    if (typed.empty()) return;
    const NamePart name = namePart(browser);
    const std::size_t from = browser.selectsName ? name.from : name.to;
    browser.line.replace(from, name.to - from, typed);
    browser.line.erase(0, laterPath(browser.line));
    browser.selectsName = false;
    browser.narrows = true;
}

std::string completed(const FileBrowser& browser) {
    const std::string tail = tailOf(browser.line);
    std::optional<std::string> common;
    bool folder = false;
    int count = 0;
    for (const FileEntry& entry : browser.entries) {
        if (!entry.name.starts_with(tail)) continue;
        ++count;
        folder = entry.folder;
        if (!common) common = entry.name;
        const auto end =
            std::mismatch(common->begin(), common->end(), entry.name.begin(), entry.name.end());
        common->erase(end.first, common->end());
    }
    if (!common) return browser.line;
    return headOf(browser.line) + *common + (count == 1 && folder ? "/" : "");
}

bool fits(FileBrowser& browser, FileEntry& entry) {
    if (entry.folder) return true;
    if (entry.fits) return *entry.fits;
    const fs::path file = browser.folder / entry.name;
    switch (browser.purpose) {
        case BrowseFor::session:
        case BrowseFor::saveSession:
            entry.fits = kindOfFile(file) == FileKind::session;
            break;
        case BrowseFor::data:
        case BrowseFor::moved:
        case BrowseFor::members:
            entry.fits = hasMagic(file) ||
                         (hasExtension(browser, entry.name) && kindOfFile(file) == FileKind::data);
            break;
    }
    return *entry.fits;
}

void choose(FileBrowser& browser, int shown, bool add, bool range) {
    const std::vector<int> rows = shownEntries(browser);
    const auto nameAt = [&](int row) {
        return browser.entries[static_cast<std::size_t>(rows.at(static_cast<std::size_t>(row)))]
            .name;
    };
    const int last = static_cast<int>(rows.size()) - 1;
    shown = std::clamp(shown, 0, std::max(0, last));
    if (last < 0) return;
    if (range && browser.anchor >= 0) {
        browser.chosen.clear();
        const int from = std::min(browser.anchor, last);
        for (int i = std::min(from, shown); i <= std::max(from, shown); ++i) {
            browser.chosen.insert(nameAt(i));
        }
    } else if (add) {
        if (browser.chosen.erase(nameAt(shown)) == 0) browser.chosen.insert(nameAt(shown));
        browser.anchor = shown;
    } else {
        browser.chosen = {nameAt(shown)};
        browser.anchor = shown;
    }
    browser.marked = shown;
    browser.selectsName = false;
    browser.line = headOf(browser.line) + nameAt(shown);
    browser.fault.clear();
    browser.replaces = false;
}

void goUp(FileBrowser& browser) {
    const fs::path listed =
        browser.folder.has_filename() ? browser.folder : browser.folder.parent_path();
    goTo(browser, listed.parent_path());
}

std::optional<std::vector<std::string>> accept(FileBrowser& browser) {
    browser.fault.clear();
    const bool opens = browser.purpose != BrowseFor::saveSession;
    if (opens && browser.chosen.size() > 1) {
        std::vector<std::string> names;
        for (const std::string& name : browser.chosen) {
            names.push_back((browser.folder / name).string());
        }
        return names;
    }
    if (const std::string advice = addressAdvice(browser.line); opens && !advice.empty()) {
        browser.fault = "This is a network address: " + advice;
        return {};
    }
    std::error_code error;
    const fs::path path = pathOf(browser);
    if (path.empty()) return {};
    if (fs::is_directory(path, error)) {
        const bool asSeries = browser.purpose != BrowseFor::session && opens;
        if (asSeries && browser.line.ends_with('/')) return {{path.string()}};
        goTo(browser, path);
        return {};
    }
    if (!opens) return acceptTarget(browser, path);
    const bool sample =
        browser.purpose == BrowseFor::data && browser.line.find('/') == std::string::npos;
    if (sample || fs::exists(path, error)) return {{path.string()}};
    std::vector<std::string_view> names;
    for (const FileEntry& entry : browser.entries) names.push_back(entry.name);
    const std::string_view near = nearestName(tailOf(browser.line), names);
    browser.fault = "There is no such file or folder.";
    if (!near.empty()) browser.fault += " Did you mean " + std::string(near) + "?";
    return {};
}

}  // namespace neph::ui
