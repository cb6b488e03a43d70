// series_watch.h: notices when the files of a series grow, or new ones appear.
//
// A separate thread checks names, sizes and modification times every few seconds, never the
// contents. A file that still changes between two checks is left alone, so that it is read when its
// writer pauses rather than in the middle of a write; if a writer never pauses, it is read anyway
// after a while.
#pragma once
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <thread>
#include <vector>

namespace neph {

/// Path, size and modification time of a file at one check.
struct FileStamp {
    std::filesystem::path path;
    std::uintmax_t bytes = 0;
    std::filesystem::file_time_type changed{};
    bool operator==(const FileStamp&) const = default;
};

/// Stamps of files, and of the files in folders; missing ones are left out.
std::vector<FileStamp> stampsOf(std::span<const std::filesystem::path> paths);

/// Watches the files of one series at a time.
class SeriesWatch {
  public:
    /// `wake` is called on the watching thread when a change is ready to be taken.
    explicit SeriesWatch(std::function<void()> wake = {},
                         std::chrono::milliseconds interval = std::chrono::seconds(2));
    ~SeriesWatch();
    SeriesWatch(const SeriesWatch&) = delete;
    SeriesWatch& operator=(const SeriesWatch&) = delete;

    /// Watches these files and folders from now on, instead of the previous ones. `seen`: the files
    /// as they were when they were read.
    void watch(std::vector<std::filesystem::path> paths, std::vector<FileStamp> seen);
    void stop() { watch({}, {}); }

    /// Checks at once instead of waiting for the interval to end.
    void lookNow();

    /// The files as they are now; returned once per change.
    std::optional<std::vector<FileStamp>> takeChange();

  private:
    void run(const std::stop_token& stop);
    void compare(std::vector<FileStamp> now);

    const std::function<void()> wake_;
    const std::chrono::milliseconds interval_;
    std::mutex mutex_;
    std::condition_variable_any asked_;
    std::vector<std::filesystem::path> paths_;  // empty: nothing is watched
    std::vector<FileStamp> told_, lastLook_;    // as last reported, and as last checked
    std::optional<std::vector<FileStamp>> change_;
    std::uint64_t generation_ = 0;  // increases with every change of `paths_`
    int restlessLooks_ = 0;
    bool lookNow_ = false;
    std::jthread watcher_;  // last, so that it ends before the members it uses
};

}  // namespace neph
