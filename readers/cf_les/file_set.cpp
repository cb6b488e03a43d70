// file_set.cpp: finds files that belong together by their names.
#include "readers/cf_les/file_set.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace cf {
namespace {

namespace fs = std::filesystem;

bool isWordCharacter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0;
}

/// Where a file's name holds the name of a variable as a word; npos if it does not.
std::size_t placeIn(const std::string& fileName, const std::string& variable) {
    for (std::size_t at = fileName.find(variable); at != std::string::npos;
         at = fileName.find(variable, at + 1)) {
        const std::size_t end = at + variable.size();
        const bool begins = at == 0 || !isWordCharacter(fileName[at - 1]);
        const bool ends = end == fileName.size() || !isWordCharacter(fileName[end]);
        if (begins && ends) return at;
    }
    return std::string::npos;
}

/// The files whose names are that of `path` with another of the row's names in place of the one
/// variable that the file holds, sorted.
std::vector<std::string> companionsOf(const nc::NcFile& file, const Model& model) {
    const fs::path path(file.path());
    const std::string fileName = path.filename().string();
    std::vector<std::string> found;
    for (const Name& own : model.names) {
        if (named(file, own.name) == nullptr) continue;
        const std::size_t at = placeIn(fileName, own.name);
        if (at == std::string::npos) continue;
        for (const Name& other : model.names) {
            std::string name = fileName;
            name.replace(at, own.name.size(), other.name);
            const fs::path candidate = path.parent_path() / name;
            std::error_code code;
            if (name != fileName && fs::is_regular_file(candidate, code)) {
                found.push_back(candidate.string());
            }
        }
        break;
    }
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

}  // namespace

FileSet::FileSet(std::unique_ptr<nc::NcFile> file, const Model& model) : path_(file->path()) {
    files_.push_back(std::make_unique<TiledFile>(std::move(file), model));
    for (const std::string& other : companionsOf(files_.front()->first(), model)) {
        if (nc::containerOf(other) == nc::Container::unknown) continue;
        files_.push_back(std::make_unique<TiledFile>(std::make_unique<nc::NcFile>(other), model));
    }
    for (std::size_t i = 0; i < files_.size(); ++i) addVariables(i, model);
}

std::vector<std::string> FileSet::parts() const {
    std::vector<std::string> parts;
    for (const auto& file : files_) {
        for (std::string& path : file->paths()) {
            if (path != path_) parts.push_back(std::move(path));
        }
    }
    return parts;
}

const Stored* FileSet::find(Meaning meaning) const {
    const auto found = std::ranges::find_if(variables_, [&](const Stored& each) {
        return each.name != nullptr && each.name->meaning == meaning;
    });
    return found == variables_.end() ? nullptr : &*found;
}

void FileSet::addVariables(std::size_t index, const Model& model) {
    const nc::NcFile& file = files_[index]->first();
    const Axes axes(file, model);
    for (const nc::NcVariable& variable : file.variables()) {
        const auto layout = variable.number ? axes.layoutOf(variable) : std::nullopt;
        const bool known = std::ranges::any_of(
            variables_, [&](const Stored& each) { return each.variable->name == variable.name; });
        if (!layout || known) continue;
        variables_.push_back({index, &variable, nameOf(file, variable, model), *layout});
    }
}

void FileSet::drop(std::size_t file) {
    std::erase_if(variables_, [&](const Stored& each) { return each.file == file; });
    for (Stored& each : variables_) {
        if (each.file > file) --each.file;
    }
    files_.erase(files_.begin() + static_cast<std::ptrdiff_t>(file));
}

}  // namespace cf
