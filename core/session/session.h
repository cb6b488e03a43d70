// session.h: the document of the workbench and the data that it shows.
//
// Look, camera and time are in `document`, which panels change freely. Region and memory limit
// belong to the session itself: undo and presets leave them alone. Data are read by a background
// job; until they arrive, and if reading fails, the last good data stay. When nothing is requested,
// the next times are read ahead, and files that have grown are read again.
#pragma once
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/jobs.h"
#include "core/dataset/dataset.h"
#include "core/dataset/ensemble.h"
#include "core/dataset/series_watch.h"
#include "core/grid/boxes.h"
#include "core/look/old_metres.h"
#include "core/plugin/plugin_host.h"
#include "core/preset/preset_difference.h"
#include "core/session/history.h"
#include "core/volume/volume_cache.h"

namespace neph {

/// A message for the user.
struct Message {
    enum class Kind { note, warning, error };
    Kind kind = Kind::note;
    std::string text;
    std::uint64_t serial = 0;  ///< increases from 1
    bool ofTime = false;       ///< about the time that is shown; goes when another is
};

/// The time that is shown first: the middle one, because models start without cloud and storms
/// leave the domain.
int defaultTime(const DatasetInfo& info);

/// Opens files and folders as one series, like Dataset::open; called on the worker.
using OpenSeries = std::function<std::shared_ptr<Dataset>(
    std::span<const std::filesystem::path> paths, const Progress& progress)>;

/// What to open, and what of it to show.
struct OpenRequest {
    std::vector<std::string> named;  ///< files or folders of one series; none: the bundled storm
    bool members = false;            ///< each name is a run of an ensemble, as listMembers takes it
    std::optional<int> time{};       ///< negative counts from the end; none: the default time
    int member = 0;                  ///< or kMeanMember
    std::string memberName{};        ///< in its place, as Ensemble::memberNamed; or empty
    std::optional<BoxM> region{};    ///< none: the whole domain
    bool keepsView = false;          ///< the camera stays whatever the domain
};

/// One document with its data. Used by the main thread; work runs on the threads of its members.
class Session {
  public:
    /// `wake` is called on other threads when poll() has something to do. Files are checked for
    /// growth every `watchInterval`.
    explicit Session(PluginHost host, std::function<void()> wake = {});
    explicit Session(OpenSeries open, std::function<void()> wake = {},
                     std::chrono::milliseconds watchInterval = std::chrono::seconds(2));

    Document document;
    History history;
    CameraPose homeCamera;            ///< of the last loaded preset
    std::vector<Message> messages;    ///< newest last
    std::uint64_t settledSerial = 0;  ///< errors up to here are obsolete: other data were opened
    std::string presetName;           ///< last loaded or saved, as presetNameOf; empty before
    Look presetLook;                  ///< of that preset, to show what has been changed
    std::optional<CameraPose> presetCamera;
    bool follow = false;  ///< moves from the last time to a new last one

    /// Opens files, folders, or the bundled storm if nothing is named, as one series in the
    /// background, and shows `time` (negative counts from the end) or the default time, of `region`
    /// or the whole domain. Errors become messages. With `keepsView` the camera stays whatever the
    /// domain.
    void open(std::span<const std::string> named, std::optional<int> time = {},
              std::optional<BoxM> region = {}, bool keepsView = false);
    /// The same with an ensemble as well.
    void openAs(const OpenRequest& what);
    /// Whether data of another domain were opened since the last call, for which the camera is to
    /// be chosen anew.
    bool takeUnframed() { return std::exchange(unframed_, false); }
    /// The names that the open data were opened with; empty for the bundled storm.
    const std::vector<std::string>& named() const { return named_; }
    /// Whether those are the runs of an ensemble.
    bool namesMembers() const { return members_; }
    /// Copies data, document and what is shown from another session, which keeps its own; the
    /// history starts again.
    void copyFrom(const Session& other);
    /// Applies look and camera of a preset, or parts of them, as one step of the history. Errors
    /// become messages, and the result is false.
    bool loadPreset(const std::string& nameOrFile, PresetParts parts = kPresetAll);
    /// The same with a preset from another source; `label` names the step.
    void takePreset(const LoadedPreset& loaded, PresetParts parts, const std::string& label);
    /// Saves look and camera as a preset of the user; one of that name is replaced if `replace`,
    /// and keeps its title and description if `text` is empty. Errors become messages, and the
    /// result is false.
    bool savePreset(const std::string& name, bool replace = false,
                    std::optional<PresetText> text = {});
    /// Noise scales of the document that a file had in metres: brought to cells of the data, at
    /// once or when there are some.
    void takeMetres(FieldSet fields);
    /// Sets the preset that the document came from, as at the start of the program.
    void setPreset(const std::string& name);

    /// Part of the domain to show; empty: all of it.
    void setRegion(const std::optional<BoxM>& region);
    const std::optional<BoxM>& region() const { return region_; }
    /// Limits of one volume; `machine` also limits all cached volumes together.
    void setBudget(const MemoryBudget& budget);
    const MemoryBudget& budget() const { return budget_; }

    /// Call once per frame: takes the results of background work, and requests what document,
    /// region and budget require if that is not what is shown.
    void poll();
    /// Checks for files that have grown now.
    void lookForGrowth() { watch_.lookNow(); }
    /// A volume to show that arrived since the last call, for the renderer; otherwise nullptr.
    std::shared_ptr<const SpeciesVolume> takeVolume();

