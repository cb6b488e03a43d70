// child_process.cpp: fork and exec, non-blocking pipes, and signals.
#include "core/base/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <utility>

#include "core/base/error.h"

extern char** environ;

namespace neph {
namespace {

constexpr auto kGrace = std::chrono::seconds(4);  // for a cancelled program to clean up
constexpr int kWaitMs = 20;                       // between two polls
constexpr std::size_t kMostWords = 4096;          // bytes of stderr that are kept
constexpr int kExecFailed = 127;                  // as a shell reports it

[[noreturn]] void refuse(const std::filesystem::path& program, int errorNumber) {
    throw Error({.where = program.string(),
                 .what = "cannot be started",
                 .found = std::generic_category().message(errorNumber)});
}

/// Both ends of a pipe or socket; the destructor closes those that were not taken.
struct Ends {
    int ours = -1, theirs = -1;
    Ends() = default;
    Ends(const Ends&) = delete;
    Ends& operator=(const Ends&) = delete;
    ~Ends() {
        if (ours >= 0) ::close(ours);
        if (theirs >= 0) ::close(theirs);
    }
    bool openPipe() {
        std::array<int, 2> pair{};
        if (pipe2(pair.data(), O_CLOEXEC) != 0) return false;
        ours = pair[0];
        theirs = pair[1];
        return true;
    }
    /// A socket, because writing to one need not raise SIGPIPE.
    bool openInput() {
        std::array<int, 2> pair{};
        if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pair.data()) != 0) return false;
        ours = pair[0];
        theirs = pair[1];
        return shutdown(ours, SHUT_RD) == 0;
    }
    int takeOurs() { return std::exchange(ours, -1); }
};

/// Runs in the child between fork and exec, where only async-signal-safe calls are allowed. Never
/// returns. A failure of exec is reported through `fault`, as an errno.
[[noreturn]] void become(const char* program, char* const* arguments, const std::array<int, 3>& io,
                         int fault, int niceness, std::optional<pid_t> owner) {
    // A group of its own, so that signals also reach what it starts; and it ends with its owner.
    setpgid(0, 0);
    if (owner) prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (owner && getppid() != *owner) _exit(kExecFailed);  // the owner ended before prctl
    if (niceness != 0 && nice(niceness) == -1) errno = 0;
    for (int i = 0; i < 3; ++i) dup2(io[static_cast<std::size_t>(i)], i);
    execve(program, arguments, environ);
    const int why = errno;
    if (::write(fault, &why, sizeof why) < 0) _exit(kExecFailed);
    _exit(kExecFailed);
}

/// Becomes the shell of letGo(); as `become`, between fork and exec.
[[noreturn]] void keepReading(char* const* arguments, int output, int errors) {
    setpgid(0, 0);
    const int nothing = open("/dev/null", O_RDWR);
    for (int i = 0; i < 3; ++i) dup2(nothing, i);
    // Away from 3 and 4 first, where the one could be in the place of the other.
    const int first = fcntl(output, F_DUPFD_CLOEXEC, 5), second = fcntl(errors, F_DUPFD_CLOEXEC, 5);
    dup2(first, 3);
    dup2(second, 4);
    execve("/bin/sh", arguments, environ);
    _exit(kExecFailed);
}

/// Reads everything available; false at the end of the stream.
bool drain(int descriptor, std::string& to) {
    std::array<char, 4096> some{};
    for (;;) {
        const ssize_t count = ::read(descriptor, some.data(), some.size());
        if (count > 0) {
            to.append(some.data(), static_cast<std::size_t>(count));
        } else if (count == 0 || (errno != EINTR && errno != EAGAIN)) {
            return false;
        } else if (errno == EAGAIN) {
            return true;
        }
    }
}

void close(int& descriptor) {
    if (descriptor >= 0) ::close(descriptor);
    descriptor = -1;
}

}  // namespace

// An empty entry of PATH means the current folder, as in a shell.
std::optional<std::filesystem::path> findProgram(std::string_view name) {
    const char* path = std::getenv("PATH");
    std::string_view rest = path == nullptr ? "/usr/bin:/bin" : path;
    for (bool more = true; more;) {
        const std::size_t colon = rest.find(':');
        const std::string_view folder = rest.substr(0, colon);
        const auto file = std::filesystem::path(folder.empty() ? "." : folder) / name;
        std::error_code none;
        if (std::filesystem::is_regular_file(file, none) && access(file.c_str(), X_OK) == 0) {
            return file;
        }
        more = colon != rest.npos;
        if (more) rest.remove_prefix(colon + 1);
    }
    return {};
}

