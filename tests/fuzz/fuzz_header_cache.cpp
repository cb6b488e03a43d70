// fuzz_header_cache.cpp: whatever follows the correct checksum, folder and reader in a cache of
// headers, it is read or the cache counts as empty.
#include <fmt/format.h>

#include <cstdlib>
#include <iterator>

#include "core/dataset/header_cache.h"
#include "tests/fuzz/scratch.h"

namespace {

/// FNV-1a, as in header_cache.cpp. [Fowler]
std::string checksumOf(std::string_view body) {
    std::uint64_t hash = 14695981039346656037U;
    for (const char c : body) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
    return fmt::format("{:016x}\n", hash);
}

/// The folder of the cache, and the names at the start of its file.
struct Place {
    Place() {
        // An empty cache consists of a checksum, names, and two counts of zero.
        neph::HeaderCache cache = open();
        cache.put("gone", {}, {});
        cache.save();
        for (const auto& entry : std::filesystem::directory_iterator(scratch.folder() / "cache")) {
            file = entry.path();
        }
        std::ifstream in(file, std::ios::binary);
        const std::string whole{std::istreambuf_iterator<char>(in), {}};
        const std::size_t checksum = checksumOf("").size();
        const std::size_t counts = 2 * sizeof(std::uint64_t);
        if (whole.size() < checksum + counts) std::abort();
        names = whole.substr(checksum, whole.size() - checksum - counts);
    }
    neph::HeaderCache open() const {
        neph::ReaderName reader;
        reader.id = "fuzz";
        return {scratch.folder() / "cache", scratch.folder(), reader};
    }
    fuzz::Scratch scratch;
    std::filesystem::path file;
    std::string names;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    static const Place place;
    std::string body = place.names;
    body += fuzz::asText({bytes, count});
    place.scratch.write("cache/" + place.file.filename().string(), checksumOf(body) + body);
    place.open().find("wrfout", {});
    return 0;
}
