// session.h: the document of the workbench and the data that it shows.
//
// Look, camera and time are in `document`, which panels change freely. Which part of the domain is
// shown and how much memory it may take are the session's own: undo and presets leave them alone.
// Data come in through a background job; until they are there, and when they fail, the last good
// data stay. When nothing is asked for, the next times are read ahead, and grown files again.
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
#include <vector>

#include "core/base/jobs.h"
#include "core/dataset/dataset.h"
#include "core/dataset/series_watch.h"
#include "core/plugin/plugin_host.h"
#include "core/preset/preset_difference.h"
#include "core/session/history.h"
#include "core/volume/volume_cache.h"

namespace neph {

struct Message {
    enum class Kind { note, warning, error };
    Kind kind = Kind::note;
    std::string text;
    std::uint64_t serial = 0;  ///< counts up from 1
};

/// The time that is shown first: the middle one, since models start without cloud and storms leave
/// the domain.
int defaultTime(const DatasetInfo& info);

/// Opens files and folders as one series, as Dataset::open; called on the worker.
using OpenSeries = std::function<std::shared_ptr<Dataset>(
    std::span<const std::filesystem::path> paths, const Progress& progress)>;

class Session {
  public:
    /// `wake` is called on other threads when there is something for poll(). Files are looked at
    /// for growth every `watchInterval`.
    explicit Session(PluginHost host, std::function<void()> wake = {});
    explicit Session(OpenSeries open, std::function<void()> wake = {},
                     std::chrono::milliseconds watchInterval = std::chrono::seconds(2));

    Document document;
    History history;
    CameraPose homeCamera;            ///< of the preset that was loaded last
    std::vector<Message> messages;    ///< newest last
    std::uint64_t settledSerial = 0;  ///< errors up to here are overcome: other data were opened
    std::string presetName;           ///< last loaded or saved, as presetNameOf; empty before
    Look presetLook;                  ///< of that preset; what is changed is measured against it
    std::optional<CameraPose> presetCamera;
    bool follow = false;  ///< from the last time to a new last one

    /// Opens what the user named: files, folders, or nothing for the bundled storm, as one series
    /// in the background, and shows `time` (negative counts from the end) or the default time, of
    /// `region` or the whole domain. Faults become messages.
    void open(std::span<const std::string> named, std::optional<int> time = {},
              std::optional<Region> region = {});
    /// What was named when the open data were opened; none for the bundled storm.
    const std::vector<std::string>& named() const { return named_; }
    /// Takes over data, document and what is shown from another session, which keeps its own; the
    /// history begins anew.
    void copyFrom(const Session& other);
    /// Takes over look and camera of a preset, or parts of them, as one step of the history. Faults
    /// become messages; false.
    bool loadPreset(const std::string& nameOrFile, PresetParts parts = kPresetAll);
    /// The same with a preset from elsewhere; `label` names the step.
    void takePreset(const LoadedPreset& loaded, PresetParts parts, const std::string& label);
    /// Saves look and camera under a name of the user's; one of that name is replaced if `replace`,
    /// and keeps its words where `text` has none. Faults become messages; false.
    bool savePreset(const std::string& name, bool replace = false,
                    std::optional<PresetText> text = {});
    /// The preset that the document came from, as at the start of the program.
    void setPreset(const std::string& name);

    /// Part of the domain to be shown; none: the whole.
    void setRegion(const std::optional<Region>& region);
    const std::optional<Region>& region() const { return region_; }
    /// Bounds of one volume; `machine` bounds all that are held together as well.
    void setBudget(const MemoryBudget& budget);
    const MemoryBudget& budget() const { return budget_; }

    /// To be called once a frame: takes over what was done in the background, and asks for what
    /// document, region and budget want where that is not what is shown.
    void poll();
    /// Looks for grown files now.
    void lookForGrowth() { watch_.lookNow(); }
    /// A volume to be shown that came in since the last call, for the renderer; else nullptr.
    std::shared_ptr<const SpeciesVolume> takeVolume();

    bool loading() const { return jobs_.busy(); }
    /// Gives up what is being opened or read; what is shown stays.
    void cancelLoading();
    double loadingFraction() const { return jobs_.fraction(); }
    std::string loadingLabel() const { return jobs_.label(); }

    /// Metadata of the open data; nullptr before any.
    const DatasetInfo* info() const { return dataset_ ? &dataset_->info() : nullptr; }
    /// What is shown; nullptr before any.
    const VolumeSummary* shown() const { return shown_ ? &shown_->summary : nullptr; }
    /// The same with the volume.
    const std::shared_ptr<const HeldVolume>& held() const { return shown_; }
    const VolumeCache& cache() const { return cache_; }
    /// Whether a time could be shown at once, and how many could.
    bool holds(int time) const;
    int timesHeld() const;
    /// Whether what is shown is of this time, and as the document, region and budget want it.
    bool shows(int time) const;

    void say(Message::Kind kind, std::string text);
    bool undo();
    bool redo();
    /// Goes to the state after `steps` steps of the history.
    bool jumpTo(std::size_t steps);

  private:
    using Held = std::shared_ptr<const HeldVolume>;

    VolumeKey keyOf(int time) const;
    void read(int time, const VolumeKey& key, Jobs::Kind kind);
    void readFailed(int time, const VolumeKey& key, const Error& error);
    void goBackToShown();
    void want(const VolumeKey& key);
    void show(const VolumeKey& key, const Held& held);
    void keepView(const RegularGrid& before, const RegularGrid& now);
    std::vector<int> timesAhead() const;
    void readAhead();
    void readAgain();
    void adoptGrown(std::shared_ptr<Dataset> grown, std::vector<FileStamp> stamps);
    void adoptTimes(const DatasetInfo& before, const DatasetInfo& now);
    void dropChanged(const DatasetInfo& before, const std::vector<FileStamp>& stamps);
    void sayNew(const std::vector<std::string>& notes, Message::Kind kind = Message::Kind::note);

    OpenSeries open_;
    std::vector<std::string> named_;            // by the user, for the open data
    std::vector<std::filesystem::path> paths_;  // of the open data
    std::vector<FileStamp> stamps_;             // as they were when last read
    std::shared_ptr<Dataset> dataset_;
    std::optional<Region> region_;
    MemoryBudget budget_;
    VolumeCache cache_;

    Held shown_, fresh_;
    std::optional<VolumeKey> shownKey_, readingKey_, failedKey_;
    bool shownStale_ = false;  // its file has changed since it was read
    bool opening_ = false;     // other data are on their way: what is shown now is left alone
    int seenTime_ = 0;         // document.time at the last poll
    int direction_ = 1;        // in which times were stepped through
    bool aheadDone_ = false;
    bool missedLast_ = false;  // the last time could not be read yet, and is to be followed
    std::set<std::string> toldNotes_;
    std::vector<VolumeKey> unreadable_;  // ahead of time; not tried again
    std::optional<std::vector<FileStamp>> grown_;

    std::uint64_t lastSerial_ = 0;
    SeriesWatch watch_;
    Jobs jobs_;  // last, so that the worker ends before what it uses
};

}  // namespace neph
