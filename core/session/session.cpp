// session.cpp: opening and reading data, and showing what was requested.
#include "core/session/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/dataset/file_list.h"
#include "core/look/haze.h"
#include "core/volume/memory_setting.h"
#include "core/volume/native_band.h"

namespace neph {
namespace {

constexpr double kOpenShare = 0.3;  // of the work of opening and reading one time

std::string nameOf(const std::vector<std::filesystem::path>& paths) {
    if (paths.empty()) return "nothing";
    const std::string first = paths.front().filename().string();
    return paths.size() == 1 ? first : fmt::format("{} and {} more", first, paths.size() - 1);
}

/// Keys use file and index, not the position in the series, which changes when files are added. A
/// member has its own; where it lacks the time, and for the mean, the key is of another's.
VolumeKey keyFor(const Dataset& dataset, int time, const VolumeRequest& request) {
    const TimeInfo* when = &dataset.info().times[static_cast<std::size_t>(time)];
    const Ensemble* ensemble = ensembleOf(dataset);
    if (ensemble != nullptr && request.member != kMeanMember) {
        const auto own = ensemble->timeIn(request.member, time);
        const auto& times = ensemble->infoOf(request.member).times;
        if (own) when = &times[static_cast<std::size_t>(*own)];
    }
    return {when->indexInFile, when->file.string(), request};
}

/// The members of `list`, or the one series of `paths` where it has none.
std::shared_ptr<Dataset> openNamed(const OpenSeries& open, const MemberList& list,
                                   const std::vector<std::filesystem::path>& paths,
                                   const Progress& progress) {
    if (list.members.empty()) return open(paths, progress);
    return Ensemble::open(list, open, progress);
}

/// The member of an ensemble that is nearest to what is asked for; 0 of a single run.
int memberIn(const Dataset& dataset, int member) {
    const Ensemble* ensemble = ensembleOf(dataset);
    return ensemble == nullptr ? 0 : std::clamp(member, kMeanMember, ensemble->count() - 1);
}

/// Whether a camera pose shows the same place in both.
bool sameExtent(const RegularGrid& a, const RegularGrid& b) {
    return a.originM == b.originM && a.extentM() == b.extentM();
}

struct Start {
    int time = 0, member = 0;
};

/// What is shown first: where nobody asked for a time, or for a member by name, one that the other
/// has. Throws Error where there is no member of that name.
Start startOf(const Dataset& dataset, const OpenRequest& what) {
    const int count = static_cast<int>(dataset.info().times.size());
    const int wanted = what.time.value_or(defaultTime(dataset.info()));
    Start start{std::clamp(wanted < 0 ? wanted + count : wanted, 0, count - 1),
                memberIn(dataset, what.member)};
    const Ensemble* ensemble = ensembleOf(dataset);
    if (ensemble == nullptr) return start;
    if (!what.memberName.empty()) start.member = ensemble->memberNamed(what.memberName);
    const auto has = [&](int time) {
        return start.member == kMeanMember || ensemble->timeIn(start.member, time).has_value();
    };
    if (has(start.time)) return start;
    if (what.memberName.empty()) {
        start.member = ensemble->membersAt(start.time).front();
    } else if (!what.time) {
        for (start.time = 0; !has(start.time);) ++start.time;
    }
    return start;
}

}  // namespace

int defaultTime(const DatasetInfo& info) {
    return std::max(0, static_cast<int>(info.times.size()) - 1) / 2;
}

Session::Session(PluginHost host, std::function<void()> wake)
    : Session([host = std::make_shared<const PluginHost>(std::move(host))](
                  std::span<const std::filesystem::path> paths,
                  const Progress& progress) { return Dataset::open(paths, *host, progress); },
              std::move(wake)) {}

Session::Session(OpenSeries open, std::function<void()> wake,
                 std::chrono::milliseconds watchInterval)
    : open_(std::move(open)), watch_(wake, watchInterval), jobs_(std::move(wake)) {}

void Session::open(std::span<const std::string> named, std::optional<int> time,
                   std::optional<BoxM> region, bool keepsView) {
    openAs({.named = {named.begin(), named.end()},
            .time = time,
            .region = region,
            .keepsView = keepsView});
}

void Session::openAs(const OpenRequest& what) {
    std::vector<std::filesystem::path> paths;
    MemberList list;
    try {
        if (what.members) list = listMembers(what.named);
        paths = what.members ? pathsOf(list.members) : listFiles(what.named);
    } catch (const Error& error) {
        say(Message::Kind::error, error.message());
        return;
    }
    auto work = [this, open = open_, what, list, paths, budget = budget_,
                 look = document.look](const Progress& progress) {
        Opened opened{what, list, paths, {}, {}, 0, {}, {}};
        opened.stamps = stampsOf(paths);  // before reading, to notice growth
        opened.dataset = openNamed(open, list, paths, [&progress](double share) {
            return goOn(progress, kOpenShare * share);
        });
        const Start start = startOf(*opened.dataset, what);
        opened.time = start.time;
        opened.request = {what.region, budget, planRadii(look, opened.dataset->info()),
                          asksHumidity(look), start.member};
        opened.held = std::make_shared<const HeldVolume>(
            readVolume(*opened.dataset, start.time, opened.request, [&progress](double share) {
                return goOn(progress, kOpenShare + (1.0 - kOpenShare) * share);
            }));
        return Jobs::Finish([this, opened = std::move(opened)] { take(opened); });
    };
    opening_ = true;
    readingKey_.reset();
    jobs_.start("Opening " + nameOf(paths), std::move(work), [this](const Error& error) {
        opening_ = false;
        say(Message::Kind::error, error.message());
    });
}

/// Other data take the place of those that are open.
void Session::take(const Opened& opened) {
    const Held& held = opened.held;
    opening_ = false;
    unframed_ =
        !opened.what.keepsView && !(shown_ && sameExtent(shown_->summary.grid, held->summary.grid));
    dataset_ = opened.dataset;
    named_ = opened.what.named;
    members_ = opened.what.members;
    memberList_ = opened.list;
    paths_ = opened.paths;
    stamps_ = opened.stamps;
    region_ = opened.request.region;
    cache_.clear();
    shown_.reset();
    failedKey_.reset();
    grown_.reset();
    unreadable_.clear();
    toldNotes_.clear();
    missedLast_ = false;
    settledSerial = lastSerial_;
    sayNew(dataset_->info().notes);
    const VolumeKey key = keyFor(*dataset_, opened.time, opened.request);
    cache_.put(key, held);
    show(key, held);
    document.time = seenTime_ = opened.time;
    document.member = seenMember_ = opened.request.member;
    bringMetres();
    history.restart(document);
    watch_.watch(paths_, stamps_);
}

/// Shares the volumes, which are immutable, but opens its own handle of the data.
void Session::copyFrom(const Session& other) {
    document = other.document;
    history.restart(document);
    homeCamera = other.homeCamera;
    presetName = other.presetName;
    presetLook = other.presetLook;
    presetCamera = other.presetCamera;
    metres_ = other.metres_;
    presetMetres_ = other.presetMetres_;
    setBudget(other.budget_);
    std::shared_ptr<Dataset> another =
        other.dataset_ ? other.dataset_->anotherHandle() : std::unique_ptr<Dataset>();
    if (!another || !other.shown_) {
        openAs({.named = other.named_,
                .members = other.members_,
                .time = other.document.time,
                .member = other.document.member,
                .region = other.region_,
                .keepsView = true});
        return;
    }
    dataset_ = std::move(another);
    named_ = other.named_;
    members_ = other.members_;
    memberList_ = other.memberList_;
    paths_ = other.paths_;
    stamps_ = other.stamps_;
    region_ = other.region_;
    cache_ = other.cache_;
    shown_ = fresh_ = other.shown_;
    shownKey_ = other.shownKey_;
    saidHaze_ = other.saidHaze_;
    seenTime_ = document.time;
    seenMember_ = document.member;
    watch_.watch(paths_, stamps_);
}

void Session::setRegion(const std::optional<BoxM>& region) {
    region_ = region;
    failedKey_.reset();
}

void Session::setBudget(const MemoryBudget& budget) {
    budget_ = budget;
    cache_.setLimit(budget.machine);
}

VolumeKey Session::keyOf(int time, int member) const {
    const Look& look = document.look;
    return keyFor(*dataset_, time,
                  {region_, budget_, planRadii(look, dataset_->info()), asksHumidity(look),
                   memberIn(*dataset_, member)});
}

/// Whether the time or the member is another one than at the last call, and in which direction.
void Session::noteSteps() {
    const bool stepped = document.time != seenTime_;
    const bool across = document.member != seenMember_;
    if (!stepped && !across) return;
    acrossMembers_ = across && !stepped;
    const int from = across && !stepped ? seenMember_ : seenTime_;
    const int to = across && !stepped ? document.member : document.time;
    direction_ = to > from ? 1 : -1;
    seenTime_ = document.time;
    seenMember_ = document.member;
    missedLast_ = false;
    aheadDone_ = false;
    failedKey_.reset();
}

void Session::poll() {
    jobs_.poll();
    if (!dataset_) return;
    if (auto change = watch_.takeChange()) grown_ = std::move(change);
    const int last = static_cast<int>(dataset_->info().times.size()) - 1;
    document.time = std::clamp(document.time, 0, last);
    document.member = memberIn(*dataset_, document.member);
    const bool stepped = document.time != seenTime_ || document.member != seenMember_;
    noteSteps();
    if (opening_ && !stepped) return;
    want(keyOf(document.time));
    if (!jobs_.idle()) return;
    if (grown_) {
        readAgain();
    } else {
        readAhead();
    }
}

/// Shows the volume of `key`: at once if it is cached, otherwise when it has been read.
void Session::want(const VolumeKey& key) {
    if ((key == shownKey_ && !shownStale_) || key == failedKey_) {
        if (jobs_.busy() && !opening_) jobs_.cancel();  // the previous request was withdrawn
        // Haze by humidity and by aerosol need the same volume, and can lack different things.
        if (key == shownKey_ && document.look.haze != saidHaze_) sayOfTime(*shown_, key.request);
        return;
    }
    if (const Held held = cache_.find(key)) {
        if (!opening_) jobs_.cancel();
        show(key, held);
    } else if (!jobs_.idle() && readingKey_ == key) {
        jobs_.want();
    } else {
        read(document.time, key, Jobs::Kind::wanted);
    }
}

/// Reads a volume in the background. A finished one is cached even if it is no longer the one
/// requested.
void Session::read(int time, const VolumeKey& key, Jobs::Kind kind) {
    opening_ = false;
    readingKey_ = key;
    std::string label = "Reading " + dataset_->info().times[static_cast<std::size_t>(time)].label;
    if (const Ensemble* runs = ensemble()) label += " of " + runs->nameOf(key.request.member);
    auto work = [this, dataset = dataset_, time, key,
                 known = key.request.humidity ? cache_.find(withHumidity(key, false))
                                              : Held()](const Progress& progress) {
        HeldVolume read = known ? *known : readVolume(*dataset, time, key.request, progress);
        if (known) addHumidity(read, *dataset, time, key.request.member, progress);
        const Held held = std::make_shared<const HeldVolume>(std::move(read));
        return Jobs::Finish([this, key, held] {
            readingKey_.reset();
            aheadDone_ = false;
            cache_.put(key, held);
            if (key == keyOf(document.time)) show(key, held);
        });
    };
    jobs_.start(
        label, std::move(work),
        [this, time, key](const Error& error) { readFailed(time, key, error); }, kind);
}

void Session::cancelLoading() {
    jobs_.cancel();
    opening_ = false;
    readingKey_.reset();
    if (!dataset_) return;
    goBackToShown();
    failedKey_ = keyOf(document.time);
}

/// The view returns to what is shown, so that document and image agree.
void Session::readFailed(int time, const VolumeKey& key, const Error& error) {
    readingKey_.reset();
    unreadable_.push_back(key);
    if (key != keyOf(document.time)) return;  // read ahead: reported when it is requested
    const std::size_t count = dataset_->info().times.size();
    const bool growing = count > 1 && static_cast<std::size_t>(time) + 1 == count;
    missedLast_ = growing && follow;
    if (growing) {  // may still be being written
        say(Message::Kind::warning,
            error.message() + "\n       hint: the last time is tried again when its file grows");
    } else {
        say(Message::Kind::error, error.message());
    }
    failedKey_ = key;
    goBackToShown();
}

/// Requests what is already shown, because nothing else is available.
void Session::goBackToShown() {
    if (!shown_ || !shownKey_) return;
    region_ = shownKey_->request.region;
    const int count = static_cast<int>(dataset_->info().times.size());
    for (int time = 0; time < count; ++time) {
        if (keyFor(*dataset_, time, shownKey_->request) != *shownKey_) continue;
        document.time = seenTime_ = time;
        document.member = seenMember_ = shownKey_->request.member;
        return;
    }
}

/// Makes a volume the one that is shown, and reports what is notable about it.
void Session::show(const VolumeKey& key, const Held& held) {
    if (shown_) keepView(shown_->summary.grid, held->summary.grid);
    // The renderer has it already where the humidity alone is new.
    if (!shown_ || shown_->volume != held->volume) fresh_ = held;
    shown_ = held;
    shownKey_ = key;
    shownStale_ = false;
    failedKey_.reset();
    aheadDone_ = false;
    sayNew(key.request.radii.notes);
    const ReadPlan& plan = held->summary.plan;
    const bool remapped =
        plan.coarsening > 1 || hasUnevenCells(dataset_->info()) || !plan.nested.empty();
    if (remapped) sayNew({describe(plan, dataset_->info())});
    sayOfTime(*held, key.request);
}

/// Poses are relative to the grid that is shown: another part of the same domain must be seen from
/// the same place, now and in every step of the history; and so must the ground by those that are
/// fixed to it, when the grid has moved.
void Session::keepView(const RegularGrid& before, const RegularGrid& now) {
    const bool same = sameExtent(before, now);
    const glm::dvec2 movedM = now.movedM - before.movedM;
    if (same && movedM == glm::dvec2(0.0)) return;
    const auto change = [&](Document& state) {
        if (!same) state.camera = sameView(state.camera, before, now).value_or(homeCamera);
        keepOnGround(state.camera, now, movedM);
        for (Bookmark& bookmark : state.bookmarks) keepOnGround(bookmark.pose, now, movedM);
        keepOnGround(state.path, now, movedM);
    };
    change(document);
    history.adapt(change);
}

std::shared_ptr<const SpeciesVolume> Session::takeVolume() {
    const Held held = std::exchange(fresh_, nullptr);
    return held ? held->volume : nullptr;
}

}  // namespace neph
