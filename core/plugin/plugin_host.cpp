// plugin_host.cpp: loads, checks and scores reader plugins.
#include "core/plugin/plugin_host.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <string_view>
#include <system_error>

#include "core/base/error.h"
#include "core/base/resources.h"
#include "core/plugin/file_kind.h"

namespace neph {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostIdle = 4;  // idle processes kept per reader

/// Sorted, so that the same reader wins on every machine.
std::vector<fs::path> librariesIn(const fs::path& place) {
    std::error_code none;
    if (fs::is_regular_file(place, none)) return {place};
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(place, none)) {
        if (entry.path().extension() == ".so") found.push_back(entry.path());
    }
    std::ranges::sort(found);
    return found;
}

/// The first bytes of a file in readable form.
std::string firstBytes(const fs::path& file) {
    std::array<char, 24> bytes{};
    std::ifstream in(file, std::ios::binary);
    in.read(bytes.data(), bytes.size());
    const auto count = static_cast<std::size_t>(in.gcount());
    std::string text;
    for (char c : std::string_view(bytes.data(), count)) {
        text += std::isprint(static_cast<unsigned char>(c)) != 0 ? c : '.';
    }
    return fmt::format("a file that begins with \"{}\"", text);
}

/// The error for what no reader takes; `readers` are those there are.
Error unknownFormat(const fs::path& file, const std::string& readers) {
    const std::optional<RecognisedFile> known = recogniseFile(file);
    std::error_code none;
    const bool folder = fs::is_directory(file, none);
    return Error({.where = file.string(),
                  .what = "no reader knows this format",
                  .found = known    ? known->what
                           : folder ? "a folder"
                                    : firstBytes(file),
                  .expected = readers,
                  .hint = known ? known->step
                                : "give the model's own output files (`nephoscope readers` lists "
                                  "what can be read); bare numbers need a `nephoscope-brick` "
                                  "sidecar that describes them (docs/raw-les.md)"});
}

}  // namespace

void requireReadable(const fs::path& file) {
    std::error_code code;
    const fs::file_status status = fs::status(file, code);
    if (code || !fs::exists(status)) {
        const bool absent = !code || code == std::errc::no_such_file_or_directory;
        throw Error({.where = file.string(),
                     .what = absent ? "no such file" : "cannot be opened: " + code.message(),
                     .hint = "check the spelling of the path"});
    }
    if (fs::is_directory(status)) return;
    if (!fs::is_regular_file(status)) {
        throw Error({.where = file.string(),
                     .what = "is neither a file nor a folder",
                     .hint = "readers seek in what they read: save the data to a file first"});
    }
    if (!std::ifstream(file, std::ios::binary)) {
        throw Error({.where = file.string(),
                     .what = fmt::format("cannot be read: {}", std::strerror(errno)),
                     .hint = "check its permissions"});
    }
}

ReaderPlugin::ReaderPlugin(const fs::path& file, const ReaderLimits& limits, fs::path mapFile)
    : map(std::move(mapFile)), limits_(limits) {
    library = file;
    auto process = std::make_unique<ReaderProcess>(library, limits_);
    static_cast<wire::Identity&>(*this) = process->identity();
    giveBack(std::move(process));
}

std::unique_ptr<ReaderProcess> ReaderPlugin::borrow() const {
    {
        const std::scoped_lock lock(mutex_);
        while (!idle_.empty()) {
            auto process = std::move(idle_.back());
            idle_.pop_back();
            if (process->alive()) return process;
        }
    }
    return std::make_unique<ReaderProcess>(library, limits_);
}

void ReaderPlugin::giveBack(std::unique_ptr<ReaderProcess> process) const {
    const std::scoped_lock lock(mutex_);
    if (process->alive() && idle_.size() < kMostIdle) idle_.push_back(std::move(process));
}

PluginHost::PluginHost(std::span<const fs::path> places, const ReaderLimits& limits, fs::path map)
    : map_(std::move(map)) {
    for (const fs::path& place : places) {
        for (const fs::path& library : librariesIn(place)) load(library, limits);
    }
}

