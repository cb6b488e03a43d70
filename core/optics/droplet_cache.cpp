// droplet_cache.cpp: droplet optics already computed, in memory and on disk.
#include "core/optics/droplet_cache.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/resources.h"

namespace neph {
namespace {

constexpr std::size_t kNumberCount = std::size_t{kPhaseTableSize} * 4 + 6;

/// A file is valid only if its header equals the expected one in every field.
struct Header {
    std::array<char, 8> magic{'N', 'E', 'P', 'H', 'D', 'R', 'O', 'P'};
    std::uint32_t version = kDropletCacheVersion;
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

}  // namespace

std::optional<DropletOptics> readDropletCache(const std::filesystem::path& path,
                                              float effectiveRadiusM) {
    std::ifstream stream(path, std::ios::binary);
    std::string bytes(sizeof(CacheFile) + 1, '\0');  // the extra byte reveals files too long
    stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (stream.gcount() != static_cast<std::streamsize>(sizeof(CacheFile))) return std::nullopt;
    CacheFile file;
    std::memcpy(&file, bytes.data(), sizeof(CacheFile));
    Header expected;
    expected.effectiveRadiusM = effectiveRadiusM;
    expected.checksum = checksum(file.numbers);
    if (file.header != expected) return std::nullopt;
    return unpack(file);
}

bool writeDropletCache(const std::filesystem::path& path, const DropletOptics& optics) {
    const CacheFile file = pack(optics);
    std::string bytes(sizeof(CacheFile), '\0');
    std::memcpy(bytes.data(), &file, sizeof(CacheFile));
    try {
        std::filesystem::create_directories(path.parent_path());
        replaceFile(path, bytes);
    } catch (const Error&) {
        return false;
    } catch (const std::filesystem::filesystem_error&) {
        return false;
    }
    return true;
}

std::filesystem::path dropletCacheFile(float effectiveRadiusM) {
    const auto folder = userCacheDir();
    if (!folder) return {};
    return *folder / fmt::format("droplets-v{}-{:.1f}um.bin", kDropletCacheVersion,
                                 roundRadius(effectiveRadiusM) * 1e6f);
}

std::shared_ptr<const DropletOptics> waterDroplets(float effectiveRadiusM, float wavelengthM) {
    static std::mutex mutex;
    static std::map<std::pair<float, float>, std::shared_ptr<const DropletOptics>> known;
    const float radiusM = roundRadius(effectiveRadiusM);
    const std::lock_guard lock(mutex);  // so that two threads never compute the same radius
    auto& entry = known[{radiusM, wavelengthM}];
    if (!entry) {
        const std::filesystem::path path =
            wavelengthM > 0.0f ? std::filesystem::path() : dropletCacheFile(radiusM);
        std::optional<DropletOptics> optics;
        if (!path.empty()) optics = readDropletCache(path, radiusM);
        if (!optics) {
            optics = computeDroplets(radiusM, wavelengthM);
            if (!path.empty()) writeDropletCache(path, *optics);
        }
        entry = std::make_shared<const DropletOptics>(std::move(*optics));
    }
    return entry;
}

}  // namespace neph
