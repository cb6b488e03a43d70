// droplet_cache.cpp: droplets already computed, in memory and on disk.
//
// A file is one header and the numbers in this machine's byte order, with a checksum over the
// numbers. Its name holds the version of the computation: a change there makes old files unread,
// not wrong. Whatever is odd about a file, it is ignored.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "core/atomic_file.h"
#include "core/droplets.h"
#include "core/error.h"

namespace neph {
namespace {

/// Raised with every change of droplets.cpp or mie.cpp that changes numbers.
constexpr std::uint32_t kVersion = 1;
constexpr std::size_t kNumberCount = std::size_t{kPhaseTableSize} * 4 + 6;

struct Header {
    std::array<char, 8> magic{'N', 'E', 'P', 'H', 'D', 'R', 'O', 'P'};
    std::uint32_t version = kVersion;
    std::uint32_t tableSize = kPhaseTableSize;
    float effectiveRadiusM = 0.0f;
    std::uint32_t checksum = 0;
    bool operator==(const Header&) const = default;
};

struct CacheFile {
    Header header;
    std::array<float, kNumberCount> numbers{};
};

float roundRadius(float radiusM) {
    const float clamped = std::clamp(radiusM, kSmallestDropletM, kLargestDropletM);
    return std::round(clamped * 1e7f) / 1e7f;
}

/// FNV-1a, 32 bit. [Fowler]
std::uint32_t checksum(const std::array<float, kNumberCount>& numbers) {
    std::uint32_t hash = 2166136261u;
    for (float number : numbers) hash = (hash ^ std::bit_cast<std::uint32_t>(number)) * 16777619u;
    return hash;
}

CacheFile pack(const DropletOptics& optics) {
    CacheFile file;
    float* out = file.numbers.data();
    for (int c = 0; c < 3; ++c) *out++ = optics.asymmetry[c];
    for (int c = 0; c < 3; ++c) *out++ = optics.extinctionEfficiency[c];
    for (const glm::vec3& value : optics.phase) {
        for (int c = 0; c < 3; ++c) *out++ = value[c];
    }
    for (float value : optics.cumulative) *out++ = value;
    file.header.effectiveRadiusM = optics.effectiveRadiusM;
    file.header.checksum = checksum(file.numbers);
    return file;
}

DropletOptics unpack(const CacheFile& file) {
    DropletOptics optics;
    optics.effectiveRadiusM = file.header.effectiveRadiusM;
    const float* in = file.numbers.data();
    for (int c = 0; c < 3; ++c) optics.asymmetry[c] = *in++;
    for (int c = 0; c < 3; ++c) optics.extinctionEfficiency[c] = *in++;
    optics.phase.resize(kPhaseTableSize);
    for (glm::vec3& value : optics.phase) {
        for (int c = 0; c < 3; ++c) value[c] = *in++;
    }
    optics.cumulative.assign(in, in + kPhaseTableSize);
    return optics;
}

std::optional<DropletOptics> readCache(float radiusM) {
    const std::filesystem::path path = dropletCacheFile(radiusM);
    if (path.empty()) return std::nullopt;
    std::ifstream stream(path, std::ios::binary);
    CacheFile file;
    std::array<char, sizeof(CacheFile) + 1> bytes;  // one more shows a file that is too long
    stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (stream.gcount() != static_cast<std::streamsize>(sizeof(CacheFile))) return std::nullopt;
    std::memcpy(&file, bytes.data(), sizeof(CacheFile));
    Header expected;
    expected.effectiveRadiusM = radiusM;
    expected.checksum = checksum(file.numbers);
    if (file.header != expected) return std::nullopt;
    return unpack(file);
}

void writeCache(const DropletOptics& optics) {
    const std::filesystem::path path = dropletCacheFile(optics.effectiveRadiusM);
    if (path.empty()) return;
    const CacheFile file = pack(optics);
    std::string bytes(sizeof(CacheFile), '\0');
    std::memcpy(bytes.data(), &file, sizeof(CacheFile));
    try {
        std::filesystem::create_directories(path.parent_path());
        replaceFile(path, bytes);
    } catch (const Error&) {  // computed again next time
    } catch (const std::filesystem::filesystem_error&) {
    }
}

}  // namespace

std::filesystem::path dropletCacheFile(float effectiveRadiusM) {
    std::filesystem::path folder;
    const char* cache = std::getenv("XDG_CACHE_HOME");
    const char* home = std::getenv("HOME");
    if (cache && *cache) {
        folder = cache;
    } else if (home && *home) {
        folder = std::filesystem::path(home) / ".cache";
    } else {
        return {};
    }
    return folder / "nephoscope" /
           fmt::format("droplets-v{}-{:.1f}um.bin", kVersion, roundRadius(effectiveRadiusM) * 1e6f);
}

std::shared_ptr<const DropletOptics> waterDroplets(float effectiveRadiusM) {
    static std::mutex mutex;
    static std::map<float, std::shared_ptr<const DropletOptics>> known;
    const float radiusM = roundRadius(effectiveRadiusM);
    const std::lock_guard lock(mutex);  // a second thread that wants the same radius waits for it
    auto& entry = known[radiusM];
    if (!entry) {
        std::optional<DropletOptics> optics = readCache(radiusM);
        if (!optics) {
            optics = computeDroplets(radiusM);
            writeCache(*optics);
        }
        entry = std::make_shared<const DropletOptics>(std::move(*optics));
    }
    return entry;
}

}  // namespace neph
