// hostile_test.cpp: whatever a reader library does, the program gets an error and continues.
//
// Readers run in processes of their own; the one in hostile/ misbehaves as its file asks.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <iterator>
#include <thread>

#include "core/plugin/reader_file.h"
#include "tests/environment.h"
#include "tests/readers/reader_host.h"
#include "tests/temporary_folder.h"

using namespace neph;

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

#ifdef NEPH_SANITIZED
constexpr bool kMemoryIsLimited = false;  // sanitizers map terabytes
constexpr double kSlowness = 5.0;         // and start slowly
#else
constexpr bool kMemoryIsLimited = true;
constexpr double kSlowness = 1.0;
#endif

// Short, to keep the tests short; a working reader stays far below both.
constexpr ReaderLimits kLimits{.silentCpuSeconds = 0.3 * kSlowness,
                               .answerSeconds = 2.0 * kSlowness,
                               .memoryBytes = std::uint64_t{512} << 20U};

struct Hostile {
    explicit Hostile(const ReaderLimits& limits = kLimits)
        : host(std::vector<fs::path>{NEPH_TEST_HOSTILE}, limits) {}

    TemporaryFolder folder;
    PluginHost host;

    fs::path file(const std::string& instruction) const {
        fs::path path = folder / (instruction + ".bad");
        std::ofstream(path) << "HOSTILE " << instruction;
        return path;
    }
    std::vector<float> read(const std::string& instruction, const Progress& progress = {}) const {
        const fs::path path = file(instruction);
        ReaderFile open(host.pick(path, progress), path, progress);
        return open.read(0, 0, {glm::ivec3(0), glm::ivec3(4)}, progress);
    }
    /// The error as one text. Checks that it names the file.
    std::string fault(const std::string& instruction) const {
        const ErrorParts parts = errorOf([&] { read(instruction); });
        CHECK(parts.where == (folder / (instruction + ".bad")).string());
        CHECK(!parts.what.empty());
        return parts.what + ": " + parts.found;
    }
    void requireGood() const {
        const std::vector<float> values = read("good -");
        REQUIRE(values.size() == 64);
        for (std::size_t i = 0; i < 64; ++i) REQUIRE(values[i] == static_cast<float>(i));
    }
};

std::ptrdiff_t descriptorCount() {
    return std::distance(fs::directory_iterator("/proc/self/fd"), fs::directory_iterator{});
}

/// Child processes of this one, running or not yet waited for.
std::size_t childCount() {
    std::size_t count = 0;
    for (const auto& task : fs::directory_iterator("/proc/self/task")) {
        std::ifstream children(task.path() / "children");
        for (pid_t pid = 0; children >> pid;) ++count;
    }
    return count;
}

/// Cancels reading after a moment. Returns the seconds from the cancellation to the end.
double cancelSeconds(const Hostile& hostile, const std::string& instruction) {
    const auto start = Clock::now();
    Clock::time_point asked{};
    const Progress progress = [&](double fraction) {
        CHECK(fraction >= 0.0);
        CHECK(fraction <= 1.0);
        const bool enough = Clock::now() - start > std::chrono::milliseconds(150);
        if (enough && asked == Clock::time_point{}) asked = Clock::now();
        return !enough;
    };
    CHECK_THROWS_AS(hostile.read(instruction, progress), Cancelled);
    return std::chrono::duration<double>(Clock::now() - asked).count();
}

}  // namespace

TEST_CASE("The hostile reader works correctly if it is asked to") {
    const Hostile hostile;
    REQUIRE(hostile.host.readers().size() == 1);
    CHECK(hostile.host.readers()[0]->id == "hostile");
    hostile.requireGood();
}

