// mutilation_test.cpp: real files, damaged in more than a thousand ways and opened as a user would.
// Each is read correctly or gives an error that says what is wrong and where.
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <mutex>

#include "core/base/parallel.h"
#include "core/volume/held_volume.h"
#include "core/volume/native_band.h"
#include "tests/readers/mutilation.h"
#include "tests/readers/reader_host.h"
#include "tests/temporary_folder.h"

using namespace neph;

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

// Hangs are detected sooner than in normal use, to keep the test quick. A working reader needs at
// most a tenth of this for any of these files.
constexpr double kSilentCpuSeconds = 1.0;
constexpr std::uint64_t kReaderBytes = std::uint64_t{1} << 30U;
[[maybe_unused]] constexpr double kMaxSeconds = 10.0;
constexpr MemoryBudget kBudget{.machine = std::uint64_t{64} << 20U,
                               .gpu = std::uint64_t{64} << 20U};
// By how much this program may grow: two volumes of the budget at once, the fields of the bands
// that they are made from, and as much again for what the allocator keeps.
[[maybe_unused]] constexpr std::uint64_t kMaxHostBytes = std::uint64_t{512} << 20U;

#ifdef NEPH_SANITIZED
constexpr std::size_t kWays = 100;  // the same checks at a fifth of the speed
#else
constexpr std::size_t kWays = 1000;
#endif

struct Tally {
    std::mutex mutex;
    int read = 0, refused = 0;
    double slowest = 0.0;
    std::string slowestCase;
    std::vector<std::string> faults;
};

/// What is wrong with the volume that a damaged file gave; empty when nothing is.
std::string faultOf(const Dataset& dataset, const HeldVolume& held) {
    const DatasetInfo& info = dataset.info();
    if (glm::any(glm::lessThan(info.size, glm::ivec3(1)))) return "a size below one";
    for (const TimeInfo& time : info.times) {
        if (!std::isfinite(time.seconds)) return "a time that is not a number";
    }
    if (!(info.spacingM.x > 0.0 && info.spacingM.y > 0.0)) return "a spacing below zero";
    for (const VariableInfo& variable : info.variables) {
        if (variable.role == VariableRole::mixingRatio && variable.units != "kg kg-1") {
            return "a mixing ratio in " + variable.units;
        }
    }
    for (const Array3f& field : held.volume->contentKgPerM3) {
        if (field.empty()) continue;
        if (field.size != held.volume->grid.size) return "a field that is not on the grid";
        for (float value : field.values) {
            if (!(value >= 0.0f && std::isfinite(value))) return fmt::format("content {}", value);
        }
    }
    return {};
}

/// Opens a file and reads one time as for an image. Returns what is wrong; empty if nothing is.
std::string outcomeOf(const fs::path& path, const PluginHost& host, bool& read) {
    try {
        const auto dataset = Dataset::open(std::vector<fs::path>{path}, host, {}, {});
        const HeldVolume held =
            readVolume(*dataset, 0, {.region = {}, .budget = kBudget, .radii = {}});
        read = true;
        return faultOf(*dataset, held);
    } catch (const Error& error) {
        if (error.parts().what.empty()) return "an error without a text";
        if (error.parts().where.empty()) return "an error without a place: " + error.parts().what;
        return {};
    } catch (const std::exception& problem) {
        return std::string("threw ") + problem.what();
    } catch (const Cancelled&) {
        return "was cancelled, and nobody had asked to";
    }
}

void examine(const FileSet& set, std::uint64_t number, const fs::path& folder,
             const PluginHost& host, Tally& tally) {
    const std::string what = writeDamaged(set, number, folder);
    const auto start = Clock::now();
    bool read = false;
    const std::string fault = outcomeOf(folder / set.opened, host, read);
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    const std::scoped_lock lock(tally.mutex);
    (read ? tally.read : tally.refused) += 1;
    if (!fault.empty()) tally.faults.push_back(what + " gave " + fault);
    if (seconds > tally.slowest) {
        tally.slowest = seconds;
        tally.slowestCase = what;
    }
}

std::uint64_t hostBytes() {
    rusage self{};
    getrusage(RUSAGE_SELF, &self);
    return static_cast<std::uint64_t>(self.ru_maxrss) * 1024;
}

}  // namespace

TEST_CASE("Damaged files are read correctly or refused with a reason, whatever the damage") {
    const TemporaryFolder scratch;
    const std::vector<FileSet> list = fileSets(scratch / "originals");
    const PluginHost host(std::vector<fs::path>{NEPH_TEST_READER_DIR},
                          {.silentCpuSeconds = kSilentCpuSeconds, .memoryBytes = kReaderBytes});
    // kWays in total, unless the variable states how many for each file.
    const char* requested = std::getenv("NEPHOSCOPE_MUTILATIONS");
    const std::size_t each =
        requested != nullptr ? std::strtoull(requested, nullptr, 10) : kWays / list.size() + 1;
    Tally tally;
    for (const FileSet& set : list) {
        bool read = false;
        CHECK(outcomeOf(set.folder / set.opened, host, read).empty());
        CHECK(read);  // undamaged, it can be read
    }
    [[maybe_unused]] const std::uint64_t before = hostBytes();
    shareOut(each * list.size(), workerCount(4),
             [&](std::size_t piece, std::size_t worker, const Progress&) {
                 examine(list[piece % list.size()], piece / list.size(),
                         scratch / std::to_string(worker), host, tally);
             });
    for (const std::string& fault : tally.faults) FAIL_CHECK(fault);
    MESSAGE(fmt::format("{} files: {} damaged ones read, {} refused; slowest {:.1f} s ({})",
                        list.size(), tally.read, tally.refused, tally.slowest, tally.slowestCase));
    CHECK(tally.read + tally.refused == static_cast<int>(each * list.size()));
#ifndef NEPH_SANITIZED  // time and memory of the program as it is used
    CHECK_MESSAGE(tally.slowest < kMaxSeconds, tally.slowestCase);
    CHECK(hostBytes() - before < kMaxHostBytes);
    rusage readers{};
    getrusage(RUSAGE_CHILDREN, &readers);
    CHECK(static_cast<std::uint64_t>(readers.ru_maxrss) * 1024 <= kReaderBytes);
#endif
}
