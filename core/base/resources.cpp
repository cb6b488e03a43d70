// resources.cpp: the search for bundled files and for the user's folders.
#include "core/base/resources.h"

#include <fmt/format.h>

#include <cstdlib>
#include <vector>

#include "core/base/error.h"

namespace neph {
namespace {

/// An environment variable; empty counts as unset, as the XDG specification requires.
std::optional<std::string> environment(const char* name) {
    const char* value = std::getenv(name);
    if (value == nullptr || *value == '\0') return {};
    return value;
}

/// Nephoscope's folder below one of the user's folders of the XDG base directory specification.
std::optional<std::filesystem::path> userDir(const char* variable, const char* belowHome) {
    if (const auto given = environment(variable)) {
        return std::filesystem::path(*given) / "nephoscope";
    }
    if (const auto home = environment("HOME")) {
        return std::filesystem::path(*home) / belowHome / "nephoscope";
    }
    return {};
}

/// Folders with presets, samples and shaders, the preferred one first.
std::vector<std::filesystem::path> dataDirs() {
    std::vector<std::filesystem::path> dirs;
    if (const auto given = environment("NEPHOSCOPE_DATA_DIR")) dirs.emplace_back(*given);
    dirs.push_back(programDir().parent_path() / "share" / "nephoscope");
    dirs.emplace_back(NEPHOSCOPE_SOURCE_DIR);
    return dirs;
}

}  // namespace

std::filesystem::path programDir() {
    std::error_code error;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
    return error ? std::filesystem::path(".") : program.parent_path();
}

std::optional<std::filesystem::path> findResource(std::string_view relative) {
    for (const auto& dir : dataDirs()) {
        std::error_code error;
        auto path = dir / relative;
        if (std::filesystem::exists(path, error)) return path;
    }
    return {};
}

std::filesystem::path resourcePath(std::string_view relative) {
    if (auto path = findResource(relative)) return *std::move(path);
    std::string places;
    for (const auto& dir : dataDirs()) places += (places.empty() ? "" : ", ") + dir.string();
    throw Error({"", fmt::format("the bundled {} is missing", relative), "nothing in " + places,
                 fmt::format("{} in one of these", relative),
                 "set NEPHOSCOPE_DATA_DIR to the folder that holds presets, samples and shaders"});
}

std::filesystem::path ownReaderDir() {
    return programDir().parent_path() / NEPHOSCOPE_READER_SUBDIR;
}

std::optional<std::filesystem::path> userDataDir() {
    return userDir("XDG_DATA_HOME", ".local/share");
}

std::optional<std::filesystem::path> userCacheDir() {
    return userDir("XDG_CACHE_HOME", ".cache");
}

std::optional<std::filesystem::path> userConfigDir() {
    return userDir("XDG_CONFIG_HOME", ".config");
}

std::optional<std::filesystem::path> userStateDir() {
    return userDir("XDG_STATE_HOME", ".local/state");
}

std::string_view versionText() {
    return NEPHOSCOPE_VERSION;
}

}  // namespace neph
