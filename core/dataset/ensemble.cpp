// ensemble.cpp: checks that members agree, and matches their times.
#include "core/dataset/ensemble.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/dataset/grid_text.h"

namespace neph {
namespace {

constexpr double kSameTimeS = 0.5;      // models write whole seconds
constexpr std::size_t kMostOpen = 4;    // members whose files stay open
constexpr std::size_t kTimesNamed = 3;  // in a note
constexpr std::size_t kNotesKept = 6;   // of the members after the first

/// The grid that members must share, for messages.
std::string sharedGridText(const DatasetInfo& info) {
    std::string text =
        fmt::format("{} x {} columns of {}", info.size.x, info.size.y, cellWidthText(info));
    if (!info.map.projection.empty()) {
        text += fmt::format(", {} from ({:.6g} m, {:.6g} m)", info.map.projection,
                            info.map.originM.x, info.map.originM.y);
    }
    return text;
}

/// The levels may differ; all else is the same.
bool sameColumns(const DatasetInfo& a, const DatasetInfo& b) {
    return a.size.x == b.size.x && a.size.y == b.size.y && a.spacingM == b.spacingM &&
           a.edgesM == b.edgesM && a.map == b.map;
}

/// Digits at the end of a name, without leading zeros: "3" of "mem03"; empty if there are none.
std::string numberOf(const std::string& name) {
    std::size_t from = name.size();
    while (from > 0 && std::isdigit(static_cast<unsigned char>(name[from - 1])) != 0) --from;
    if (from == name.size()) return {};
    while (from + 1 < name.size() && name[from] == '0') ++from;
    return name.substr(from);
}

bool shareLabel(const std::vector<TimeInfo>& a, const std::vector<TimeInfo>& b) {
    return std::ranges::any_of(a, [&](const TimeInfo& time) {
        return std::ranges::find(b, time.label, &TimeInfo::label) != b.end();
    });
}

/// Seconds from the first member's first time to that of `times`, by a label that both have.
double startOf(const std::vector<TimeInfo>& times, const std::vector<TimeInfo>& first) {
    for (const TimeInfo& time : times) {
        const auto same = std::ranges::find(first, time.label, &TimeInfo::label);
        if (same != first.end()) return same->seconds - time.seconds;
    }
    return 0.0;
}

/// "mem03 lacks 2 of 13 times: a, b."
std::string lackText(const std::string& name, const std::vector<std::string>& labels,
                     std::size_t count) {
    std::vector<std::string> named(
        labels.begin(),
        labels.begin() + static_cast<std::ptrdiff_t>(std::min(labels.size(), kTimesNamed)));
    if (labels.size() > kTimesNamed) named.emplace_back("...");
    return fmt::format("{} lacks {} of {} times: {}.", name, labels.size(), count,
                       fmt::join(named, ", "));
}

}  // namespace

std::shared_ptr<Ensemble> Ensemble::open(const MemberList& list, const OpenRun& openRun,
                                         const Progress& progress) {
    auto made = std::shared_ptr<Ensemble>(new Ensemble);
    const auto count = static_cast<double>(list.members.size());
    for (const MemberFiles& files : list.members) {
        const auto done = static_cast<double>(made->members_.size());
        std::shared_ptr<Dataset> run = openRun(
            files.paths, [&](double share) { return goOn(progress, (done + share) / count); });
        const DatasetInfo& info = run->info();
        if (!made->members_.empty() && !sameColumns(info, made->infoOf(0))) {
            throw Error({.where = files.paths.front().string(),
                         .what = fmt::format("the grid of member {} is not that of {}", files.name,
                                             made->nameOf(0)),
                         .found = sharedGridText(info),
                         .expected = sharedGridText(made->infoOf(0)),
                         .hint = "open runs of one grid; leave out the other members"});
        }
        made->members_.push_back(
            {files.name, std::move(run), std::make_shared<const DatasetInfo>(info), {}});
    }
    made->mergeInfo(list.taken);
    made->matchTimes();
    made->noteTimes();
    return made;
}

std::string Ensemble::nameOf(int member) const {
    return member == kMeanMember ? "mean" : of(member).name;
}

int Ensemble::memberNamed(const std::string& name) const {
    std::vector<int> numbered;
    std::vector<std::string> names;
    for (int member = 0; member < count(); ++member) {
        names.push_back(of(member).name);
        if (names.back() == name) return member;
        if (!name.empty() && numberOf(names.back()) == numberOf(name)) numbered.push_back(member);
    }
    if (name == "mean") return kMeanMember;
    const bool number = !name.empty() && name.find_first_not_of("0123456789") == name.npos;
    if (number && numbered.size() == 1) return numbered.front();
    throw Error({.where = name,
                 .what = "is not the name of one member of the ensemble",
                 .expected = fmt::format("{} or mean", fmt::join(names, ", ")),
                 .hint = "a number stands for the member whose name ends with it"});
}

std::optional<int> Ensemble::timeIn(int member, int time) const {
    const int own = of(member).times.at(static_cast<std::size_t>(time));
    return own < 0 ? std::nullopt : std::optional(own);
}

std::vector<int> Ensemble::membersAt(int time) const {
    std::vector<int> there;
    for (int member = 0; member < count(); ++member) {
        if (timeIn(member, time)) there.push_back(member);
    }
    return there;
}

Error Ensemble::lacking(int member, int time) const {
    const std::vector<TimeInfo>& own = infoOf(member).times;
    return Error({.where = "member " + nameOf(member),
                  .what = fmt::format("has no time {}",
                                      info_.times.at(static_cast<std::size_t>(time)).label),
                  .found = fmt::format("{} times from {} to {}", own.size(), own.front().label,
                                       own.back().label),
                  .hint = "go to another time or member"});
}

/// A handle with nothing open takes the place of one that has not been read for long.
Dataset& Ensemble::run(int member) {
    std::erase(lastRead_, member);
    lastRead_.push_back(member);
    while (lastRead_.size() > kMostOpen) {
        Member& oldest = members_[static_cast<std::size_t>(lastRead_.front())];
        if (auto closed = oldest.run->anotherHandle()) oldest.run = std::move(closed);
        lastRead_.erase(lastRead_.begin());
    }
    return *of(member).run;
}

std::optional<NativeLevels> Ensemble::knownLevels(int time) const {
    const std::lock_guard lock(levels_->mutex);
    const auto found = levels_->found.find(time);
    return found == levels_->found.end() ? std::nullopt : std::optional(found->second);
}

void Ensemble::keepLevels(int time, const NativeLevels& levels) {
    const std::lock_guard lock(levels_->mutex);
    levels_->found[time] = levels;
}

bool Ensemble::has(std::string_view variable, int time) const {
    const int first = membersAt(time).front();
    return of(first).run->has(variable, *timeIn(first, time));
}

Array3f Ensemble::read(std::string_view variable, int time, std::optional<CellBox> box,
                       const Progress& progress) {
    const int first = membersAt(time).front();
    return run(first).read(variable, *timeIn(first, time), box, progress);
}

std::unique_ptr<Dataset> Ensemble::anotherHandle() const {
    auto made = std::unique_ptr<Ensemble>(new Ensemble);
    made->info_ = info_;
    made->levels_ = levels_;
    for (const Member& member : members_) {
        std::shared_ptr<Dataset> run = member.run->anotherHandle();
        if (!run) return nullptr;
        made->members_.push_back({member.name, std::move(run), member.info, member.times});
    }
    return made;
}

/// Everything but the times is as the first member has it, and what others have besides.
void Ensemble::mergeInfo(const std::string& taken) {
    info_ = infoOf(0);
    std::vector<std::string> notes;
    for (int member = 1; member < count(); ++member) {
        const DatasetInfo& own = infoOf(member);
        for (const VariableInfo& variable : own.variables) {
            if (info_.find(variable.name) == nullptr) info_.variables.push_back(variable);
        }
        if (own.scheme != info_.scheme) {
            info_.notes.push_back(
                fmt::format("{} was made with {}, not with {}: particle sizes follow the latter.",
                            nameOf(member), own.scheme.empty() ? "an unknown scheme" : own.scheme,
                            info_.scheme.empty() ? "an unknown one" : info_.scheme));
        }
        for (const std::string& note : own.notes) {
            if (std::ranges::find(infoOf(0).notes, note) == infoOf(0).notes.end()) {
                notes.push_back(fmt::format("{}: {}", nameOf(member), note));
            }
        }
    }
    if (!taken.empty()) info_.notes.insert(info_.notes.begin(), taken);
    const std::size_t kept = std::min(notes.size(), kNotesKept);
    info_.notes.insert(info_.notes.end(), notes.begin(),
                       notes.begin() + static_cast<std::ptrdiff_t>(kept));
    if (kept < notes.size()) {
        info_.notes.push_back(
            fmt::format("Members have {} further notes; nephoscope info RUN shows those of one.",
                        notes.size() - kept));
    }
}

/// Gives the ensemble all times of its members, and each member its own index of them.
void Ensemble::matchTimes() {
    const std::vector<TimeInfo> first = infoOf(0).times;
    std::vector<int> apart;  // members that share no label with the first
    for (int member = 1; member < count(); ++member) {
        if (!shareLabel(infoOf(member).times, first)) apart.push_back(member);
    }
    const bool byLabel = apart.empty();
    if (!byLabel && static_cast<int>(apart.size()) + 1 < count()) {
        const std::vector<TimeInfo>& own = infoOf(apart.front()).times;
        throw Error({.where = "member " + nameOf(apart.front()),
                     .what = fmt::format("shares no time with {}, as others do", nameOf(0)),
                     .found = fmt::format("{} to {}", own.front().label, own.back().label),
                     .expected = fmt::format("{} to {}", first.front().label, first.back().label),
                     .hint = "leave it out"});
    }
    if (!byLabel) {
        info_.notes.emplace_back(
            "The members have no time label in common: their times are matched by the time since "
            "the start of each run.");
    }
    info_.times.clear();
    for (Member& member : members_) {
        const std::vector<TimeInfo>& own = member.info->times;
        const double start = byLabel ? startOf(own, first) : 0.0;
        for (TimeInfo time : own) {
            time.seconds += start;
            const bool known = std::ranges::any_of(info_.times, [&](const TimeInfo& other) {
                return byLabel ? other.label == time.label
                               : std::abs(other.seconds - time.seconds) < kSameTimeS;
            });
            if (!known) info_.times.push_back(std::move(time));
        }
    }
    std::ranges::stable_sort(info_.times, {}, &TimeInfo::seconds);
    for (Member& member : members_) {
        const std::vector<TimeInfo>& own = member.info->times;
        for (const TimeInfo& time : info_.times) {
            const auto same = std::ranges::find_if(own, [&](const TimeInfo& other) {
                return byLabel ? other.label == time.label
                               : std::abs(other.seconds - time.seconds) < kSameTimeS;
            });
            member.times.push_back(same == own.end() ? -1 : static_cast<int>(same - own.begin()));
        }
    }
    const double origin = info_.times.front().seconds;
    for (TimeInfo& time : info_.times) {
        time.seconds -= origin;
        if (byLabel) continue;
        // Label and date of one member would be wrong of the others.
        time.label = "start + " + minutesText(time.seconds);
        time.utc.reset();
    }
}

void Ensemble::noteTimes() {
    for (int member = 0; member < count(); ++member) {
        std::vector<std::string> lacks;
        for (std::size_t time = 0; time < info_.times.size(); ++time) {
            if (of(member).times[time] < 0) lacks.push_back(info_.times[time].label);
        }
        if (lacks.empty()) continue;
        info_.notes.push_back(lackText(nameOf(member), lacks, info_.times.size()));
    }
}

Ensemble* ensembleOf(Dataset& dataset) {
    return dynamic_cast<Ensemble*>(&dataset);
}

const Ensemble* ensembleOf(const Dataset& dataset) {
    return dynamic_cast<const Ensemble*>(&dataset);
}

}  // namespace neph
