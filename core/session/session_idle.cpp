// session_idle.cpp: what a session does when nothing is requested: reads the next times ahead, and
// reads files again that have grown.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/session/session.h"

namespace neph {
namespace {

/// Labels identify times: seconds are relative to the first time, which may change.
bool sameTime(const TimeInfo& a, const TimeInfo& b) {
    return a.label == b.label;
}

/// Index in `now` of the time that `before` has at `index`; the nearest one if it is gone.
int movedTime(const DatasetInfo& before, const DatasetInfo& now, int index) {
    const int known = std::clamp(index, 0, static_cast<int>(before.times.size()) - 1);
    const TimeInfo& when = before.times[static_cast<std::size_t>(known)];
    const auto found = std::ranges::find_if(
        now.times, [&](const TimeInfo& other) { return sameTime(when, other); });
    if (found != now.times.end()) return static_cast<int>(found - now.times.begin());
    return std::clamp(index, 0, static_cast<int>(now.times.size()) - 1);
}

/// A file of `before` that exists but is not in `now`; nullptr if there is none.
const TimeInfo* lostFile(const DatasetInfo& before, const DatasetInfo& now) {
    for (const TimeInfo& when : before.times) {
        std::error_code error;
        const bool kept = std::ranges::any_of(
            now.times, [&](const TimeInfo& other) { return other.file == when.file; });
        if (!kept && std::filesystem::exists(when.file, error)) return &when;
    }
    return nullptr;
}

/// The files of the time that a key stands for; none if it is gone.
std::vector<std::filesystem::path> filesOf(const Dataset& dataset, const VolumeKey& key) {
    const auto& times = dataset.info().times;
    const auto found = std::ranges::find_if(times, [&](const TimeInfo& time) {
        return time.indexInFile == key.indexInFile && time.file.string() == key.file;
    });
    if (found == times.end()) return {};
    return dataset.filesAt(static_cast<int>(found - times.begin()));
}

}  // namespace

bool Session::holds(int time) const {
    return dataset_ && cache_.holds(keyOf(time));
}

bool Session::shows(int time) const {
    return dataset_ && shownKey_ == keyOf(time);
}

int Session::timesHeld() const {
    if (!dataset_) return 0;
    int held = 0;
    const int count = static_cast<int>(dataset_->info().times.size());
    for (int time = 0; time < count; ++time) {
        if (cache_.holds(keyOf(time))) ++held;
    }
    return held;
}

std::shared_ptr<const HeldVolume> Session::heldOf(int member) {
    return dataset_ ? cache_.find(keyOf(document.time, member)) : nullptr;
}

/// What to read ahead, the most useful first: as much as memory holds, in the direction of the last
/// step, except that the previous one comes second. After a step from member to member those come
/// before other times; the mean, for which all are read, is read only where it is shown.
std::vector<Session::Ahead> Session::ahead() const {
    const int count = static_cast<int>(dataset_->info().times.size());
    const int members = ensemble() == nullptr ? 1 : ensemble()->count();
    const std::uint64_t each = std::max<std::uint64_t>(1, shown_->volume->bytes());
    const auto most = static_cast<std::uint64_t>(count + members - 1);
    const auto room = static_cast<int>(std::min(most, cache_.limit() / each)) - 1;
    std::vector<Ahead> next;
    const auto addSteps = [&](bool across) {
        const int from = across ? document.member : document.time;
        const int end = across ? members : count;
        const int way = across == acrossMembers_ ? direction_ : 1;
        const auto add = [&](int to) {
            if (to < 0 || to >= end || static_cast<int>(next.size()) >= room) return;
            next.push_back(across ? Ahead{document.time, to} : Ahead{to, document.member});
        };
        add(from + way);
        add(from - way);
        for (int step = 2; step < end; ++step) add(from + step * way);
        for (int step = 2; step < end; ++step) add(from - step * way);
    };
    addSteps(acrossMembers_);
    addSteps(!acrossMembers_);
    return next;
}

/// Starts one volume at a time; poll() calls it again when that is done.
void Session::readAhead() {
    if (aheadDone_ || !shown_ || shownStale_ || keyOf(document.time) != shownKey_) return;
    const std::vector<Ahead> next = ahead();
    const auto keyFor = [this](const Ahead& one) { return keyOf(one.time, one.member); };
    // Touched in reverse order, so that the nearest are dropped last.
    for (auto one = next.rbegin(); one != next.rend(); ++one) cache_.find(keyFor(*one));
    cache_.find(*shownKey_);
    for (const Ahead& one : next) {
        const VolumeKey key = keyFor(one);
        if (cache_.holds(key) || std::ranges::find(unreadable_, key) != unreadable_.end()) continue;
        const Ensemble* runs = ensemble();
        const bool there = runs == nullptr || one.member == kMeanMember ||
                           runs->timeIn(one.member, one.time).has_value();
        if (!there) continue;
        read(one.time, key, Jobs::Kind::ahead);
        return;
    }
    aheadDone_ = true;
}

void Session::readAgain() {
    auto work = [this, open = open_, list = memberList_, paths = paths_,
                 stamps = *grown_](const Progress& progress) {
        std::shared_ptr<Dataset> grown =
            list.members.empty() ? open(paths, progress) : Ensemble::open(list, open, progress);
        return Jobs::Finish([this, grown, stamps] { adoptGrown(grown, stamps); });
    };
    const auto failed = [this](const Error& error) {
        grown_.reset();
        sayNew({"Changed files cannot be read yet and are tried again when they grow: " +
                error.message()});
    };
    jobs_.start("Reading again what has grown", std::move(work), failed, Jobs::Kind::ahead);
}

/// Replaces the data set by the one that was opened again; the old one is kept if a file cannot be
/// read now.
void Session::adoptGrown(std::shared_ptr<Dataset> grown, std::vector<FileStamp> stamps) {
    grown_.reset();
    const std::shared_ptr<Dataset> old = std::exchange(dataset_, std::move(grown));
    const DatasetInfo& before = old->info();
    const DatasetInfo& now = dataset_->info();
    if (const TimeInfo* lost = lostFile(before, now)) {
        sayNew({lost->file.string() + ": cannot be read now; its times stay as they were"});
        dataset_ = old;
        return;
    }
    failedKey_.reset();
    unreadable_.clear();
    aheadDone_ = false;
    dropChanged(*old, stamps);
    stamps_ = std::move(stamps);
    // Members share levels that any of them may have changed.
    if (members_ || now.size != before.size || now.spacingM != before.spacingM ||
        now.edgesM != before.edgesM || now.domain != before.domain) {
        cache_.clear();
        shownStale_ = true;
    }
    sayNew(now.notes);
    adoptTimes(before, now);
}

/// Drops volumes of files that changed. If a file only grew, what it had before stays, except for
/// its last time, which may have been incomplete.
void Session::dropChanged(const Dataset& old, const std::vector<FileStamp>& stamps) {
    const DatasetInfo& before = old.info();
    const auto find = [](const std::vector<FileStamp>& all, const std::string& file) {
        return std::ranges::find_if(all, [&](const FileStamp& s) { return s.path == file; });
    };
    // A nest may have got output at a time that was without, or have been written again.
    const auto nestsChanged = [&](const VolumeKey& key) {
        const std::vector<std::filesystem::path> files = filesOf(old, key);
        if (files != filesOf(*dataset_, key)) return true;
        return std::any_of(files.begin() + (files.empty() ? 0 : 1), files.end(),
                           [&](const std::filesystem::path& file) {
                               const auto was = find(stamps_, file.string());
                               const auto is = find(stamps, file.string());
                               return was == stamps_.end() || is == stamps.end() || *was != *is;
                           });
    };
    const auto changed = [&](const VolumeKey& key) {
        if (key.request.member == kMeanMember) return true;  // any file may be among its own
        const auto was = find(stamps_, key.file), is = find(stamps, key.file);
        // If the data are not in the file itself but in others that it describes, nothing is known:
        // read them again.
        if (was == stamps_.end() || is == stamps.end()) return true;
        if (nestsChanged(key)) return true;
        if (*was == *is) return false;
        if (is->bytes <= was->bytes) return true;
        int last = 0;
        for (const TimeInfo& when : before.times) {
            if (when.file == key.file) last = std::max(last, when.indexInFile);
        }
        return key.indexInFile >= last;
    };
    cache_.drop(changed);
    if (shownKey_ && changed(*shownKey_)) shownStale_ = true;
}

/// The document and its history keep showing the same times, whatever their new index.
void Session::adoptTimes(const DatasetInfo& before, const DatasetInfo& now) {
    const bool atLast = document.time + 1 == static_cast<int>(before.times.size());
    const auto move = [&](Document& state) { state.time = movedTime(before, now, state.time); };
    move(document);
    history.adapt(move);
    const auto added = std::ranges::count_if(now.times, [&](const TimeInfo& when) {
        return std::ranges::none_of(before.times,
                                    [&](const TimeInfo& other) { return sameTime(when, other); });
    });
    if (added > 0) {
        say(Message::Kind::note, fmt::format("{} new time{}, up to {}", added,
                                             added == 1 ? "" : "s", now.times.back().label));
    }
    if (follow && ((added > 0 && atLast) || missedLast_)) {
        document.time = static_cast<int>(now.times.size()) - 1;
    }
    seenTime_ = document.time;
    missedLast_ = false;
}

}  // namespace neph