TEST_CASE("A library that misbehaves while it is loaded is rejected with a reason") {
    const std::pair<const char*, const char*> cases[] = {
        {"constructor throw", "crashed"},
        {"constructor abort", "crashed"},
        {"constructor segfault", ""},
        {"constructor exit", "ended by itself"},
        {"constructor spin", "computed for"},
        {"constructor sleep", "no answer"},
        {"constructor fork", "crashed"},
        {"constructor close", ""},
        {"constructor noise", "malformed"},
        {"entry throw", "threw an exception: boo"},
        {"entry throwInt", "threw an exception"},
        {"entry abort", "crashed"},
        {"entry segfault", ""},
        {"entry exit", "ended by itself"},
        {"entry spin", "computed for"},

        {"entry null", "does not serve ABI"},
        {"entry abi", "ABI 99, this program has ABI 1"},
        {"entry small", "16 bytes"},
        {"entry noId", "no id"},
        {"entry endlessId", ""},
        {"entry noRead", "calls"},
        {"entry nowhere", ""},
    };
    for (const auto& [instruction, reason] : cases) {
        const std::string load = instruction;
        CAPTURE(load);
        const Environment action("NEPH_HOSTILE_LOAD", instruction);
        const PluginHost host(
            std::vector<fs::path>{NEPH_TEST_HOSTILE, fs::path(NEPH_TEST_READER_DIR)}, kLimits);
        REQUIRE(host.rejected().size() == 1);
        CHECK(host.rejected()[0].library == NEPH_TEST_HOSTILE);
        CHECK(!host.rejected()[0].reason.empty());
        INFO(host.rejected()[0].reason);
        if (kMemoryIsLimited) CHECK(contains(host.rejected()[0].reason, reason));
        CHECK(host.readers().size() == readerHost().readers().size());
    }
}

TEST_CASE("A call that throws, crashes, exits or hangs is an error that names the reader") {
    const Hostile hostile;
    const std::string spun = fmt::format("computed for {:.1f} s without", kLimits.silentCpuSeconds);
    for (const std::string call : {"open", "describe", "read"}) {
        for (const std::string action :
             {"throw", "throwInt", "abort", "segfault", "exit", "spin", "fork", "noise"}) {
            CAPTURE(call);
            CAPTURE(action);
            const std::string fault = hostile.fault(call + " " + action);
            INFO(fault);
            CHECK(contains(fault, "reader hostile"));
            if (action == "throw") CHECK(contains(fault, "threw boo"));
            if (action == "spin") CHECK(contains(fault, spun));
            hostile.requireGood();
        }
    }
}

TEST_CASE("A reader that crashes while looking at a file leaves the file to other readers") {
    const Hostile hostile;
    for (const std::string action :
         {"abort", "segfault", "exit", "spin", "sleep", "fork", "close"}) {
        CAPTURE(action);
        CHECK(contains(hostile.fault("score " + action),
                       "reader hostile failed while looking at it"));
        hostile.requireGood();
    }
    CHECK(contains(hostile.fault("score throw"), "no reader knows this format"));
    CHECK(hostile.read("score huge").size() == 64);
    const PluginHost both(std::vector<fs::path>{NEPH_TEST_HOSTILE, fs::path(NEPH_TEST_READER_DIR)});
    CHECK(both.readers().size() == readerHost().readers().size() + 1);
    const fs::path sample =
        fs::path(NEPH_TEST_SOURCE_DIR) / "samples/supercell/wrfout_d01_0001-01-01_01:00:00";
    CHECK(both.pick(sample)->id == "wrf_netcdf");
}

TEST_CASE("A reader that fails while closing a file does no harm") {
    const Hostile hostile;
    for (const std::string action :
         {"throw", "abort", "segfault", "exit", "spin", "sleep", "noise", "close"}) {
        CAPTURE(action);
        CHECK(hostile.read("close " + action).size() == 64);
        hostile.requireGood();
    }
}