    bool loading() const { return jobs_.busy(); }
    /// Cancels opening or reading; what is shown stays.
    void cancelLoading();
    double loadingFraction() const { return jobs_.fraction(); }
    std::string loadingLabel() const { return jobs_.label(); }
    /// Whether data are being opened, not a time of the open data read.
    bool opening() const { return opening_; }

    /// Metadata of the open data; nullptr before the first.
    const DatasetInfo* info() const { return dataset_ ? &dataset_->info() : nullptr; }
    /// The open data, for questions that are answered beside the session through handles of their
    /// own (Dataset::anotherHandle).
    std::shared_ptr<const Dataset> data() const { return dataset_; }
    /// The open data as an ensemble; nullptr where they are a single run.
    const Ensemble* ensemble() const { return dataset_ ? ensembleOf(*dataset_) : nullptr; }
    /// What a volume of the document's look is asked for with; its member is the document's.
    VolumeRequest request() const { return keyOf(document.time).request; }
    /// A volume of the document's time that is in memory, of any member; else nullptr.
    std::shared_ptr<const HeldVolume> heldOf(int member);
    /// What is shown; nullptr before the first.
    const VolumeSummary* shown() const { return shown_ ? &shown_->summary : nullptr; }
    /// Where and when that is, as far as the data state it.
    Whereabouts where() const { return shown_ ? shown_->summary.where : Whereabouts{}; }
    /// The same with its volume.
    const std::shared_ptr<const HeldVolume>& held() const { return shown_; }
    const VolumeCache& cache() const { return cache_; }
    /// Whether a time is cached and can be shown at once, and how many are.
    bool holds(int time) const;
    int timesHeld() const;
    /// Whether what is shown has this time, and matches document, region and budget.
    bool shows(int time) const;

    /// Adds a message, unless it repeats the last one.
    void say(Message::Kind kind, std::string text);
    bool undo();
    bool redo();
    /// Goes to the state after `steps` steps of the history.
    bool jumpTo(std::size_t steps);

  private:
    using Held = std::shared_ptr<const HeldVolume>;

    /// Data that were opened in the background, and the volume to show first.
    struct Opened {
        OpenRequest what;
        MemberList list;
        std::vector<std::filesystem::path> paths;
        std::vector<FileStamp> stamps;
        std::shared_ptr<Dataset> dataset;
        int time = 0;
        VolumeRequest request;
        Held held;
    };
    void take(const Opened& opened);
    VolumeKey keyOf(int time) const { return keyOf(time, document.member); }
    VolumeKey keyOf(int time, int member) const;
    void noteSteps();
    void read(int time, const VolumeKey& key, Jobs::Kind kind);
    void readFailed(int time, const VolumeKey& key, const Error& error);
    void goBackToShown();
    void want(const VolumeKey& key);
    void show(const VolumeKey& key, const Held& held);
    void keepView(const RegularGrid& before, const RegularGrid& now);
    /// A time and a member.
    struct Ahead {
        int time = 0, member = 0;
    };
    std::vector<Ahead> ahead() const;
    void readAhead();
    void readAgain();
    void adoptGrown(std::shared_ptr<Dataset> grown, std::vector<FileStamp> stamps);
    void adoptTimes(const DatasetInfo& before, const DatasetInfo& now);
    void dropChanged(const Dataset& old, const std::vector<FileStamp>& stamps);
    void bringMetres();
    void sayNew(const std::vector<std::string>& notes, Message::Kind kind = Message::Kind::note);
    void sayOfTime(const HeldVolume& held, const VolumeRequest& request);

    OpenSeries open_;
    std::vector<std::string> named_;            // by the user, for the open data
    bool members_ = false;                      // these are the runs of an ensemble
    MemberList memberList_;                     // then: as they were found
    std::vector<std::filesystem::path> paths_;  // of the open data
    std::vector<FileStamp> stamps_;             // as they were when last read
    std::shared_ptr<Dataset> dataset_;
    std::optional<BoxM> region_;
    MemoryBudget budget_;
    VolumeCache cache_;

    Held shown_, fresh_;
    std::optional<VolumeKey> shownKey_, readingKey_, failedKey_;
    Haze saidHaze_ = Haze::fixed;             ///< what the messages about the shown time are for
    bool shownStale_ = false;                 // its file has changed since it was read
    FieldSet metres_ = 0, presetMetres_ = 0;  // of document and presetLook: see takeMetres()
    bool unframed_ = false;
    bool opening_ = false;        // other data are being opened: what is shown now is left alone
    int seenTime_ = 0;            // document.time at the last poll
    int direction_ = 1;           // in which the times, or the members, were stepped through
    int seenMember_ = 0;          // document.member at the last poll
    bool acrossMembers_ = false;  // the last step was from member to member
    bool aheadDone_ = false;
    bool missedLast_ = false;  // the last time could not be read yet and is to be followed
    std::set<std::string> toldNotes_;
    std::vector<VolumeKey> unreadable_;  // failed while reading ahead; not tried again
    std::optional<std::vector<FileStamp>> grown_;

    std::uint64_t lastSerial_ = 0;
    SeriesWatch watch_;
    Jobs jobs_;  // last, so that the worker ends before the members it uses
};

}  // namespace neph
