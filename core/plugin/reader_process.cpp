// reader_process.cpp: starts, asks and ends a process that runs a reader.
#include "core/plugin/reader_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <ctime>
#include <optional>
#include <system_error>

#include "core/base/error.h"
#include "core/base/resources.h"
#include "core/plugin/plugin_file.h"

extern char** environ;

namespace neph {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kWaitMs = 20;                       // between two checks of progress
constexpr auto kGrace = std::chrono::seconds(2);  // for a cancelled reader to return
constexpr int kLastWordsMs = 1000;                // for one that has closed its socket to exit
constexpr timeval kMostPause{10, 0};              // between two parts of one answer
constexpr int kLowestOwnDescriptor = 16;          // above those that the process inherits

/// For system calls that fail only when the machine is out of resources.
[[noreturn]] void throwSystem(const char* doing) {
    throw Error({.what = fmt::format("cannot run a reader: {} failed: {}", doing,
                                     std::generic_category().message(errno)),
                 .hint = "too many files or processes are open, or memory is short"});
}

/// Moves a descriptor away from the numbers that the process inherits.
int movedUp(int descriptor) {
    const int moved = fcntl(descriptor, F_DUPFD_CLOEXEC, kLowestOwnDescriptor);
    if (moved < 0) throwSystem("fcntl");
    ::close(descriptor);
    return moved;
}

std::filesystem::path readerProgram() {
    std::filesystem::path program = programDir() / "nephoscope-reader";
    if (std::filesystem::exists(program)) return program;
    throw Error({.where = program.string(),
                 .what = "the program that runs readers is missing",
                 .hint = "it is installed beside nephoscope: install again"});
}

/// Processor time that a process has used, seconds; 0 if unknown.
double cpuSeconds(pid_t pid) {
    clockid_t clock{};
    timespec time{};
    if (clock_getcpuclockid(pid, &clock) != 0 || clock_gettime(clock, &time) != 0) return 0.0;
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// How a process ended, in words for the user.
std::string reasonOf(int status) {
    if (WIFSIGNALED(status)) {
        const char* name = sigdescr_np(WTERMSIG(status));
        return fmt::format("it crashed ({})", name != nullptr ? name : "unknown signal");
    }
    return fmt::format("it ended by itself with status {}", WEXITSTATUS(status));
}

wire::Packer question(wire::Ask ask) {
    wire::Packer packer;
    packer.number(ask);
    return packer;
}

}  // namespace

ReaderProcess::ReaderProcess(const std::filesystem::path& library, const ReaderLimits& limits)
    : library_(library), limits_(limits) {
    try {
        start();
        const Task task{library_, "being loaded", limits_.answerSeconds};
        identity_ = unpacked(ask({}, task, {}), task, wire::unpackIdentity);
    } catch (...) {
        end();
        throw;
    }
}

ReaderProcess::~ReaderProcess() {
    end();
}

void ReaderProcess::start() {
    const std::string program = readerProgram().string();
    memory_ = memfd_create("nephoscope-values", MFD_CLOEXEC | MFD_ALLOW_SEALING);
    if (memory_ < 0) throwSystem("memfd_create");
    memory_ = movedUp(memory_);
    // If the library could shrink this memory, the host would crash on its next access.
    if (fcntl(memory_, F_ADD_SEALS, F_SEAL_SHRINK) != 0) throwSystem("fcntl");
    map(kReaderValuesAt);
    std::array<int, 2> pair{};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pair.data()) != 0) {
        throwSystem("socketpair");
    }
    socket_ = pair[0];
    const int theirs = movedUp(pair[1]);
    socket_ = movedUp(socket_);
    setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &kMostPause, sizeof kMostPause);
    const int fault = spawn(program, theirs);
    ::close(theirs);
    if (fault != 0) {
        pid_ = -1;
        errno = fault;
        throwSystem("posix_spawn");
    }
}

/// Starts the program in a process group of its own, so that whatever it starts can be ended with
/// it. Its stdin is empty and its stdout goes to stderr, to keep it out of our output.
int ReaderProcess::spawn(const std::string& program, int theirs) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, theirs, kReaderSocket);
    posix_spawn_file_actions_adddup2(&actions, memory_, kReaderMemory);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes, 0);
    std::string memory = std::to_string(limits_.memoryBytes);
    std::array<char*, 4> arguments{const_cast<char*>(program.c_str()),
                                   const_cast<char*>(library_.c_str()), memory.data(), nullptr};
    const int fault =
        posix_spawn(&pid_, program.c_str(), &actions, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    return fault;
}

