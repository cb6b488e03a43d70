// child_process.h: a program that runs beside this one: its output, its last messages, its exit
// status.
//
// For work that must neither block the window nor take it down when it fails. Only `write` and
// `wait` block; `poll`, called regularly, does the rest. The program ends with the thread that
// started it unless it was let go, and leaves no zombie. POSIX, with PDEATHSIG of Linux.
#pragma once
#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace neph {

/// A program as the shell would find it on $PATH; empty if there is none.
std::optional<std::filesystem::path> findProgram(std::string_view name);

/// A running child process. Owns its pipes; not copyable, because the process has one owner.
class ChildProcess {
  public:
    struct Options {
        int niceness = 0;         ///< added to this program's niceness
        bool takesInput = false;  ///< write() feeds its stdin; otherwise that is empty
        bool mayOutlive = false;  ///< letGo() may be called; it is not ended with its thread
    };

    /// Starts `program`, a path, with `arguments`. Throws Error.
    ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                 const Options& options);
    /// Ends it as cancel() does, and waits for it to end.
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Collects its output and notices its end; true while it runs.
    bool poll();
    /// Polls until it has ended; returns its exit status.
    int wait();

    /// Complete lines of its stdout since the last call, without line ends.
    std::vector<std::string> takeLines();
    /// The end of its stderr, at most 4 KiB, without trailing empty lines.
    std::string lastWords() const;
    /// Empty while it runs; 128 + signal where a signal ended it, as in a shell.
    std::optional<int> status() const { return status_; }

    /// Asks it to end (SIGTERM); polls after four seconds force it (SIGKILL).
    void cancel();

    /// Ends it at once (SIGKILL).
    void end();

    /// Lets it go on when this program ends. A shell reads what it still says, so that it does not
    /// fail for want of a reader, and removes `file` when it has ended. This object knows nothing
    /// of it from then on. Throws Error where no shell can be started.
    void letGo(const std::filesystem::path& file);

    /// Writes all of `bytes` to its stdin, waiting as long as necessary. False when it has ended or
    /// closed its stdin.
    bool write(std::span<const std::byte> bytes);
    /// Closes its stdin: it reads an end of file.
    void closeInput();

  private:
    using Clock = std::chrono::steady_clock;

    void takeOutput();
    void takeEnd();
    void closeAll();

    pid_t pid_ = -1;
    int input_ = -1, output_ = -1, errors_ = -1;
    std::string unread_, words_;  // stdout not yet taken; the end of stderr
    std::optional<int> status_;
    bool gone_ = false;  // let go
    std::optional<Clock::time_point> killAt_;
};

}  // namespace neph
