// file_list.cpp: folders opened, the bundled storm found.
#include "core/file_list.h"

#include <algorithm>

#include "core/error.h"
#include "core/resources.h"

namespace neph {
namespace {

void addFolder(const std::filesystem::path& folder, std::vector<std::filesystem::path>& files) {
    std::error_code error;
    const std::size_t before = files.size();
    for (const auto& item : std::filesystem::directory_iterator(folder, error)) {
        const bool hidden = item.path().filename().string().starts_with('.');
        std::error_code unseen;  // a link that leads nowhere is no file
        if (!hidden && item.is_regular_file(unseen)) files.push_back(item.path());
    }
    if (error) throw Error({folder.string(), "cannot be listed", error.message(), "", ""});
    if (files.size() == before) {
        throw Error({folder.string(), "holds no files", "", "model output in this folder", ""});
    }
    std::sort(files.begin() + static_cast<std::ptrdiff_t>(before), files.end());
}

}  // namespace

std::vector<std::filesystem::path> listFiles(std::span<const std::string> named) {
    std::vector<std::filesystem::path> files;
    if (named.empty()) addFolder(resourcePath("samples/supercell"), files);
    for (const std::string& name : named) {
        const std::filesystem::path path(name);
        std::error_code error;
        if (std::filesystem::is_directory(path, error)) {
            addFolder(path, files);
        } else if (std::filesystem::exists(path, error)) {
            files.push_back(path);
        } else {
            throw Error({name, "there is no such file or folder",
                         error ? error.message() : std::string(), "", ""});
        }
    }
    return files;
}

}  // namespace neph