ChildProcess::ChildProcess(const std::filesystem::path& program,
                           const std::vector<std::string>& arguments, const Options& options) {
    std::string name = program.string();
    std::vector<char*> argv{name.data()};
    for (const std::string& argument : arguments)
        argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    Ends in, out, err, fault;
    in.theirs = options.takesInput ? -1 : open("/dev/null", O_RDONLY | O_CLOEXEC);
    const bool opened = (options.takesInput ? in.openInput() : in.theirs >= 0) && out.openPipe() &&
                        err.openPipe() && fault.openPipe();
    if (!opened) refuse(program, errno);
    const std::optional<pid_t> owner = options.mayOutlive ? std::nullopt : std::optional(getpid());
    pid_ = fork();
    if (pid_ < 0) refuse(program, errno);
    if (pid_ == 0) {
        become(name.c_str(), argv.data(), {in.theirs, out.theirs, err.theirs}, fault.theirs,
               options.niceness, owner);
    }
    ::close(std::exchange(fault.theirs, -1));
    int why = 0;
    ssize_t told = 0;  // EOF once exec has succeeded, an errno where it failed
    while ((told = ::read(fault.ours, &why, sizeof why)) < 0 && errno == EINTR) {
    }
    if (told == sizeof why) {
        waitpid(pid_, nullptr, 0);
        refuse(program, why);
    }
    input_ = in.takeOurs();
    output_ = out.takeOurs();
    errors_ = err.takeOurs();
    for (const int end : {output_, errors_}) fcntl(end, F_SETFL, O_NONBLOCK);
}

ChildProcess::~ChildProcess() {
    if (gone_) return;
    cancel();
    wait();
    closeAll();
}

void ChildProcess::closeAll() {
    for (int* descriptor : {&input_, &output_, &errors_}) close(*descriptor);
}

/// Pipes are closed at their end, so that poll() does not report them again. Only the tail of
/// stderr is kept: it has the error message.
void ChildProcess::takeOutput() {
    if (output_ >= 0 && !drain(output_, unread_)) close(output_);
    if (errors_ >= 0 && !drain(errors_, words_)) close(errors_);
    if (words_.size() > kMostWords) words_.erase(0, words_.size() - kMostWords);
}

/// Its exit is taken before its output: what it printed last is still in the pipes.
void ChildProcess::takeEnd() {
    int status = 0;
    if (status_ || waitpid(pid_, &status, WNOHANG) != pid_) return;
    status_ = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

bool ChildProcess::poll() {
    if (status_ || gone_) return false;
    if (killAt_ && Clock::now() >= *killAt_) kill(-pid_, SIGKILL);
    takeEnd();
    takeOutput();
    if (status_) closeAll();
    return !status_;
}

int ChildProcess::wait() {
    // The timeout matters: a child that closed its pipes may still be running.
    while (poll()) {
        std::array<pollfd, 2> both{pollfd{output_, POLLIN, 0}, pollfd{errors_, POLLIN, 0}};
        ::poll(both.data(), both.size(), kWaitMs);
    }
    return status_.value_or(0);
}

std::vector<std::string> ChildProcess::takeLines() {
    std::vector<std::string> lines;
    for (std::size_t end = unread_.find('\n'); end != unread_.npos; end = unread_.find('\n')) {
        lines.push_back(unread_.substr(0, end));
        unread_.erase(0, end + 1);
    }
    return lines;
}

std::string ChildProcess::lastWords() const {
    return words_.substr(0, words_.find_last_not_of(" \r\n") + 1);
}

void ChildProcess::cancel() {
    if (status_ || killAt_ || gone_) return;
    kill(-pid_, SIGTERM);
    killAt_ = Clock::now() + kGrace;
}

void ChildProcess::end() {
    killAt_ = Clock::now();
    wait();
}

bool ChildProcess::write(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        // Polling drains stdout, without which both sides could wait for each other forever.
        if (!poll() || input_ < 0) return false;
        const ssize_t sent = send(input_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
        if (sent > 0) {
            bytes = bytes.subspan(static_cast<std::size_t>(sent));
        } else if (errno == EAGAIN) {
            pollfd room{input_, POLLOUT, 0};
            ::poll(&room, 1, kWaitMs);
        } else if (errno != EINTR) {
            return false;
        }
    }
    return true;
}

void ChildProcess::letGo(const std::filesystem::path& file) {
    if (status_ || gone_) return;
    std::string name = file.string();
    std::string shell = "sh", option = "-c";
    std::string reads = "cat <&3 >/dev/null & cat <&4 >/dev/null; wait; rm -f -- \"$0\"";
    std::array<char*, 5> argv{shell.data(), option.data(), reads.data(), name.data(), nullptr};
    // The flag belongs to the pipes, and cat would take an empty one for a failure.
    for (const int end : {output_, errors_}) fcntl(end, F_SETFL, 0);
    const pid_t pid = fork();
    if (pid < 0) refuse("/bin/sh", errno);
    if (pid == 0) keepReading(argv.data(), output_, errors_);
    gone_ = true;
    closeAll();
}

void ChildProcess::closeInput() {
    close(input_);
}

}  // namespace neph
