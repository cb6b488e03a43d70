// member_list.cpp: patterns, folders of members, and short names.
#include "core/dataset/member_list.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glob.h>

#include <algorithm>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <string_view>

#include "core/base/error.h"
#include "core/dataset/file_list.h"

namespace neph {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kSeparators = "_-./ ";
constexpr std::size_t kMembersListed = 4;

/// A word that numbers a member, as ensembles of WRF, ICON, COSMO and DART are written. Not d01,
/// which numbers the domains of a nested run.
const std::regex& memberWord() {
    static const std::regex word("(member|mem|ens|pert|real|run|m|e|r|p)[_-]?[0-9]+",
                                 std::regex::icase | std::regex::optimize);
    return word;
}

bool isPattern(const std::string& name) {
    std::error_code error;
    return name.find_first_of("*?[") != name.npos && !fs::exists(name, error);
}

std::vector<fs::path> matches(const std::string& pattern) {
    glob_t found{};
    std::vector<fs::path> paths;
    if (::glob(pattern.c_str(), 0, nullptr, &found) == 0) {
        paths.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
    }
    ::globfree(&found);
    if (!paths.empty()) return paths;
    throw Error({.where = pattern,
                 .what = "matches no file",
                 .hint = "a pattern of a member is quoted, so that the shell leaves it alone"});
}

struct Word {
    std::size_t from = 0, to = 0;
};

std::vector<Word> wordsOf(const std::string& text) {
    std::vector<Word> words;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t from = text.find_first_not_of(kSeparators, at);
        if (from == text.npos) break;
        at = std::min(text.find_first_of(kSeparators, from), text.size());
        words.push_back({from, at});
    }
    return words;
}

/// Index of the text behind `from` that equals an earlier one.
template <typename Range>
std::optional<std::size_t> firstRepeated(const Range& texts) {
    std::set<std::string> seen;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        if (!seen.insert(texts[i]).second) return i;
    }
    return {};
}

/// What tells runs apart: the names of their files, else their folders, else their whole paths.
std::vector<std::string> namesOf(const std::vector<std::string>& runs) {
    std::vector<std::string> ends;
    ends.reserve(runs.size());
    for (const std::string& run : runs) ends.push_back(fs::path(run).filename().string());
    return differingParts(firstRepeated(ends) ? runs : ends);
}

/// Regular files and folders in a folder, without hidden ones, by name.
std::vector<fs::path> entriesIn(const fs::path& folder, bool folders) {
    std::vector<fs::path> entries;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        std::error_code unseen;
        const bool wanted = folders ? entry.is_directory(unseen) : entry.is_regular_file(unseen);
        if (wanted && !entry.path().filename().string().starts_with('.')) {
            entries.push_back(entry.path());
        }
    }
    std::ranges::sort(entries);
    return entries;
}

bool holdsFiles(const fs::path& folder) {
    return !entriesIn(folder, false).empty();
}

/// The word of a file name that numbers its member, or none.
std::string memberIn(const std::string& name) {
    const std::vector<Word> words = wordsOf(name);
    for (std::size_t i = 0; i < words.size(); ++i) {
        std::string word = name.substr(words[i].from, words[i].to - words[i].from);
        if (std::regex_match(word, memberWord())) return word;
        if (i + 1 == words.size()) break;  // "mem_01"
        std::string two = name.substr(words[i].from, words[i + 1].to - words[i].from);
        if (std::regex_match(two, memberWord())) return two;
    }
    return {};
}

std::string listed(const std::vector<MemberFiles>& members) {
    std::vector<std::string_view> names;
    names.reserve(members.size());
    for (const MemberFiles& member : members) names.push_back(member.name);
    const std::size_t left = names.size();
    if (left <= kMembersListed + 1) return fmt::format("{}", fmt::join(names, ", "));
    names.resize(kMembersListed);
    return fmt::format("{}, ... {}", fmt::join(names, ", "), members.back().name);
}

/// The subfolders of `folder` as members, where there are two at least that hold files.
std::vector<MemberFiles> membersByFolder(const fs::path& folder) {
    std::vector<fs::path> runs = entriesIn(folder, true);
    std::erase_if(runs, [](const fs::path& run) { return !holdsFiles(run); });
    // Beside folders that are numbered as members others are not of the ensemble.
    const auto numbered = [](const fs::path& run) {
        return !memberIn(run.filename().string()).empty();
    };
    if (std::ranges::count_if(runs, numbered) >= 2) {
        std::erase_if(runs, [&](const fs::path& run) { return !numbered(run); });
    }
    std::vector<MemberFiles> members;
    if (runs.size() < 2) return members;
    for (const fs::path& run : runs) members.push_back({run.filename().string(), {run}});
    return members;
}