/// Resizes the shared memory to `bytes` and maps it.
void ReaderProcess::map(std::size_t bytes) {
    if (ftruncate(memory_, static_cast<off_t>(bytes)) != 0) throwSystem("ftruncate");
    void* at = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, memory_, 0);
    if (at == MAP_FAILED) throwSystem("mmap");
    if (mapped_ != nullptr) munmap(mapped_, mappedBytes_);
    mapped_ = static_cast<std::byte*>(at);
    mappedBytes_ = bytes;
}

/// Memory only grows: the file is sealed against shrinking.
void ReaderProcess::growMemory(std::size_t bytes) {
    if (bytes > mappedBytes_) map(bytes);
}

/// Whether the process has ended by itself. It stays a zombie until end() reaps it.
bool ReaderProcess::hasEnded() const {
    siginfo_t info{};
    const int told = waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT);
    return told != 0 || info.si_pid != 0;
}

/// Ends the process and everything it started; returns how it had ended before that.
std::string ReaderProcess::end() {
    std::string reason = "it broke off its answer";
    if (pid_ > 0) {
        const bool byItself = hasEnded();
        kill(-pid_, SIGKILL);
        int status = 0;
        while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
        }
        if (byItself) reason = reasonOf(status);
        pid_ = -1;
    }
    if (socket_ >= 0) ::close(socket_);
    if (mapped_ != nullptr) munmap(mapped_, mappedBytes_);
    if (memory_ >= 0) ::close(memory_);
    socket_ = memory_ = -1;
    mapped_ = nullptr;
    mappedBytes_ = 0;
    return reason;
}

void ReaderProcess::endAndThrow(const Task& task, std::string reason) {
    end();
    const std::string name = identity_.id.empty() ? library_.filename().string() : identity_.id;
    throw Error({.where = task.file.string(),
                 .what = fmt::format("reader {} failed while {}", name, task.doing),
                 .found = std::move(reason),
                 .hint = task.file == library_
                             ? "report this to the author of the reader"
                             : "the file is probably damaged; other files are not affected"});
}

/// Processor time catches an endless loop, but not a wait for a slow disk.
void ReaderProcess::endIfStuck(const Task& task, double silentCpuSeconds,
                               std::chrono::duration<double> waited) {
    if (silentCpuSeconds > limits_.silentCpuSeconds) {
        endAndThrow(task, fmt::format("it computed for {:.2g} s without a sign of progress",
                                      limits_.silentCpuSeconds));
    }
    if (waited.count() > task.mostSeconds) {
        endAndThrow(task, fmt::format("it gave no answer for {:.2g} s", task.mostSeconds));
    }
}

/// Waits until there is something to receive; false if the process has ended without an answer.
bool ReaderProcess::await(const Task& task, const Progress& progress) {
    auto& control = *reinterpret_cast<ReaderControl*>(mapped_);
    std::uint32_t beatsSeen = std::atomic_ref(control.beats).load();
    double cpuThen = cpuSeconds(pid_);
    const Clock::time_point asked = Clock::now();
    std::optional<Clock::time_point> cancelled;
    for (;;) {
        pollfd waiting{socket_, POLLIN, 0};
        if (poll(&waiting, 1, kWaitMs) > 0) return true;
        // A child of the process may still hold the socket open.
        if (hasEnded()) return poll(&waiting, 1, 0) > 0;
        const std::uint32_t beats = std::atomic_ref(control.beats).load();
        if (beats != beatsSeen) {
            beatsSeen = beats;
            cpuThen = cpuSeconds(pid_);
        }
        if (!cancelled) endIfStuck(task, cpuSeconds(pid_) - cpuThen, Clock::now() - asked);
        const double fraction = std::atomic_ref(control.fraction).load();
        if (!cancelled && !goOn(progress, fraction >= 0.0 ? std::min(fraction, 1.0) : 0.0)) {
            std::atomic_ref(control.cancel).store(1);
            cancelled = Clock::now();
        }
        if (cancelled && Clock::now() - *cancelled > kGrace) {
            end();
            throw Cancelled{};
        }
    }
}