PluginHost PluginHost::standard(std::span<const std::string> named, const std::string& map) {
    if (!map.empty() && !fs::is_regular_file(map)) {
        throw Error({.where = map,
                     .what = "there is no such map",
                     .hint = "docs/readers.md describes a nephoscope-map"});
    }
    std::vector<fs::path> places;
    for (const std::string& name : named) {
        if (!fs::exists(name)) {
            throw Error({.where = name,
                         .what = "there is no such reader",
                         .hint = "give the path of a library or of a folder of libraries"});
        }
        places.push_back(fs::absolute(name));
    }
    const std::size_t namedCount = places.size();
    std::ranges::move(standardPlaces(), std::back_inserter(places));
    PluginHost host(places, {}, map.empty() ? fs::path() : fs::absolute(map));
    for (const fs::path& place : std::span(places).first(namedCount)) {
        const auto fault = std::ranges::find(host.rejected_, place, &RejectedPlugin::library);
        if (fault == host.rejected_.end()) continue;
        throw Error({.where = place.string(),
                     .what = "cannot be used as a reader: " + fault->reason,
                     .hint = "docs/write-a-reader.md tells what a reader needs"});
    }
    return host;
}

std::vector<fs::path> PluginHost::standardPlaces() {
    std::vector<fs::path> places;
    if (const char* list = std::getenv("NEPHOSCOPE_READER_PATH"); list != nullptr) {
        std::string_view rest(list);
        while (!rest.empty()) {
            const std::size_t end = std::min(rest.find(':'), rest.size());
            if (end > 0) places.push_back(fs::absolute(rest.substr(0, end)));
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
    }
    if (const auto dir = userDataDir()) places.push_back(*dir / "readers");
    places.push_back(ownReaderDir());
    return places;
}

/// Adds a reader, or the reason why it cannot be used.
void PluginHost::load(const fs::path& library, const ReaderLimits& limits) {
    std::shared_ptr<const ReaderPlugin> reader;
    try {
        reader = std::make_shared<const ReaderPlugin>(library, limits, map_);
    } catch (const Error& error) {
        const std::string& detail = error.parts().found;
        rejected_.push_back({library, error.parts().what + (detail.empty() ? "" : ": " + detail)});
        return;
    }
    const auto same = std::ranges::find(readers_, reader->id, [](const auto& r) { return r->id; });
    if (same != readers_.end()) {
        rejected_.push_back({library, fmt::format("{} was already found in {}", reader->id,
                                                  (*same)->library.string())});
        return;
    }
    readers_.push_back(std::move(reader));
}

std::vector<std::string> PluginHost::extensions() const {
    std::vector<std::string> extensions;
    for (const auto& reader : readers_) {
        std::istringstream words(reader->extensions);
        for (std::string word; words >> word;) {
            extensions.push_back(word.starts_with('.') ? word.substr(1) : word);
        }
    }
    return extensions;
}

bool PluginHost::isKnown(const fs::path& file) const {
    return std::ranges::any_of(readers_, [&](const auto& reader) {
        try {
            auto process = reader->borrow();
            const int score = process->score(file);
            reader->giveBack(std::move(process));
            return score > 0;
        } catch (const Error&) {
            return false;
        }
    });
}

std::shared_ptr<const ReaderPlugin> PluginHost::pickForMap(const fs::path& file) const {
    const auto found =
        std::ranges::find_if(readers_, [](const auto& reader) { return reader->takesMap; });
    if (found != readers_.end() && !fs::is_directory(file)) return *found;
    throw Error({.where = file.string(),
                 .what = found == readers_.end() ? "no reader takes a map"
                                                 : "a folder is not opened by a map as a whole",
                 .hint = "`nephoscope readers` lists the readers"});
}

std::shared_ptr<const ReaderPlugin> PluginHost::pick(const fs::path& file,
                                                     const Progress& progress) const {
    requireReadable(file);
    if (!map_.empty()) return pickForMap(file);
    std::shared_ptr<const ReaderPlugin> best;
    int bestScore = 0;
    std::string known;
    std::optional<Error> failure;
    for (const auto& reader : readers_) {
        known += (known.empty() ? "" : "; ") + reader->title;
        try {
            auto process = reader->borrow();
            const int score = process->score(file, progress);
            reader->giveBack(std::move(process));
            if (score <= bestScore) continue;
            best = reader;
            bestScore = score;
        } catch (const Error& error) {
            failure = error;  // its process has ended; another reader may accept the file
        }
    }
    if (best) return best;
    if (failure) throw *failure;
    if (readers_.empty()) {
        throw Error({.where = file.string(),
                     .what = "cannot be opened: no reader plugin was found",
                     .hint = "`nephoscope readers` lists where they are looked for and why they "
                             "were rejected; NEPHOSCOPE_READER_PATH adds folders"});
    }
    throw unknownFormat(file, known);
}

}  // namespace neph
