// plugin_library.cpp: dlopen, and the checks on a reader's table.
#include "core/plugin/plugin_library.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <cstddef>
#include <cstring>
#include <optional>

#include "core/base/error.h"
#include "core/plugin/abi_versions.h"

namespace neph {
namespace {

constexpr std::size_t kMaxTextLength = 4096;  // longer than the names of any real reader

/// A string of the plugin; empty optional if it is null, empty or too long.
std::optional<std::string> checkedText(const char* text) {
    if (text == nullptr) return {};
    const std::size_t length = strnlen(text, kMaxTextLength);
    if (length == 0 || length == kMaxTextLength) return {};
    return std::string(text, length);
}

/// The calls that readers of every version have.
constexpr std::size_t kFirstReaderBytes = offsetof(NephReader, open_with_map);

/// Why a plugin's table cannot be used; empty if it can.
std::string faultOf(const NephReader* reader) {
    if (reader == nullptr) return "does not serve " + servedAbiText();
    if (!servesAbi(reader->header.abi_version)) {
        return fmt::format("ABI {}, this program has {}", reader->header.abi_version,
                           servedAbiText());
    }
    if (reader->header.struct_size < kFirstReaderBytes) {
        return fmt::format("NephReader has {} bytes, at least {} are needed",
                           reader->header.struct_size, kFirstReaderBytes);
    }
    if (!checkedText(reader->id)) return "the reader has no id";
    if (reader->score == nullptr || reader->open == nullptr || reader->describe == nullptr ||
        reader->read == nullptr || reader->close == nullptr) {
        return "one of the calls score, open, describe, read, close is missing";
    }
    return {};
}

/// Calls the entry function, which may be foreign C++ and may throw all the same; with older
/// versions too, because a reader may answer to the one that it was built for alone.
const NephReader* entered(void* symbol) {
    const auto entry = reinterpret_cast<NephReaderEntry>(symbol);
    try {
        for (std::uint32_t version = NEPH_READER_ABI_VERSION; version >= kOldestReaderAbi;
             --version) {
            if (const NephReader* reader = entry(version); reader != nullptr) return reader;
        }
        return nullptr;
    } catch (const std::exception& problem) {
        throw Error({.what = fmt::format("threw an exception: {}", problem.what())});
    } catch (...) {
        throw Error({.what = "threw an exception"});
    }
}

}  // namespace

PluginLibrary loadPlugin(const std::filesystem::path& library) {
    void* handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (handle == nullptr) {
        const char* text = dlerror();
        throw Error({.what = text != nullptr ? text : "cannot be loaded"});
    }
    void* symbol = dlsym(handle, NEPH_READER_ENTRY_NAME);
    if (symbol == nullptr) {
        throw Error({.what = fmt::format("exports no {}: not a reader", NEPH_READER_ENTRY_NAME)});
    }
    return checkPlugin(entered(symbol));
}

PluginLibrary checkPlugin(const NephReader* calls) {
    if (const std::string fault = faultOf(calls); !fault.empty()) throw Error({.what = fault});
    return {{.id = *checkedText(calls->id),
             .version = checkedText(calls->version).value_or(""),
             .title = checkedText(calls->title).value_or(""),
             .extensions = checkedText(calls->extensions).value_or(""),
             .abiVersion = calls->header.abi_version,
             .takesMap = calls->header.struct_size >= sizeof(NephReader) &&
                         calls->open_with_map != nullptr},
            calls};
}

}  // namespace neph
