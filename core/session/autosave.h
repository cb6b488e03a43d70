// autosave.h: saves the session every few seconds, so that a crash, a kill or a power cut loses
// little.
//
// Each window has its own file in the user's state folder, and beside it a lock that the system
// releases when the program ends, however it ends. A file without a holder was left by a window
// that ended unexpectedly; after a normal exit the file is renamed to last.json.
#pragma once
#include <chrono>
#include <ctime>
#include <filesystem>
#include <functional>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include "core/session/session_state.h"

namespace neph {

/// A lock on a file, which is created if missing; released with the object.
class FileLock {
  public:
    FileLock() = default;
    ~FileLock();
    FileLock(FileLock&& other) noexcept;
    FileLock& operator=(FileLock&& other) noexcept;

    /// Empty if another process holds the lock, or the file cannot be created.
    static std::optional<FileLock> take(const std::filesystem::path& file);

  private:
    int file_ = -1;
};

/// A saved session of a window that no longer exists.
struct LeftSession {
    std::filesystem::path file;
    std::time_t savedAt = 0;
};

/// Saves the session of one window, and finds those that crashed windows left.
class Autosave {
  public:
    using Clock = std::chrono::steady_clock;
    using State = std::function<SessionState()>;

    /// Searches `folder` for sessions left by a crash; without a folder nothing is saved.
    explicit Autosave(std::optional<std::filesystem::path> folder,
                      Clock::duration interval = std::chrono::seconds(5));
    /// Without finish() the saved file stays, as after a crash.
    ~Autosave();
    Autosave(const Autosave&) = delete;
    Autosave& operator=(const Autosave&) = delete;

    /// Call once per frame: gets the state once per interval and, if it differs from the one last
    /// saved, saves it on another thread. The first state counts as saved.
    void tick(const State& state, Clock::time_point now);
    /// Waits until a save in progress has finished.
    void wait();
    /// At a normal exit: the session becomes the last one, unless nothing was changed.
    void finish(const SessionState& state);
    /// Why a session could not be saved; returned once.
    std::optional<std::string> takeFault();

    /// The newest session left by a crash; while this object exists, no other window is offered it.
    const LeftSession* crashed() const {
        return crashed_.empty() ? nullptr : &crashed_.back().left;
    }
    /// Deletes it.
    void discardCrashed();
    /// It was opened here: deleted as soon as this window has saved its own session.
    void adoptCrashed();
    /// The session of the last normal exit.
    std::optional<LeftSession> last() const;

  private:
    struct Held {
        LeftSession left;
        FileLock lock;
    };

    void findCrashed();
    void openOwn();
    void save(const SessionState& state);
    void noteSaved();

    std::optional<std::filesystem::path> folder_;
    Clock::duration interval_;
    std::filesystem::path file_;  // our file; empty if nothing can be saved
    FileLock lock_;
    std::vector<Held> crashed_;  // oldest first
    std::optional<SessionState> saved_;
    std::optional<Clock::time_point> looked_;
    std::future<void> saving_;
    std::string fault_, toldFault_;
    bool written_ = false;     // something was saved since the start
    bool adopted_ = false;     // delete the newest of crashed_ with the next save
    bool adoptSaves_ = false;  // the save in progress is that one
};

}  // namespace neph
