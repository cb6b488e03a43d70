// memory_setting.cpp: /proc, control groups, and sizes as users type them.
#include "core/volume/memory_setting.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>

#include "core/base/error.h"

namespace neph {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kEverything = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t kMachineShare = 4;  // a quarter of the free memory leaves room for others
constexpr double kLeastBytes = 1U << 20U;   // less does not hold even a coarse volume

/// Powers of 1024 and of 1000, as users write them.
struct Unit {
    std::string_view name;
    double bytes;
};
constexpr std::array kUnits{Unit{"kib", 1024.0},
                            Unit{"mib", 1048576.0},
                            Unit{"gib", 1073741824.0},
                            Unit{"tib", 1099511627776.0},
                            Unit{"k", 1024.0},
                            Unit{"m", 1048576.0},
                            Unit{"g", 1073741824.0},
                            Unit{"t", 1099511627776.0},
                            Unit{"kb", 1e3},
                            Unit{"mb", 1e6},
                            Unit{"gb", 1e9},
                            Unit{"tb", 1e12},
                            Unit{"b", 1.0},
                            Unit{"", 1.0}};

/// A file with one number; empty for "max" and missing files.
std::optional<std::uint64_t> numberIn(const fs::path& file) {
    std::ifstream stream(file);
    std::uint64_t number = 0;
    if (stream >> number) return number;
    return {};  // "max", or no such file
}

/// The number after `key` in a table of keys and numbers; 0 if it is missing.
std::uint64_t entryIn(const fs::path& file, std::string_view key) {
    std::ifstream stream(file);
    std::string word;
    for (std::uint64_t number = 0; stream >> word >> number;) {
        if (word == key) return number;
        stream.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    }
    return 0;
}

/// The page cache counts as used but can be reclaimed.
std::uint64_t leftOf(std::optional<std::uint64_t> limit, std::optional<std::uint64_t> used,
                     std::uint64_t reclaimable) {
    if (!limit) return kEverything;
    const std::uint64_t kept = used.value_or(0) - std::min(used.value_or(0), reclaimable);
    return *limit - std::min(*limit, kept);
}

/// Memory that the control groups of this process leave, from its own up to the root.
std::uint64_t ownControlGroupFreeBytes() {
    std::ifstream table("/proc/self/cgroup");
    std::uint64_t left = kEverything;
    for (std::string line; std::getline(table, line);) {
        const bool second = line.starts_with("0::");
        const std::size_t memory = line.find(":memory:");
        if (!second && memory == line.npos) continue;
        const fs::path root = second ? "/sys/fs/cgroup" : "/sys/fs/cgroup/memory";
        fs::path below = fs::path(line.substr(second ? 3 : memory + 8)).relative_path();
        for (; !below.empty(); below = below.parent_path()) {
            left = std::min(left, controlGroupFreeBytes(root / below));
        }
        left = std::min(left, controlGroupFreeBytes(root));
    }
    return left;
}

[[noreturn]] void refuse(std::string_view text, const std::string& what) {
    throw Error({"memory setting", what, std::string(text),
                 "a size such as 2GiB or 512MiB, or a share of the free memory such as 50%", ""});
}

}  // namespace

std::uint64_t controlGroupFreeBytes(const fs::path& folder) {
    const std::uint64_t second =
        leftOf(numberIn(folder / "memory.max"), numberIn(folder / "memory.current"),
               entryIn(folder / "memory.stat", "inactive_file"));
    const std::uint64_t first = leftOf(numberIn(folder / "memory.limit_in_bytes"),
                                       numberIn(folder / "memory.usage_in_bytes"),
                                       entryIn(folder / "memory.stat", "total_inactive_file"));
    return std::min(first, second);
}

std::uint64_t freeMachineBytes() {
    const std::uint64_t kibibytes = entryIn("/proc/meminfo", "MemAvailable:");
    const std::uint64_t machine = kibibytes == 0 ? kEverything : kibibytes * 1024;
    return std::min(machine, ownControlGroupFreeBytes());
}

std::uint64_t residentBytes() {
    std::ifstream pages("/proc/self/statm");
    std::uint64_t all = 0, resident = 0;
    const long pageBytes = sysconf(_SC_PAGESIZE);
    return pages >> all >> resident && pageBytes > 0
               ? resident * static_cast<std::uint64_t>(pageBytes)
               : 0;
}

std::optional<std::uint64_t> parseMemory(std::string_view text, std::uint64_t freeBytes) {
    std::string plain;
    for (const char c : text) {
        if (c != ' ') plain += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    if (plain.empty()) return {};
    double number = 0.0;
    const auto [end, fault] = std::from_chars(plain.data(), plain.data() + plain.size(), number);
    const std::string_view rest(end, static_cast<std::size_t>(plain.data() + plain.size() - end));
    if (fault != std::errc{} || !std::isfinite(number)) refuse(text, "cannot be read as a size");
    double bytes = number / 100.0 * static_cast<double>(freeBytes);
    if (rest != "%") {
        const auto unit = std::ranges::find(kUnits, rest, &Unit::name);
        if (unit == kUnits.end()) refuse(text, "the unit is not known");
        bytes = number * unit->bytes;
    } else if (number > 100.0) {
        refuse(text, "is more than there is");
    }
    if (bytes < kLeastBytes) refuse(text, "is less than the least, 1 MiB");
    return static_cast<std::uint64_t>(std::min(bytes, 1e18));
}

std::string memoryText(std::uint64_t bytes) {
    const double mebibytes = static_cast<double>(bytes) / (1U << 20U);
    return mebibytes < 1000.0 ? fmt::format("{:.0f} MiB", mebibytes)
                              : fmt::format("{:.1f} GiB", mebibytes / 1024.0);
}

MemoryBudget memoryBudget(std::string_view setting, std::uint64_t gpuBytes) {
    const std::uint64_t free = freeMachineBytes();
    return {parseMemory(setting, free).value_or(free / kMachineShare), gpuBytes};
}

}  // namespace neph
