// autosave.h: the session kept every few seconds, so that a crash, a kill or a power cut loses
// little.
//
// Each window has a file of its own in the user's state folder, and a lock beside it that the
// system lets go when the program ends, however it ends. A file that nobody holds was left by a
// window that ended unexpectedly; after a proper end the file is renamed to last.json.
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

/// A lock on a file of that name, which is made where it is missing; let go with the object.
class FileLock {
  public:
    FileLock() = default;
    ~FileLock();
    FileLock(FileLock&& other) noexcept;
    FileLock& operator=(FileLock&& other) noexcept;

    /// None where somebody else holds it, or it cannot be made.
    static std::optional<FileLock> take(const std::filesystem::path& file);

  private:
    int file_ = -1;
};

/// A session left behind by a window that is gone.
struct LeftSession {
    std::filesystem::path file;
    std::time_t savedAt = 0;
};

class Autosave {
  public:
    using Clock = std::chrono::steady_clock;
    using State = std::function<SessionState()>;

    /// Looks in `folder` for what was left; none: nothing is kept.
    explicit Autosave(std::optional<std::filesystem::path> folder,
                      Clock::duration interval = std::chrono::seconds(5));
    /// Without finish(): what was saved stays, as after a crash.
    ~Autosave();
    Autosave(const Autosave&) = delete;
    Autosave& operator=(const Autosave&) = delete;

    /// To be called once a frame: asks for the state once an interval, and where it is another than
    /// the one saved last, saves it on a thread of its own. The first state asked for counts as
    /// saved.
    void tick(const State& state, Clock::time_point now);
    /// Until what is being saved is saved.
    void wait();
    /// At a proper end: the session becomes the last one, unless nothing was done.
    void finish(const SessionState& state);
    /// What kept a session from being saved; told once.
    std::optional<std::string> takeFault();

    /// The newest session that was left by a crash; nobody else is offered it while this lives.
    const LeftSession* crashed() const {
        return crashed_.empty() ? nullptr : &crashed_.back().left;
    }
    /// Forgets it.
    void discardCrashed();
    /// It was taken over: forgotten as soon as this window has saved its own.
    void adoptCrashed();
    /// That of the last proper end.
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
    std::filesystem::path file_;  // ours; empty where nothing can be kept
    FileLock lock_;
    std::vector<Held> crashed_;  // oldest first
    std::optional<SessionState> saved_;
    std::optional<Clock::time_point> looked_;
    std::future<void> saving_;
    std::string fault_, toldFault_;
    bool written_ = false;     // since the start
    bool adopted_ = false;     // the newest of crashed_ goes with the next save
    bool adoptSaves_ = false;  // the save under way is the one
};

}  // namespace neph
