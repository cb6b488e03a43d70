// hostile_test.cpp: whatever a reader library does, the program gets an error and goes on.
//
// Readers run in a process of their own; hostile/ holds one that does what its file asks for.
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
constexpr double kSlowness = 5.0;         // and take their time to start
#else
constexpr bool kMemoryIsLimited = true;
constexpr double kSlowness = 1.0;
#endif

// Short, so that the tests are; a reader that does its work is far from both.
constexpr ReaderLimits kLimits{.silentCpuSeconds = 0.3 * kSlowness,
                               .answerSeconds = 2.0 * kSlowness,
                               .memoryBytes = std::uint64_t{512} << 20U};

struct Hostile {
    explicit Hostile(const ReaderLimits& limits = kLimits)
        : host(std::vector<fs::path>{NEPH_TEST_HOSTILE}, limits) {}

    TemporaryFolder folder;
    PluginHost host;

    fs::path file(const std::string& words) const {
        fs::path path = folder / (words + ".bad");
        std::ofstream(path) << "HOSTILE " << words;
        return path;
    }
    std::vector<float> read(const std::string& words, const Progress& progress = {}) const {
        const fs::path path = file(words);
        ReaderFile open(host.pick(path, progress), path, progress);
        return open.read(0, 0, glm::ivec3(0), glm::ivec3(4), progress);
    }
    /// What is wrong, in one text; the place is checked.
    std::string fault(const std::string& words) const {
        const ErrorParts parts = errorOf([&] { read(words); });
        CHECK(parts.where == (folder / (words + ".bad")).string());
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

/// Processes that this one has started and not forgotten, whether they run or are dead.
std::size_t childCount() {
    std::size_t count = 0;
    for (const auto& task : fs::directory_iterator("/proc/self/task")) {
        std::ifstream children(task.path() / "children");
        for (pid_t pid = 0; children >> pid;) ++count;
    }
    return count;
}

/// Cancels the reading of `words` after a moment; seconds from then to the end.
double cancelSeconds(const Hostile& hostile, const std::string& words) {
    const auto start = Clock::now();
    Clock::time_point asked{};
    const Progress progress = [&](double fraction) {
        CHECK(fraction >= 0.0);
        CHECK(fraction <= 1.0);
        const bool enough = Clock::now() - start > std::chrono::milliseconds(150);
        if (enough && asked == Clock::time_point{}) asked = Clock::now();
        return !enough;
    };
    CHECK_THROWS_AS(hostile.read(words, progress), Cancelled);
    return std::chrono::duration<double>(Clock::now() - asked).count();
}

}  // namespace

TEST_CASE("The hostile reader reads well when it is asked to") {
    const Hostile hostile;
    REQUIRE(hostile.host.readers().size() == 1);
    CHECK(hostile.host.readers()[0]->id == "hostile");
    hostile.requireGood();
}

TEST_CASE("A library that is faulty while it is loaded is rejected with the reason") {
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
    for (const auto& [words, reason] : cases) {
        const std::string load = words;
        CAPTURE(load);
        const Environment deed("NEPH_HOSTILE_LOAD", words);
        const PluginHost host(
            std::vector<fs::path>{NEPH_TEST_HOSTILE, fs::path(NEPH_TEST_READER_DIR)}, kLimits);
        REQUIRE(host.rejected().size() == 1);
        CHECK(host.rejected()[0].library == NEPH_TEST_HOSTILE);
        CHECK(!host.rejected()[0].reason.empty());
        INFO(host.rejected()[0].reason);
        if (kMemoryIsLimited) CHECK(contains(host.rejected()[0].reason, reason));
        CHECK(host.readers().size() == 2);
    }
}

TEST_CASE("A call that throws, crashes, ends the process or hangs is an error naming the reader") {
    const Hostile hostile;
    const std::string spun = fmt::format("computed for {:.1f} s without", kLimits.silentCpuSeconds);
    for (const std::string stage : {"open", "describe", "read"}) {
        for (const std::string deed :
             {"throw", "throwInt", "abort", "segfault", "exit", "spin", "fork", "noise"}) {
            CAPTURE(stage);
            CAPTURE(deed);
            const std::string fault = hostile.fault(stage + " " + deed);
            INFO(fault);
            CHECK(contains(fault, "reader hostile"));
            if (deed == "throw") CHECK(contains(fault, "threw boo"));
            if (deed == "spin") CHECK(contains(fault, spun));
            hostile.requireGood();
        }
    }
}

TEST_CASE("A reader that does not survive looking at a file leaves the file to others") {
    const Hostile hostile;
    for (const std::string deed : {"abort", "segfault", "exit", "spin", "sleep", "fork", "close"}) {
        CAPTURE(deed);
        CHECK(
            contains(hostile.fault("score " + deed), "reader hostile failed while looking at it"));
        hostile.requireGood();
    }
    CHECK(contains(hostile.fault("score throw"), "no reader knows this format"));
    CHECK(hostile.read("score huge").size() == 64);
    const PluginHost both(std::vector<fs::path>{NEPH_TEST_HOSTILE, fs::path(NEPH_TEST_READER_DIR)});
    CHECK(both.readers().size() == 3);
    const fs::path sample =
        fs::path(NEPH_TEST_SOURCE_DIR) / "samples/supercell/wrfout_d01_0001-01-01_01:00:00";
    CHECK(both.pick(sample)->id == "wrf_netcdf");
}

TEST_CASE("A reader that fails to close a file harms nobody") {
    const Hostile hostile;
    for (const std::string deed :
         {"throw", "abort", "segfault", "exit", "spin", "sleep", "noise", "close"}) {
        CAPTURE(deed);
        CHECK(hostile.read("close " + deed).size() == 64);
        hostile.requireGood();
    }
}

TEST_CASE("A reader that closes or cuts off what it shares with the program gives an error") {
    const Hostile hostile;
    for (const std::string stage : {"open", "describe", "read"}) {
        CAPTURE(stage);
        CHECK(contains(hostile.fault(stage + " close"), "reader hostile failed while"));
        hostile.requireGood();
        CHECK(hostile.read(stage + " truncate").size() == 64);  // what is sealed stays
    }
}

TEST_CASE("What a reader prints is no output of the program") {
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

TEST_CASE("A reader that eats memory gets no more than its limit") {
    if (!kMemoryIsLimited) {
        MESSAGE("skipped: sanitizers know no limit of memory");
        return;
    }
    const Hostile hostile({.memoryBytes = kLimits.memoryBytes});
    for (const std::string stage : {"open", "describe", "read"}) {
        CAPTURE(stage);
        CHECK(contains(hostile.fault(stage + " eat"), "not enough memory"));
        hostile.requireGood();
    }
    rusage children{};
    getrusage(RUSAGE_CHILDREN, &children);
    CHECK(static_cast<std::uint64_t>(children.ru_maxrss) * 1024 < kLimits.memoryBytes);
}

TEST_CASE("A description that lies is an error and no wrong picture") {
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
        const std::string told = lie;
        CAPTURE(told);
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

TEST_CASE("A description counts as it was when the file was opened; what may be missing may") {
    const Hostile hostile;
    for (const std::string lie : {"changing", "nullTexts", "strangeScheme", "strangeRole"}) {
        CAPTURE(lie);
        const fs::path path = hostile.file("describe " + lie);
        ReaderFile file(hostile.host.pick(path), path);
        CHECK(file.description().size == glm::ivec3(4));
        CHECK(file.description().microphysics == NEPH_MICROPHYSICS_UNKNOWN);
        CHECK(file.read(0, 0, glm::ivec3(0), glm::ivec3(4), {}).size() == 64);
    }
    const fs::path path = hostile.file("describe otherGrid");
    const ReaderFile file(hostile.host.pick(path), path);
    CHECK(file.description().variables[0].role == NEPH_ROLE_OTHER);
    REQUIRE(file.description().notes.size() == 2);
    CHECK(contains(file.description().notes[1], "q is not used"));
}

TEST_CASE("A read that lies about what it gave is an error") {
    const Hostile hostile;
    const std::pair<const char*, const char*> cases[] = {
        {"short", "read gave 63 values of q, 64 were asked for"},
        {"long", "read gave 65 values"},
        {"untold", "read gave 0 values"},
        {"beyond", "wrote beyond the 64 values asked of q"},
        {"farBeyond", ""},
        {"cancelled", "nobody had asked to"},
        {"failed", "no reason"},
        {"badStatus", "no reason"},
    };
    for (const auto& [lie, found] : cases) {
        const std::string told = lie;
        CAPTURE(told);
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
    "Values that a reader claims and has not written are missing, not those of a read before") {
    const Hostile hostile;
    hostile.requireGood();
    for (float value : hostile.read("read nothing")) CHECK(std::isnan(value));
}

TEST_CASE("Cancelling ends a hang in any call, whether it computes or sleeps") {
    const Hostile hostile;
    for (const std::string words :
         {"read sleep", "read spinAndTick", "open sleep", "score sleep"}) {
        CAPTURE(words);
        CHECK(cancelSeconds(hostile, words) < 3.0);  // two of grace
        hostile.requireGood();
    }
    CHECK(cancelSeconds(hostile, "read sleepAndTick") < 1.5);  // heeds it
    hostile.requireGood();
}

TEST_CASE("A reader that says how far it is may take longer than one that is silent") {
    const Hostile hostile;
    const auto start = Clock::now();
    const Progress patience = [&](double) {
        return Clock::now() - start < std::chrono::duration<double>(4 * kLimits.silentCpuSeconds);
    };
    CHECK_THROWS_AS(hostile.read("read spinAndTick", patience), Cancelled);
}

TEST_CASE("Fifty crashes leave no process and no descriptor behind") {
    prctl(PR_SET_CHILD_SUBREAPER, 1);  // what a reader process leaves behind becomes ours
    const std::size_t children = childCount();
    const std::ptrdiff_t descriptors = descriptorCount();
    {
        const Hostile hostile;
        for (int i = 0; i < 50; ++i) {
            const char* words[] = {"open abort", "read segfault", "read fork", "open throw",
                                   "score exit"};
            hostile.fault(words[i % 5]);
        }
        hostile.requireGood();
    }
    // What a crashed process had started is dead, and becomes ours to forget.
    while (waitpid(-1, nullptr, WNOHANG) > 0) {
    }
    prctl(PR_SET_CHILD_SUBREAPER, 0);
    CHECK(childCount() == children);
    CHECK(descriptorCount() == descriptors);
}

TEST_CASE("A process that dies while nobody asks it is replaced unseen") {
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
