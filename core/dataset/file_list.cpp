// file_list.cpp: checks paths and finds the bundled samples.
#include "core/dataset/file_list.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/base/resources.h"
#include "core/plugin/file_address.h"

namespace neph {

namespace fs = std::filesystem;

std::vector<fs::path> listFiles(std::span<const std::string> named) {
    std::vector<fs::path> files;
    if (named.empty()) files.push_back(resourcePath("samples/supercell"));
    for (const std::string& name : named) {
        std::error_code error;
        if (fs::exists(name, error)) {
            files.emplace_back(name);
            continue;
        }
        if (std::string advice = addressAdvice(name); !advice.empty()) {
            throw Error({.where = name,
                         .what = "is an address in the network, and only files are opened",
                         .hint = std::move(advice)});
        }
        std::error_code none;
        if (fs::is_symlink(name, none)) {
            throw Error({.where = name,
                         .what = "is a link to a file that is not there",
                         .found = fs::read_symlink(name, none).string(),
                         .hint = "make the link again, or name the file itself"});
        }
        const bool bare = !name.empty() && name.find('/') == name.npos && !name.starts_with('.');
        const auto sample = bare ? findResource("samples/" + name) : std::nullopt;
        if (!sample) {
            throw Error({name, "there is no such file or folder",
                         error ? error.message() : std::string(), "",
                         "a bundled sample is opened by its name: supercell, cumulus"});
        }
        files.push_back(*sample);
    }
    return files;
}

std::vector<fs::path> filesIn(std::span<const fs::path> paths) {
    std::vector<fs::path> files;
    for (const fs::path& path : paths) {
        std::error_code error;
        if (!fs::is_directory(path, error)) {
            files.push_back(path);
            continue;
        }
        const std::size_t before = files.size();
        for (const auto& item : fs::directory_iterator(path, error)) {
            const bool hidden = item.path().filename().string().starts_with('.');
            std::error_code unseen;  // dangling links are skipped
            if (!hidden && item.is_regular_file(unseen)) files.push_back(item.path());
        }
        std::sort(files.begin() + static_cast<std::ptrdiff_t>(before), files.end());
    }
    return files;
}

}  // namespace neph
