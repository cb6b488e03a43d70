// series_watch.h: notices that the files of a series grow, or that there are new ones.
//
// A thread of its own looks at names, sizes and times of change every few seconds, never into the
// files. What is still changing between two looks is left alone, so that a file is read when its
// writer pauses rather than in the middle of a write; a writer that never pauses is read all the
// same after a while.
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

/// A file as it was seen from outside.
struct FileStamp {
    std::filesystem::path path;
    std::uintmax_t bytes = 0;
    std::filesystem::file_time_type changed{};
    bool operator==(const FileStamp&) const = default;
};

/// Stamps of files, and of the files in folders; those that are not there are left out.
std::vector<FileStamp> stampsOf(std::span<const std::filesystem::path> paths);

class SeriesWatch {
  public:
    /// `wake` is called on the watching thread when a change waits to be taken.
    explicit SeriesWatch(std::function<void()> wake = {},
                         std::chrono::milliseconds interval = std::chrono::seconds(2));
    ~SeriesWatch();
    SeriesWatch(const SeriesWatch&) = delete;
    SeriesWatch& operator=(const SeriesWatch&) = delete;

    /// Watches files and folders from now on, instead of what was watched before. `seen`: the files
    /// as they were when they were read.
    void watch(std::vector<std::filesystem::path> paths, std::vector<FileStamp> seen);
    void stop() { watch({}, {}); }

    /// Looks at once rather than when the interval is over.
    void lookNow();

    /// The files as they are now, once for every change.
    std::optional<std::vector<FileStamp>> takeChange();

  private:
    void run(const std::stop_token& stop);
    void compare(std::vector<FileStamp> now);

    const std::function<void()> wake_;
    const std::chrono::milliseconds interval_;
    std::mutex mutex_;
    std::condition_variable_any asked_;
    std::vector<std::filesystem::path> paths_;  // empty: nothing is watched
    std::vector<FileStamp> told_, lastLook_;    // as last told, and as last seen
    std::optional<std::vector<FileStamp>> change_;
    std::uint64_t generation_ = 0;  // of `paths_`
    int restlessLooks_ = 0;
    bool lookNow_ = false;
    std::jthread watcher_;  // last, so that it ends before what it uses
};

}  // namespace neph