std::string ReaderProcess::ask(std::string_view message, const Task& task,
                               const Progress& progress) {
    if (pid_ <= 0) endAndThrow(task, "its process has ended");
    if (!goOn(progress, 0.0)) throw Cancelled{};
    auto& control = *reinterpret_cast<ReaderControl*>(mapped_);
    std::atomic_ref(control.cancel).store(0);
    std::atomic_ref(control.fraction).store(0.0);
    std::string answer;
    bool there = message.empty() || wire::send(socket_, message);
    if (there) {
        try {
            there = await(task, progress);
        } catch (...) {
            end();  // otherwise its answer would be taken for that to the next question
            throw;
        }
        there = there && wire::receive(socket_, answer);
    }
    if (!there || answer.empty()) {
        for (int ms = 0; ms < kLastWordsMs && !hasEnded(); ms += kWaitMs) poll(nullptr, 0, kWaitMs);
        endAndThrow(task, end());
    }
    const auto kind = static_cast<wire::Answer>(answer.front());
    answer.erase(0, 1);
    if (!goOn(progress, 1.0)) throw Cancelled{};
    if (kind == wire::Answer::ok) return answer;
    if (kind == wire::Answer::failed) throw Error(unpacked(answer, task, wire::unpackError));
    if (kind == wire::Answer::cancelled && std::atomic_ref(control.cancel).load() != 0) {
        throw Cancelled{};
    }
    endAndThrow(task, wire::Malformed().what());
}

/// Unpacks the whole answer; bytes left over are a fault of the process.
template <typename Unpack>
std::invoke_result_t<Unpack, wire::Unpacker&> ReaderProcess::unpacked(std::string_view answer,
                                                                      const Task& task,
                                                                      Unpack&& unpack) {
    try {
        wire::Unpacker from(answer);
        auto result = unpack(from);
        from.end();
        return result;
    } catch (const wire::Malformed& fault) {
        endAndThrow(task, fault.what());
    }
}

int ReaderProcess::score(const std::filesystem::path& file, const Progress& progress) {
    const Task task{file, "looking at it", limits_.answerSeconds};
    const std::string answer =
        ask(question(wire::Ask::score).text(file.native()).take(), task, progress);
    const auto score =
        unpacked(answer, task, [](wire::Unpacker& from) { return from.number<std::int32_t>(); });
    return std::clamp(score, 0, 100);
}

ReaderProcess::Opened ReaderProcess::open(const std::filesystem::path& file,
                                          const Progress& progress,
                                          const std::filesystem::path& map) {
    const Task task{file, "opening it"};
    const std::string answer = ask(
        question(wire::Ask::open).text(file.native()).text(map.native()).take(), task, progress);
    return unpacked(answer, task, [](wire::Unpacker& from) {
        Opened opened;
        opened.handle = from.number<std::uint32_t>();
        opened.description = wire::unpackInfo(from);
        return opened;
    });
}

/// Not cancellable: a closed file is what the next user of the process relies on.
void ReaderProcess::close(std::uint32_t handle) {
    const Task task{library_, "closing a file", limits_.answerSeconds};
    ask(question(wire::Ask::close).number(handle).take(), task, {});
}

std::vector<float> ReaderProcess::read(const wire::ReadRequest& request,
                                       const std::filesystem::path& file, std::string_view variable,
                                       const Progress& progress) {
    const Task task{file, fmt::format("reading {}", variable)};
    const auto size = glm::u64vec3(request.box.size());
    const std::size_t count = size.x * size.y * size.z;
    if (pid_ > 0) growMemory(kReaderValuesAt + (count + PluginFile::kGuardValues) * sizeof(float));
    const std::string answer = ask(
        question(wire::Ask::read).number(request).number(static_cast<std::uint64_t>(count)).take(),
        task, progress);
    if (!answer.empty()) endAndThrow(task, wire::Malformed().what());
    std::vector<float> values(count);
    std::memcpy(values.data(), mapped_ + kReaderValuesAt, count * sizeof(float));
    return values;
}

}  // namespace neph
