// child_process.h: a program that runs beside this one: its lines, its last words, its end.
//
// For work that must neither hold up the window nor take it along when it fails. Nothing here waits
// but `write` and `wait`; `poll`, called now and then, does the rest. The program ends with the
// thread that started it, and leaves no zombie. POSIX, with PDEATHSIG of Linux.
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

/// A program as the shell would find it on $PATH; none where there is none.
std::optional<std::filesystem::path> findProgram(std::string_view name);

class ChildProcess {
  public:
    struct Options {
        int niceness = 0;         ///< added to this program's own
        bool takesInput = false;  ///< what is given to write(); else it reads nothing
    };

    /// Starts `program`, a path, with `arguments`. Throws Error.
    ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                 const Options& options);
    /// Ends it as cancel() does, and waits for that.
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Takes in what it has printed and whether it has ended; true while it runs.
    bool poll();
    /// Polls until it has ended; returns its status.
    int wait();

    /// Whole lines of its stdout since the last call, without their ends.
    std::vector<std::string> takeLines();
    /// The end of its stderr, at most 4 KiB, without empty lines at its end.
    std::string lastWords() const;
    /// None while it runs; 128 + signal where a signal ended it, as a shell has it.
    std::optional<int> status() const { return status_; }

    /// Asks it to end (SIGTERM); polls after four seconds make it (SIGKILL).
    void cancel();

    /// Ends it at once (SIGKILL).
    void end();

    /// Gives it all of `bytes` to read, waiting as long as it takes. False when it has ended or
    /// closed its input.
    bool write(std::span<const std::byte> bytes);
    /// No more to read.
    void closeInput();

  private:
    using Clock = std::chrono::steady_clock;

    void takeOutput();
    void takeEnd();
    void closeAll();

    pid_t pid_ = -1;
    int input_ = -1, output_ = -1, errors_ = -1;
    std::string unread_, words_;  // stdout that was not taken; the end of stderr
    std::optional<int> status_;
    std::optional<Clock::time_point> killAt_;
};

}  // namespace neph