TEST_CASE("A reader that closes or truncates what it shares with the program causes an error") {
    const Hostile hostile;
    for (const std::string call : {"open", "describe", "read"}) {
        CAPTURE(call);
        CHECK(contains(hostile.fault(call + " close"), "reader hostile failed while"));
        hostile.requireGood();
        CHECK(hostile.read(call + " truncate").size() == 64);  // sealed memory cannot shrink
    }
}

TEST_CASE("What a reader prints does not appear in the output of the program") {
    const Hostile hostile;
    std::fflush(stdout);
    const fs::path log = hostile.folder / "stdout";
    const int before = dup(STDOUT_FILENO);
    const int file = ::open(log.c_str(), O_CREAT | O_WRONLY, 0600);
    REQUIRE(dup2(file, STDOUT_FILENO) >= 0);
    const Hostile started;
    const std::vector<float> values = started.read("read print");
    dup2(before, STDOUT_FILENO);
    ::close(before);
    ::close(file);
    CHECK(values.size() == 64);
    CHECK(fs::file_size(log) == 0);
}

TEST_CASE("A reader cannot allocate more memory than its limit") {
    if (!kMemoryIsLimited) {
        MESSAGE("skipped: sanitizers do not work with a memory limit");
        return;
    }
    const Hostile hostile({.memoryBytes = kLimits.memoryBytes});
    for (const std::string call : {"open", "describe", "read"}) {
        CAPTURE(call);
        CHECK(contains(hostile.fault(call + " eat"), "not enough memory"));
        hostile.requireGood();
    }
    rusage children{};
    getrusage(RUSAGE_CHILDREN, &children);
    CHECK(static_cast<std::uint64_t>(children.ru_maxrss) * 1024 < kLimits.memoryBytes);
}

TEST_CASE("An invalid description is an error, never a wrong image") {
    const Hostile hostile;
    const std::pair<const char*, const char*> cases[] = {
        {"null", "is null"},
        {"nanSpacing", "grid spacing of nan"},
        {"infiniteSpacing", "grid spacing of inf"},
        {"nanDroplets", "nan cloud droplets"},
        {"nanTime", "not a finite number"},
        {"negativeSize", "size 4 x -4 x 4"},
        {"noSize", "size 4 x 4 x 0"},
        {"hugeSize", "size 2000000000"},
        {"negativeVariable", "size -1 x 4 x 4 of q"},
        {"noTimes", "no times"},
        {"manyTimes", "4000000000 times"},
        {"nullTimes", "null"},
        {"nullTime", "null"},
        {"manyVariables", ""},
        {"wildVariable", ""},
        {"twice", "variable q is there twice"},
        {"nullName", "no name"},
        {"endlessName", ""},
        {"endlessNote", ""},
        {"oldAbi", "ABI 0"},
        {"smallStruct", "4 bytes"},
    };
    for (const auto& [lie, found] : cases) {
        const std::string name = lie;
        CAPTURE(name);
        const std::string fault = hostile.fault(std::string("describe ") + lie);
        INFO(fault);
        CHECK(contains(fault, "reader hostile"));
        CHECK(contains(fault, found));
        hostile.requireGood();
    }
    CHECK(contains(hostile.fault("open noHandle"), "no handle"));
    CHECK(contains(hostile.fault("open badStatus"), "no reason"));
    CHECK(contains(hostile.fault("open endless"), "xxx"));
}

TEST_CASE("The description at opening is used throughout, and optional parts may be missing") {
    const Hostile hostile;
    for (const std::string lie : {"changing", "nullTexts", "strangeScheme", "strangeRole"}) {
        CAPTURE(lie);
        const fs::path path = hostile.file("describe " + lie);
        ReaderFile file(hostile.host.pick(path), path);
        CHECK(file.description().size == glm::ivec3(4));
        CHECK(file.description().microphysics == Microphysics::unknown);
        CHECK(file.read(0, 0, {glm::ivec3(0), glm::ivec3(4)}, {}).size() == 64);
    }
    const fs::path path = hostile.file("describe otherGrid");
    const ReaderFile file(hostile.host.pick(path), path);
    CHECK(file.description().variables[0].role == VariableRole::other);
    REQUIRE(file.description().notes.size() == 2);
    CHECK(contains(file.description().notes[1], "q is not used"));
}

