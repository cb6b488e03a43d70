// session.h: the document of the workbench and the data that it shows.
//
// Look, camera and time are in `document`, which panels change freely. Data come in through a
// background job; until they are there, and when they fail, the last good data stay.
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/dataset.h"
#include "core/history.h"
#include "core/jobs.h"
#include "core/plugin_host.h"
#include "core/preset.h"
#include "core/species.h"

namespace neph {

struct Message {
    enum class Kind { note, warning, error };
    Kind kind = Kind::note;
    std::string text;
    std::uint64_t serial = 0;  ///< counts up from 1
};

/// What is kept of the volume that the renderer has been given.
struct ShownVolume {
    RegularGrid grid;
    std::array<bool, kSpeciesCount> present{};   ///< the model has the species
    std::array<bool, kSpeciesCount> anything{};  ///< ... and some of it is not zero
    std::string timeLabel;
    bool empty() const;  ///< no hydrometeor anywhere
};

/// The summary of a volume.
ShownVolume summarise(const SpeciesVolume& volume);

/// The time that is shown first: the middle one, since models start without cloud and storms leave
/// the domain.
int defaultTime(const DatasetInfo& info);

class Session {
  public:
    /// `wake` is called on the worker thread when data wait for poll().
    explicit Session(PluginHost host, std::function<void()> wake = {});

    Document document;
    History history;
    CameraPose homeCamera;            ///< of the preset that was loaded last
    std::vector<Message> messages;    ///< newest last
    std::uint64_t settledSerial = 0;  ///< errors up to here are overcome: other data were opened
    std::string presetName;           ///< last loaded or saved; empty before

    /// Opens files as one series in the background and shows `time` (negative counts
    /// from the end), or the default time.
    void open(std::vector<std::filesystem::path> files, std::optional<int> time = {});
    /// Opens what the user named: files, folders, or nothing for the bundled storm. Faults become
    /// messages.
    void openNamed(std::span<const std::string> named, std::optional<int> time = {});
    /// Takes over look and camera of a preset as one step of the history. Faults become messages.
    void loadPreset(const std::string& nameOrFile);
    /// Saves look and camera under a name of the user's. Faults become messages.
    void savePreset(const std::string& name);

    /// To be called once a frame: takes over what the worker has done, and asks it for
    /// `document.time` where that is not what is shown.
    void poll();
    /// A volume that came in since the last call, for the renderer.
    std::optional<SpeciesVolume> takeVolume();

    bool loading() const { return jobs_.busy(); }
    double loadingFraction() const { return jobs_.fraction(); }
    std::string loadingLabel() const { return jobs_.label(); }

    /// Metadata of the open data; nullptr before any.
    const DatasetInfo* info() const { return dataset_ ? &dataset_->info() : nullptr; }
    const std::optional<ShownVolume>& shown() const { return shown_; }

    void say(Message::Kind kind, std::string text);
    bool undo();
    bool redo();

  private:
    void adopt(std::shared_ptr<Dataset> dataset, int time, SpeciesVolume volume);
    void requestTime(int time);

    std::shared_ptr<const PluginHost> host_;
    std::shared_ptr<Dataset> dataset_;
    std::optional<ShownVolume> shown_;
    std::optional<SpeciesVolume> fresh_;
    std::uint64_t lastSerial_ = 0;
    int shownTime_ = -1;
    int wantedTime_ = -1;
    Jobs jobs_;  // last, so that the worker ends before what it uses
};

}  // namespace neph
