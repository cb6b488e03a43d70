// reader_process.cpp: starting, asking and ending a process that runs a reader.
#include "core/reader_process.h"

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

#include "core/error.h"
#include "core/plugin_file.h"
#include "core/resources.h"

extern char** environ;

namespace neph {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kWaitMs = 20;                       // between two looks at progress
constexpr auto kGrace = std::chrono::seconds(2);  // for a cancelled reader to come back
constexpr double kMostSilentCpuSeconds = 10.0;    // readers report every few megabytes
constexpr int kLowestOwnDescriptor = 16;          // above those that the process inherits

[[noreturn]] void throwSystem(const char* doing) {
    throw Error({.what = fmt::format("cannot start a reader: {} failed: {}", doing,
                                     std::generic_category().message(errno)),
                 .hint = "too many files or processes are open, or memory is short"});
}

/// Moved out of the way of the numbers that the process inherits.
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

/// Processor time that a process has used, seconds; 0 when it cannot be told.
double cpuSeconds(pid_t pid) {
    clockid_t clock{};
    timespec time{};
    if (clock_getcpuclockid(pid, &clock) != 0 || clock_gettime(clock, &time) != 0) return 0.0;
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

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

ReaderProcess::ReaderProcess(const std::filesystem::path& library) : library_(library) {
    start();
    const Task task{library_, "being loaded"};
    try {
        const std::string hello = ask({}, task, {});
        wire::Unpacker from(hello);
        identity_ = wire::unpackIdentity(from);
        from.end();
    } catch (const wire::Malformed& fault) {
        endAndThrow(task, fault.what());
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
    memory_ = memfd_create("nephoscope-values", MFD_CLOEXEC);
    if (memory_ < 0) throwSystem("memfd_create");
    memory_ = movedUp(memory_);
    map(kReaderValuesAt);
    std::array<int, 2> pair{};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pair.data()) != 0) {
        end();
        throwSystem("socketpair");
    }
    socket_ = movedUp(pair[0]);
    const int theirs = movedUp(pair[1]);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, theirs, kReaderSocket);
    posix_spawn_file_actions_adddup2(&actions, memory_, kReaderMemory);
    std::array<char*, 3> arguments{const_cast<char*>(program.c_str()),
                                   const_cast<char*>(library_.c_str()), nullptr};
    const int fault =
        posix_spawn(&pid_, program.c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    ::close(theirs);
    if (fault != 0) {
        pid_ = -1;
        end();
        errno = fault;
        throwSystem("posix_spawn");
    }
}

/// Makes the shared memory `bytes` long and maps it.
void ReaderProcess::map(std::size_t bytes) {
    if (ftruncate(memory_, static_cast<off_t>(bytes)) != 0) throwSystem("ftruncate");
    if (mapped_ != nullptr) munmap(mapped_, mappedBytes_);
    mapped_ = nullptr;
    void* at = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, memory_, 0);
    if (at == MAP_FAILED) throwSystem("mmap");
    mapped_ = static_cast<std::byte*>(at);
    mappedBytes_ = bytes;
}

void ReaderProcess::growMemory(std::size_t bytes) {
    if (bytes > mappedBytes_) map(bytes);
}

/// Ends the process if it still runs and says how it ended.
std::string ReaderProcess::end() {
    std::string reason = "it is not running";
    if (pid_ > 0) {
        int status = 0;
        pid_t gone = 0;
        // One that has closed its socket is about to end by itself: let it say how.
        for (int i = 0; i < 50 && socket_ < 0; ++i) {
            gone = waitpid(pid_, &status, WNOHANG);
            if (gone != 0) break;
            poll(nullptr, 0, kWaitMs);
        }
        if (gone == 0) {
            kill(pid_, SIGKILL);
            while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
            }
        }
        reason = reasonOf(status);
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

/// Waits until there is an answer to receive.
void ReaderProcess::await(const Task& task, const Progress& progress) {
    auto& control = *reinterpret_cast<ReaderControl*>(mapped_);
    std::uint32_t beatsSeen = std::atomic_ref(control.beats).load();
    double cpuThen = cpuSeconds(pid_);
    std::optional<Clock::time_point> cancelled;
    for (;;) {
        pollfd waiting{socket_, POLLIN, 0};
        const int ready = poll(&waiting, 1, kWaitMs);
        if (ready > 0) return;
        const std::uint32_t beats = std::atomic_ref(control.beats).load();
        if (beats != beatsSeen) {
            beatsSeen = beats;
            cpuThen = cpuSeconds(pid_);
        }
        if (cpuSeconds(pid_) - cpuThen > kMostSilentCpuSeconds) {
            endAndThrow(task, fmt::format("it computed for {:.0f} s without a sign of progress",
                                          kMostSilentCpuSeconds));
        }
        const double fraction = std::clamp(std::atomic_ref(control.fraction).load(), 0.0, 1.0);
        if (!cancelled && !goOn(progress, fraction)) {
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
    if (!alive()) endAndThrow(task, "its process has ended");
    if (!goOn(progress, 0.0)) throw Cancelled{};
    auto& control = *reinterpret_cast<ReaderControl*>(mapped_);
    std::atomic_ref(control.cancel).store(0);
    std::atomic_ref(control.fraction).store(0.0);
    std::string answer;
    bool there = message.empty() || wire::send(socket_, message);
    if (there) {
        try {
            await(task, progress);
        } catch (...) {
            end();  // an answer that nobody waits for must not meet the next question
            throw;
        }
        there = wire::receive(socket_, answer);
    }
    if (!there || answer.empty()) {
        ::close(socket_);
        socket_ = -1;
        endAndThrow(task, end());
    }
    const auto kind = static_cast<wire::Answer>(answer.front());
    answer.erase(0, 1);
    if (kind == wire::Answer::cancelled || !goOn(progress, 1.0)) throw Cancelled{};
    if (kind == wire::Answer::ok) return answer;
    wire::Unpacker from(answer);
    throw Error(wire::unpackError(from));
}

int ReaderProcess::score(const std::filesystem::path& file) {
    const Task task{file, "looking at it"};
    const std::string answer = ask(question(wire::Ask::score).text(file.native()).take(), task, {});
    wire::Unpacker from(answer);
    return std::clamp(from.number<std::int32_t>(), 0, 100);
}

ReaderProcess::Opened ReaderProcess::open(const std::filesystem::path& file,
                                          const Progress& progress) {
    const Task task{file, "opening it"};
    const std::string answer =
        ask(question(wire::Ask::open).text(file.native()).take(), task, progress);
    wire::Unpacker from(answer);
    Opened opened;
    opened.handle = from.number<std::uint32_t>();
    opened.description = wire::unpackDescription(from);
    from.end();
    return opened;
}

void ReaderProcess::close(std::uint32_t handle) {
    const Task task{library_, "closing a file"};
    ask(question(wire::Ask::close).number(handle).take(), task, {});
}

std::vector<float> ReaderProcess::read(const wire::ReadRequest& request,
                                       const std::filesystem::path& file, std::string_view variable,
                                       const Progress& progress) {
    const Task task{file, fmt::format("reading {}", variable)};
    const auto size = glm::u64vec3(request.upper - request.lower);
    const std::size_t count = size.x * size.y * size.z;
    if (alive()) growMemory(kReaderValuesAt + (count + PluginFile::kGuardValues) * sizeof(float));
    ask(question(wire::Ask::read).number(request).number(static_cast<std::uint64_t>(count)).take(),
        task, progress);
    std::vector<float> values(count);
    std::memcpy(values.data(), mapped_ + kReaderValuesAt, count * sizeof(float));
    return values;
}

}  // namespace neph