TEST_CASE("A read that misreports what it returned is an error") {
    const Hostile hostile;
    const std::pair<const char*, const char*> cases[] = {
        {"short", "read gave 63 values of q, 64 were asked for"},
        {"long", "read gave 65 values"},
        {"uncounted", "read gave 0 values"},
        {"beyond", "wrote beyond the 64 values asked of q"},
        {"farBeyond", ""},
        {"cancelled", "nobody had asked to"},
        {"failed", "no reason"},
        {"badStatus", "no reason"},
    };
    for (const auto& [lie, found] : cases) {
        const std::string name = lie;
        CAPTURE(name);
        const std::string fault = hostile.fault(std::string("read ") + lie);
        INFO(fault);
        CHECK(contains(fault, "reader hostile"));
        CHECK(contains(fault, found));
        hostile.requireGood();
    }
    CHECK(hostile.read("read before").size() == 64);
    CHECK(hostile.read("read wayBefore").size() == 64);
    hostile.requireGood();
}

TEST_CASE(
    "Values that a reader claims but did not write are missing, not those of an earlier read") {
    const Hostile hostile;
    hostile.requireGood();
    for (float value : hostile.read("read nothing")) CHECK(std::isnan(value));
}

TEST_CASE("Cancelling ends a hang in any call, whether the reader computes or sleeps") {
    const Hostile hostile;
    for (const std::string instruction :
         {"read sleep", "read spinAndTick", "open sleep", "score sleep"}) {
        CAPTURE(instruction);
        CHECK(cancelSeconds(hostile, instruction) < 3.0);  // the reader has two to respond
        hostile.requireGood();
    }
    CHECK(cancelSeconds(hostile, "read sleepAndTick") < 1.5);  // responds itself
    hostile.requireGood();
}

TEST_CASE("A reader that reports progress may take longer than one that is silent") {
    const Hostile hostile;
    const auto start = Clock::now();
    const Progress patience = [&](double) {
        return Clock::now() - start < std::chrono::duration<double>(4 * kLimits.silentCpuSeconds);
    };
    CHECK_THROWS_AS(hostile.read("read spinAndTick", patience), Cancelled);
}

TEST_CASE("Fifty crashes leave no process and no descriptor behind") {
    prctl(PR_SET_CHILD_SUBREAPER, 1);  // orphans of reader processes become our children
    const std::size_t children = childCount();
    const std::ptrdiff_t descriptors = descriptorCount();
    {
        const Hostile hostile;
        for (int i = 0; i < 50; ++i) {
            const char* instructions[] = {"open abort", "read segfault", "read fork", "open throw",
                                          "score exit"};
            hostile.fault(instructions[i % 5]);
        }
        hostile.requireGood();
    }
    // Children of crashed processes are dead by now; collect them.
    while (waitpid(-1, nullptr, WNOHANG) > 0) {
    }
    prctl(PR_SET_CHILD_SUBREAPER, 0);
    CHECK(childCount() == children);
    CHECK(descriptorCount() == descriptors);
}

TEST_CASE("A reader process that dies while idle is replaced without an error") {
    const Hostile hostile;
    const ReaderPlugin& reader = *hostile.host.readers().front();
    auto process = reader.borrow();
    REQUIRE(process->alive());
    std::ifstream children("/proc/self/task/" + std::to_string(gettid()) + "/children");
    pid_t pid = 0, last = 0;
    while (children >> pid) last = pid;
    REQUIRE(last > 0);
    REQUIRE(kill(last, SIGKILL) == 0);
    for (int i = 0; i < 200 && process->alive(); ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    CHECK(!process->alive());
    reader.giveBack(std::move(process));
    hostile.requireGood();
}
