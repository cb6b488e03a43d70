// series_watch.cpp: the thread that watches files, and when a change counts as settled.
#include "core/dataset/series_watch.h"

#include <utility>

#include "core/dataset/file_list.h"

namespace neph {
namespace {

constexpr int kMostRestlessLooks = 15;  // half a minute at two seconds per check

}  // namespace

std::vector<FileStamp> stampsOf(std::span<const std::filesystem::path> paths) {
    std::vector<FileStamp> stamps;
    for (const std::filesystem::path& path : filesIn(paths)) {
        std::error_code gone, goneToo;
        FileStamp stamp{path, std::filesystem::file_size(path, gone),
                        std::filesystem::last_write_time(path, goneToo)};
        if (!gone && !goneToo) stamps.push_back(std::move(stamp));
    }
    return stamps;
}

SeriesWatch::SeriesWatch(std::function<void()> wake, std::chrono::milliseconds interval)
    : wake_(std::move(wake)),
      interval_(interval),
      watcher_([this](const std::stop_token& stop) { run(stop); }) {}

SeriesWatch::~SeriesWatch() {
    watcher_.request_stop();
    asked_.notify_all();
}

void SeriesWatch::watch(std::vector<std::filesystem::path> paths, std::vector<FileStamp> seen) {
    const std::lock_guard lock(mutex_);
    paths_ = std::move(paths);
    told_ = lastLook_ = std::move(seen);
    change_.reset();
    restlessLooks_ = 0;
    ++generation_;
    asked_.notify_all();
}

void SeriesWatch::lookNow() {
    const std::lock_guard lock(mutex_);
    lookNow_ = true;
    asked_.notify_all();
}

std::optional<std::vector<FileStamp>> SeriesWatch::takeChange() {
    const std::lock_guard lock(mutex_);
    return std::exchange(change_, {});
}

void SeriesWatch::run(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
        asked_.wait(lock, stop, [this] { return !paths_.empty(); });
        asked_.wait_for(lock, stop, interval_, [this] { return lookNow_; });
        lookNow_ = false;
        if (paths_.empty() || stop.stop_requested()) continue;
        const std::vector<std::filesystem::path> paths = paths_;
        const std::uint64_t generation = generation_;
        lock.unlock();
        std::vector<FileStamp> now = stampsOf(paths);
        lock.lock();
        if (generation == generation_) compare(std::move(now));
        const bool tell = change_.has_value();
        lock.unlock();
        if (tell && wake_) wake_();
        lock.lock();
    }
}

/// Reports a change if the files differ from the last report and have stopped changing, or have not
/// stopped for kMostRestlessLooks checks.
void SeriesWatch::compare(std::vector<FileStamp> now) {
    const bool restless = now != lastLook_;
    lastLook_ = now;
    if (now == told_ || now.empty()) {
        restlessLooks_ = 0;
    } else if (!restless || ++restlessLooks_ >= kMostRestlessLooks) {
        restlessLooks_ = 0;
        told_ = now;
        change_ = std::move(now);
    }
}

}  // namespace neph