std::vector<MemberFiles> membersByFile(const fs::path& folder) {
    std::map<std::string, std::vector<fs::path>> found;
    for (const fs::path& file : entriesIn(folder, false)) {
        const std::string member = memberIn(file.filename().string());
        if (!member.empty()) found[member].push_back(file);
    }
    std::vector<MemberFiles> members;
    if (found.size() < 2) return members;
    for (auto& [name, files] : found) members.push_back({name, std::move(files)});
    return members;
}

MemberList membersIn(const fs::path& folder) {
    MemberList list;
    list.members = membersByFolder(folder);
    const bool folders = !list.members.empty();
    if (!folders) list.members = membersByFile(folder);
    if (list.members.empty()) {
        throw Error(
            {.where = folder.string(),
             .what = "holds no members of an ensemble",
             .found = fmt::format("{} folders with files, {} files",
                                  std::ranges::count_if(entriesIn(folder, true), holdsFiles),
                                  entriesIn(folder, false).size()),
             .expected = "a folder for each member, or files whose names number it: mem01, "
                         "_m01, ens3",
             .hint = "name the runs one by one, each a file, a folder or a quoted pattern"});
    }
    list.taken =
        fmt::format("The members are {} {} of {}: {}.", list.members.size(),
                    folders ? "folders" : "groups of files", folder.string(), listed(list.members));
    return list;
}

}  // namespace

std::vector<std::string> differingParts(std::span<const std::string> texts) {
    std::vector<std::vector<Word>> words;
    std::size_t fewest = texts.empty() ? 0 : texts.front().size();
    for (const std::string& text : texts) {
        words.push_back(wordsOf(text));
        fewest = std::min(fewest, words.back().size());
    }
    const auto word = [&](std::size_t i, std::size_t at) {
        const Word& found = words[i][at];
        return std::string_view(texts[i]).substr(found.from, found.to - found.from);
    };
    const auto agree = [&](std::size_t skipped, bool fromEnd) {
        for (std::size_t i = 1; i < texts.size(); ++i) {
            const std::size_t mine = fromEnd ? words[i].size() - 1 - skipped : skipped;
            const std::size_t first = fromEnd ? words[0].size() - 1 - skipped : skipped;
            if (word(i, mine) != word(0, first)) return false;
        }
        return true;
    };
    std::size_t before = 0, behind = 0;
    while (before + 1 < fewest && agree(before, false)) ++before;
    while (before + behind + 1 < fewest && agree(behind, true)) ++behind;
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        if (words[i].empty()) {
            parts.push_back(texts[i]);
            continue;
        }
        const std::size_t from = words[i][before].from;
        parts.push_back(texts[i].substr(from, words[i][words[i].size() - 1 - behind].to - from));
    }
    if (firstRepeated(parts)) return {texts.begin(), texts.end()};  // they differ by separators
    return parts;
}

MemberList listMembers(std::span<const std::string> runs) {
    std::error_code error;
    if (runs.size() == 1 && fs::is_directory(runs.front(), error)) return membersIn(runs.front());
    if (runs.size() < 2) {
        throw Error({.where = runs.empty() ? "" : runs.front(),
                     .what = "an ensemble has two members at least",
                     .found = fmt::format("{}", runs.size()),
                     .hint = "name each run, or the folder that holds them all"});
    }
    std::vector<std::string> plain;
    for (const std::string& run : runs) {
        const fs::path path = fs::path(run).lexically_normal();
        plain.push_back((path.has_filename() ? path : path.parent_path()).string());
    }
    if (const auto twice = firstRepeated(plain)) {
        throw Error({.where = runs[*twice],
                     .what = "is named twice among the members",
                     .hint = "name each run once"});
    }
    const std::vector<std::string> names = namesOf(plain);
    MemberList list;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        list.members.push_back({names[i], filesOfRun(runs[i])});
    }
    return list;
}

std::vector<fs::path> filesOfRun(const std::string& run) {
    return isPattern(run) ? matches(run) : listFiles(std::span(&run, 1));
}

std::vector<fs::path> pathsOf(std::span<const MemberFiles> members) {
    std::vector<fs::path> paths;
    for (const MemberFiles& member : members) {
        paths.insert(paths.end(), member.paths.begin(), member.paths.end());
    }
    return paths;
}

}  // namespace neph
