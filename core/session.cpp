// session.cpp: opening, time steps and presets for the workbench.
#include "core/session.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/file_list.h"
#include "core/resample.h"

namespace neph {
namespace {

constexpr std::size_t kMaxMessages = 200;

std::string nameOf(const std::vector<std::filesystem::path>& files) {
    if (files.empty()) return "nothing";
    const std::string first = files.front().filename().string();
    return files.size() == 1 ? first : fmt::format("{} and {} more", first, files.size() - 1);
}

bool hasValue(const Array3f& field) {
    return std::any_of(field.values.begin(), field.values.end(),
                       [](float value) { return value > 0.0f; });
}

}  // namespace

bool ShownVolume::empty() const {
    return std::none_of(anything.begin(), anything.end(), [](bool some) { return some; });
}

ShownVolume summarise(const SpeciesVolume& volume) {
    ShownVolume shown;
    shown.grid = volume.grid;
    shown.timeLabel = volume.timeLabel;
    for (std::size_t s = 0; s < kSpeciesCount; ++s) {
        shown.present[s] = volume.has(static_cast<Species>(s));
        shown.anything[s] =
            hasValue(volume.contentKgPerM3[s]) || hasValue(volume.extinctionPerM[s]);
    }
    return shown;
}

int defaultTime(const DatasetInfo& info) {
    return std::max(0, static_cast<int>(info.times.size()) - 1) / 2;
}

Session::Session(PluginHost host, std::function<void()> wake)
    : host_(std::make_shared<const PluginHost>(std::move(host))), jobs_(std::move(wake)) {}

void Session::open(std::vector<std::filesystem::path> files, std::optional<int> time) {
    std::string label = "Opening " + nameOf(files);
    auto work = [this, host = host_, files = std::move(files), time](const Progress& progress) {
        auto dataset = Dataset::open(
            files, *host, [&progress](double fraction) { return goOn(progress, 0.3 * fraction); });
        const int count = static_cast<int>(dataset->info().times.size());
        const int wanted = time.value_or(defaultTime(dataset->info()));
        const int index = std::clamp(wanted < 0 ? wanted + count : wanted, 0, count - 1);
        auto volume = std::make_shared<SpeciesVolume>(resample(
            *dataset, index, {},
            [&progress](double fraction) { return goOn(progress, 0.3 + 0.7 * fraction); }));
        return Jobs::Finish([this, dataset, index, volume] {
            for (const std::string& note : dataset->info().notes) say(Message::Kind::note, note);
            settledSerial = lastSerial_;
            adopt(dataset, index, std::move(*volume));
            document.time = index;
            history.restart(document);
        });
    };
    wantedTime_ = shownTime_;
    jobs_.start(std::move(label), std::move(work),
                [this](const Error& error) { say(Message::Kind::error, error.message()); });
}

void Session::openNamed(std::span<const std::string> named, std::optional<int> time) {
    try {
        open(listFiles(named), time);
    } catch (const Error& error) {
        say(Message::Kind::error, error.message());
    }
}

void Session::requestTime(int time) {
    wantedTime_ = time;
    const std::string label =
        "Reading " + dataset_->info().times[static_cast<std::size_t>(time)].label;
    auto work = [this, dataset = dataset_, time](const Progress& progress) {
        auto volume = std::make_shared<SpeciesVolume>(resample(*dataset, time, {}, progress));
        return Jobs::Finish(
            [this, dataset, time, volume] { adopt(dataset, time, std::move(*volume)); });
    };
    jobs_.start(label, std::move(work), [this](const Error& error) {
        say(Message::Kind::error, error.message());
        document.time = wantedTime_ = shownTime_;
    });
}

void Session::adopt(std::shared_ptr<Dataset> dataset, int time, SpeciesVolume volume) {
    dataset_ = std::move(dataset);
    shownTime_ = wantedTime_ = time;
    shown_ = summarise(volume);
    for (const std::string& note : volume.notes) say(Message::Kind::note, note);
    if (shown_->empty()) {
        say(Message::Kind::warning,
            fmt::format("{}: there is no hydrometeor at this time", volume.timeLabel));
    }
    fresh_ = std::move(volume);
}

void Session::poll() {
    jobs_.poll();
    if (!dataset_) return;
    const int last = static_cast<int>(dataset_->info().times.size()) - 1;
    document.time = std::clamp(document.time, 0, last);
    if (document.time != wantedTime_) requestTime(document.time);
}

std::optional<SpeciesVolume> Session::takeVolume() {
    std::optional<SpeciesVolume> volume;
    volume.swap(fresh_);
    return volume;
}

void Session::loadPreset(const std::string& nameOrFile) {
    try {
        const std::filesystem::path file = findPreset(nameOrFile);
        LoadedPreset loaded = neph::loadPreset(file);
        for (std::string& warning : loaded.warnings) {
            say(Message::Kind::warning, std::move(warning));
        }
        history.commit(document);
        document.look = loaded.preset.look;
        if (loaded.preset.camera) document.camera = homeCamera = *loaded.preset.camera;
        presetName = file.stem().string();
        history.commit(document, "Preset " + presetName);
        say(Message::Kind::note, "Preset " + presetName);
    } catch (const Error& error) {
        say(Message::Kind::error, error.message());
    }
}

void Session::savePreset(const std::string& name) {
    try {
        const std::filesystem::path file = userPresetFile(name);
        neph::savePreset(file, {name, "", document.look, document.camera});
        presetName = name;
        say(Message::Kind::note, "Saved " + file.string());
    } catch (const Error& error) {
        say(Message::Kind::error, error.message());
    }
}

void Session::say(Message::Kind kind, std::string text) {
    if (!messages.empty() && messages.back().kind == kind && messages.back().text == text) return;
    messages.push_back({kind, std::move(text), ++lastSerial_});
    if (messages.size() > kMaxMessages) messages.erase(messages.begin());
}

bool Session::undo() {
    if (!history.undo(document)) return false;
    say(Message::Kind::note, "Undone: " + history.redoLabel());
    return true;
}

bool Session::redo() {
    if (!history.redo(document)) return false;
    say(Message::Kind::note, "Done again: " + history.undoLabel());
    return true;
}

}  // namespace neph
