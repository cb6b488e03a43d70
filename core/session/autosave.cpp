// autosave.cpp: files and locks (flock, POSIX).
#include "core/session/autosave.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "core/base/error.h"
#include "core/session/session_file.h"

namespace neph {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPrefix = "window-";
constexpr std::time_t kYoungS = 60;  // a younger lock may just have been created by another window

std::time_t timeOf(const fs::path& file) {
    struct stat status {};
    return ::stat(file.c_str(), &status) == 0 ? status.st_mtime : 0;
}

fs::path lockOf(fs::path file) {
    return file.replace_extension(".lock");
}

std::vector<fs::path> filesOf(const fs::path& folder, const char* extension) {
    std::vector<fs::path> files;
    std::error_code error;
    for (const auto& item : fs::directory_iterator(folder, error)) {
        const bool ours = item.path().filename().string().starts_with(kPrefix);
        if (ours && item.path().extension() == extension) files.push_back(item.path());
    }
    return files;
}

/// The lock goes last, so that no other window takes the file in between.
void forget(const fs::path& file) {
    ::unlink(file.c_str());
    ::unlink(lockOf(file).c_str());
}

}  // namespace

FileLock::~FileLock() {
    if (file_ >= 0) ::close(file_);
}

FileLock::FileLock(FileLock&& other) noexcept : file_(std::exchange(other.file_, -1)) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
    std::swap(file_, other.file_);
    return *this;
}

std::optional<FileLock> FileLock::take(const fs::path& file) {
    FileLock lock;
    lock.file_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (lock.file_ < 0 || ::flock(lock.file_, LOCK_EX | LOCK_NB) != 0) return {};
    return lock;
}

Autosave::Autosave(std::optional<fs::path> folder, Clock::duration interval)
    : folder_(std::move(folder)), interval_(interval) {
    if (!folder_) return;
    std::error_code error;
    fs::create_directories(*folder_, error);
    findCrashed();
    openOwn();
}

Autosave::~Autosave() {
    wait();
    std::error_code error;
    if (!file_.empty() && !fs::exists(file_, error)) ::unlink(lockOf(file_).c_str());
}

/// A file whose lock can be taken has no living owner. Locks of other windows without a file are
/// leftovers.
void Autosave::findCrashed() {
    for (const fs::path& file : filesOf(*folder_, ".json")) {
        if (auto lock = FileLock::take(lockOf(file))) {
            crashed_.push_back({{file, timeOf(file)}, std::move(*lock)});
        }
    }
    std::ranges::sort(crashed_, {}, [](const Held& held) { return held.left.savedAt; });
    for (const fs::path& lock : filesOf(*folder_, ".lock")) {  // left by windows that saved nothing
        fs::path file = lock;
        std::error_code error;
        if (fs::exists(file.replace_extension(".json"), error)) continue;
        if (std::time(nullptr) - timeOf(lock) < kYoungS || !FileLock::take(lock)) continue;
        ::unlink(lock.c_str());
    }
}

void Autosave::openOwn() {
    std::string name = (*folder_ / kPrefix).string() + "XXXXXX.lock";
    const int made = ::mkstemps(name.data(), 5);
    const int errorNumber = errno;
    if (made >= 0) ::close(made);
    auto lock = made >= 0 ? FileLock::take(name) : std::nullopt;
    if (!lock) {
        fault_ =
            Error({folder_->string(), "the session cannot be kept there",
                   std::strerror(errorNumber), "",
                   "a crash would lose it; set XDG_STATE_HOME to a folder that can be written"})
                .message();
        return;
    }
    lock_ = std::move(*lock);
    file_ = fs::path(name).replace_extension(".json");
}

void Autosave::tick(const State& state, Clock::time_point now) {
    if (file_.empty()) return;
    if (saving_.valid()) {
        if (saving_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
        noteSaved();
    }
    if (looked_ && now - *looked_ < interval_) return;
    looked_ = now;
    SessionState current = state();
    if (!saved_ && !adopted_) {
        saved_ = std::move(current);
    } else if (adopted_ || *saved_ != current) {
        adoptSaves_ = std::exchange(adopted_, false);
        save(current);
        saved_ = std::move(current);
    }
}

/// On another thread, because flushing to disk may take long.
void Autosave::save(const SessionState& state) {
    saving_ = std::async(std::launch::async, [file = file_, state] { saveSession(file, state); });
}

/// After a save: discards the session that it replaces, or keeps the error message.
void Autosave::noteSaved() {
    try {
        saving_.get();
        written_ = true;
        if (std::exchange(adoptSaves_, false)) discardCrashed();
    } catch (const Error& error) {
        if (error.message() != toldFault_) fault_ = error.message();
        toldFault_ = error.message();
        adopted_ = std::exchange(adoptSaves_, false) || adopted_;
        saved_.emplace();  // differs from every state, so that saving is tried again
    }
}

void Autosave::wait() {
    if (saving_.valid()) noteSaved();
}

void Autosave::finish(const SessionState& state) {
    if (file_.empty()) return;
    wait();
    if (!written_ && (!saved_ || *saved_ == state)) return;
    try {
        saveSession(file_, state);
        std::error_code error;
        fs::rename(file_, *folder_ / "last.json", error);
        if (std::exchange(adopted_, false)) discardCrashed();
    } catch (const Error&) {
        return;  // the last saved state stays and is offered at the next start
    }
    ::unlink(lockOf(file_).c_str());
    file_.clear();
}

std::optional<std::string> Autosave::takeFault() {
    if (fault_.empty()) return {};
    return std::exchange(fault_, {});
}

void Autosave::discardCrashed() {
    if (crashed_.empty()) return;
    forget(crashed_.back().left.file);
    crashed_.pop_back();
}

void Autosave::adoptCrashed() {
    adopted_ = !crashed_.empty();
    looked_.reset();  // check at the next tick
}

std::optional<LeftSession> Autosave::last() const {
    if (!folder_) return {};
    const fs::path file = *folder_ / "last.json";
    std::error_code error;
    if (!fs::exists(file, error)) return {};
    return LeftSession{file, timeOf(file)};
}

}  // namespace neph
