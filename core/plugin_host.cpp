// plugin_host.cpp: loading, checking and scoring of reader plugins.
#include "core/plugin_host.h"

#include <dlfcn.h>
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
#include <string_view>
#include <system_error>

#include "core/error.h"
#include "core/resources.h"

namespace neph {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxTextLength = 4096;  // longer names than any real reader has

/// A plugin's string, or nothing where it is null, has no end within reason or is empty.
std::optional<std::string> checkedText(const char* text) {
    if (text == nullptr) return {};
    const std::size_t length = strnlen(text, kMaxTextLength);
    if (length == 0 || length == kMaxTextLength) return {};
    return std::string(text, length);
}

/// Why a plugin's table cannot be used; empty when it can.
std::string faultOf(const NephReader* reader) {
    if (reader == nullptr) return fmt::format("does not serve ABI {}", NEPH_READER_ABI_VERSION);
    if (reader->header.abi_version != NEPH_READER_ABI_VERSION) {
        return fmt::format("ABI {}, this program has ABI {}", reader->header.abi_version,
                           NEPH_READER_ABI_VERSION);
    }
    if (reader->header.struct_size < sizeof(NephReader)) {
        return fmt::format("NephReader has {} bytes, at least {} are needed",
                           reader->header.struct_size, sizeof(NephReader));
    }
    if (!checkedText(reader->id)) return "the reader has no id";
    if (reader->score == nullptr || reader->open == nullptr || reader->describe == nullptr ||
        reader->read == nullptr || reader->close == nullptr) {
        return "one of the calls score, open, describe, read, close is missing";
    }
    return {};
}

/// The reader's table, or null with `reason` set.
const NephReader* enter(const fs::path& library, std::string& reason) {
    void* handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (handle == nullptr) {
        const char* text = dlerror();
        reason = text != nullptr ? text : "cannot be loaded";
        return nullptr;
    }
    void* symbol = dlsym(handle, NEPH_READER_ENTRY_NAME);
    if (symbol == nullptr) {
        reason = fmt::format("exports no {}: not a reader", NEPH_READER_ENTRY_NAME);
        return nullptr;
    }
    const auto entry = reinterpret_cast<NephReaderEntry>(symbol);
    const NephReader* reader = entry(NEPH_READER_ABI_VERSION);
    reason = faultOf(reader);
    return reason.empty() ? reader : nullptr;
}

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

/// The first bytes of a file as a person can read them.
std::string firstBytes(const fs::path& file) {
    std::array<char, 24> bytes{};
    std::ifstream in(file, std::ios::binary);
    in.read(bytes.data(), bytes.size());
    const auto count = static_cast<std::size_t>(in.gcount());
    if (count == 0) return "an empty file";
    std::string text;
    for (char c : std::string_view(bytes.data(), count)) {
        text += std::isprint(static_cast<unsigned char>(c)) != 0 ? c : '.';
    }
    return fmt::format("a file that begins with \"{}\"", text);
}

/// Throws when a path cannot be opened for reading at all.
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

/// A score that no plugin can spoil by throwing or by leaving the range.
std::int32_t scoreOf(const ReaderPlugin& reader, const fs::path& file) {
    try {
        return std::clamp(reader.calls->score(file.c_str()), 0, 100);
    } catch (...) {
        return 0;
    }
}

}  // namespace

PluginHost::PluginHost(std::span<const fs::path> places) {
    for (const fs::path& place : places) {
        for (const fs::path& library : librariesIn(place)) load(library);
    }
}

PluginHost PluginHost::standard(std::span<const std::string> named) {
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
    PluginHost host(places);
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

void PluginHost::load(const fs::path& library) {
    std::string reason;
    const NephReader* calls = nullptr;
    try {
        calls = enter(library, reason);
    } catch (const std::exception& problem) {
        reason = fmt::format("threw an exception: {}", problem.what());
    } catch (...) {
        reason = "threw an exception";
    }
    if (calls == nullptr) {
        rejected_.push_back({library, reason});
        return;
    }
    ReaderPlugin reader{.id = *checkedText(calls->id),
                        .version = checkedText(calls->version).value_or(""),
                        .title = checkedText(calls->title).value_or(""),
                        .extensions = checkedText(calls->extensions).value_or(""),
                        .library = library,
                        .abiVersion = calls->header.abi_version,
                        .calls = calls};
    const auto same = std::ranges::find(readers_, reader.id, [](const auto& r) { return r->id; });
    if (same != readers_.end()) {
        rejected_.push_back({library, fmt::format("{} was already found in {}", reader.id,
                                                  (*same)->library.string())});
        return;
    }
    readers_.push_back(std::make_shared<const ReaderPlugin>(std::move(reader)));
}

std::shared_ptr<const ReaderPlugin> PluginHost::pick(const fs::path& file) const {
    requireReadable(file);
    std::shared_ptr<const ReaderPlugin> best;
    std::int32_t bestScore = 0;
    std::string known;
    for (const auto& reader : readers_) {
        const std::int32_t score = scoreOf(*reader, file);
        if (score > bestScore) {
            best = reader;
            bestScore = score;
        }
        known += (known.empty() ? "" : "; ") + reader->title;
    }
    if (best) return best;
    if (readers_.empty()) {
        throw Error({.where = file.string(),
                     .what = "cannot be opened: no reader plugin was found",
                     .hint = "`nephoscope readers` lists where they are looked for and why they "
                             "were rejected; NEPHOSCOPE_READER_PATH adds folders"});
    }
    std::error_code none;
    throw Error({.where = file.string(),
                 .what = "no reader knows this format",
                 .found = fs::is_directory(file, none) ? "a folder" : firstBytes(file),
                 .expected = known,
                 .hint =
                     "give the model's own output files; `nephoscope readers` lists what can be "
                     "read"});
}

}  // namespace neph
