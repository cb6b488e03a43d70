// dataset.cpp: merges files into one series and reads from the file that contains a time.
#include "core/dataset/dataset.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/names.h"
#include "core/dataset/header_cache.h"
#include "core/dataset/nested_dataset.h"
#include "core/dataset/series.h"
#include "core/plugin/reader_file.h"

namespace neph {
namespace {

namespace fs = std::filesystem;

/// What a data set keeps about one of its files.
struct KnownFile {
    fs::path path;
    std::map<std::string, std::size_t, std::less<>> variables;  ///< index in the file, by name
};

/// A data set that reads through a reader plugin. One file is open at a time, because series are
/// read time by time.
class SeriesDataset : public Dataset {
  public:
    explicit SeriesDataset(const Series& series);
    bool has(std::string_view variable, int time) const override;
    Array3f read(std::string_view variable, int time, std::optional<CellBox> box,
                 const Progress& progress) override;
    std::unique_ptr<Dataset> anotherHandle() const override {
        return std::unique_ptr<Dataset>(new SeriesDataset(info_, reader_, files_));
    }

  private:
    using KnownFiles = std::vector<KnownFile>;
    SeriesDataset(const DatasetInfo& info, std::shared_ptr<const ReaderPlugin> reader,
                  std::shared_ptr<const KnownFiles> files)
        : reader_(std::move(reader)), files_(std::move(files)) {
        info_ = info;
    }
    void mergeVariables(const DatasetInfo& file);
    void sortTimes();
    const KnownFile& fileOf(const TimeInfo& when) const;
    ReaderFile& opened(const KnownFile& file, const Progress& progress);
    void requireUnchanged(const DatasetInfo& now, const TimeInfo& when, std::string_view variable,
                          std::size_t index) const;
    Error missing(const TimeInfo& when, const KnownFile& file, std::string_view variable) const;

    std::shared_ptr<const ReaderPlugin> reader_;
    std::shared_ptr<const KnownFiles> files_;  ///< shared by all handles
    std::unique_ptr<ReaderFile> open_;         ///< the file that was read last, still open
    fs::path openPath_;
};

SeriesDataset::SeriesDataset(const Series& series) : reader_(series.reader) {
    info_ = series.files.front().description;
    info_.reader = reader_->id;
    info_.times.clear();
    auto files = std::make_shared<KnownFiles>();
    for (const SeriesFile& file : series.files) {
        const DatasetInfo& described = file.description;
        mergeVariables(described);
        for (std::size_t i = 0; i < described.times.size(); ++i) {
            info_.times.push_back(described.times[i]);
            info_.times.back().file = file.path;
        }
        if (described.scheme != info_.scheme) {
            info_.notes.push_back(
                fmt::format("{} was made with {}, not with {}: particle sizes follow the latter.",
                            file.path.filename().string(),
                            described.scheme.empty() ? "an unknown scheme" : described.scheme,
                            info_.scheme.empty() ? "an unknown one" : info_.scheme));
        }
        for (const std::string& note : described.notes) {
            if (std::ranges::find(info_.notes, note) == info_.notes.end()) {
                info_.notes.push_back(note);
            }
        }
        KnownFile kept{file.path, {}};
        for (std::size_t i = 0; i < described.variables.size(); ++i) {
            kept.variables[described.variables[i].name] = i;
        }
        files->push_back(std::move(kept));
    }
    files_ = std::move(files);
    sortTimes();
    info_.notes.insert(info_.notes.end(), series.notes.begin(), series.notes.end());
}

/// A variable that only some files have is listed; reading it at another time is an error, and
/// `has` tells.
void SeriesDataset::mergeVariables(const DatasetInfo& file) {
    for (const VariableInfo& variable : file.variables) {
        if (info_.find(variable.name) == nullptr) info_.variables.push_back(variable);
    }
}

/// Sorts by time, drops duplicates with a note, and makes seconds relative to the first time.
void SeriesDataset::sortTimes() {
    std::ranges::stable_sort(info_.times, {}, &TimeInfo::seconds);
    std::vector<TimeInfo> kept;
    for (TimeInfo& time : info_.times) {
        if (!kept.empty() && kept.back().seconds == time.seconds) {
            const std::string first = kept.back().file.filename().string();
            info_.notes.push_back(
                kept.back().file == time.file
                    ? fmt::format("{} is in {} twice: the first is taken.", time.label, first)
                    : fmt::format("{} is there twice: taken from {}, not from {}", time.label,
                                  first, time.file.filename().string()));
            continue;
        }
        kept.push_back(std::move(time));
    }
    const double origin = kept.front().seconds;
    for (TimeInfo& time : kept) time.seconds -= origin;
    info_.times = std::move(kept);
}

const KnownFile& SeriesDataset::fileOf(const TimeInfo& when) const {
    return *std::ranges::find(*files_, when.file, &KnownFile::path);
}

bool SeriesDataset::has(std::string_view variable, int time) const {
    const TimeInfo& when = info_.times.at(static_cast<std::size_t>(time));
    return fileOf(when).variables.contains(variable);
}

ReaderFile& SeriesDataset::opened(const KnownFile& file, const Progress& progress) {
    if (!open_ || openPath_ != file.path) {
        open_.reset();
        open_ = std::make_unique<ReaderFile>(reader_, file.path,
                                             [&](double) { return goOn(progress, 0.0); });
        openPath_ = file.path;
    }
    return *open_;
}

/// Throws Error if a file was replaced since the series was opened and has other contents.
void SeriesDataset::requireUnchanged(const DatasetInfo& now, const TimeInfo& when,
                                     std::string_view variable, std::size_t index) const {
    const auto time = static_cast<std::size_t>(when.indexInFile);
    if (now.size == info_.size && index < now.variables.size() &&
        now.variables[index].name == variable && time < now.times.size() &&
        now.times[time].label == when.label) {
        return;
    }
    throw Error({.where = when.file.string(),
                 .what = "the file has changed since it was opened",
                 .hint = "open it again"});
}

/// The error for a variable that a file lacks, with the nearest name or the likely cause.
Error SeriesDataset::missing(const TimeInfo& when, const KnownFile& file,
                             std::string_view variable) const {
    std::vector<std::string_view> names;
    for (const auto& entry : file.variables) names.push_back(entry.first);
    ErrorParts parts{.where = file.path.string(),
                     .what = fmt::format("variable {} is missing", variable),
                     .found = fmt::format("{}", fmt::join(names, ", "))};
    if (info_.find(variable) != nullptr) {
        parts.what += fmt::format(" at {}", when.label);
        parts.expected = "the variables that other files of the series have";
        parts.hint = "leave this file out, or write the variable at all times";
    } else if (const std::string_view nearest = nearestName(variable, names); !nearest.empty()) {
        parts.hint = fmt::format("did you mean {}?", nearest);
    }
    return Error(parts);
}

Array3f SeriesDataset::read(std::string_view variable, int time, std::optional<CellBox> box,
                            const Progress& progress) {
    if (time < 0 || time >= static_cast<int>(info_.times.size())) {
        throw Error({.what = fmt::format("there is no time {}", time),
                     .expected = fmt::format("0 to {}", info_.times.size() - 1)});
    }
    const TimeInfo& when = info_.times[static_cast<std::size_t>(time)];
    const KnownFile& file = fileOf(when);
    const auto index = file.variables.find(variable);
    if (index == file.variables.end()) throw missing(when, file, variable);
    ReaderFile& source = opened(file, progress);
    requireUnchanged(source.description(), when, variable, index->second);
    const glm::ivec3 size = source.description().variables[index->second].size;
    const CellBox all = box.value_or(CellBox{glm::ivec3(0), size});
    if (glm::any(glm::lessThan(all.lower, glm::ivec3(0))) ||
        glm::any(glm::greaterThan(all.upper, size)) ||
        glm::any(glm::lessThanEqual(all.size(), glm::ivec3(0)))) {
        throw Error({.where = when.file.string(),
                     .what = fmt::format("the box asked of {} lies outside it", variable),
                     .expected = fmt::format("within {} x {} x {} cells", size.x, size.y, size.z)});
    }
    Array3f values;
    values.size = all.size();
    values.values =
        source.read(index->second, static_cast<std::size_t>(when.indexInFile), all, progress);
    return values;
}

}  // namespace

bool Dataset::has(std::string_view variable, int) const {
    return info_.find(variable) != nullptr;
}

DatasetInfo Dataset::infoAt(int time) const {
    DatasetInfo there = info_;
    std::erase_if(there.variables,
                  [&](const VariableInfo& variable) { return !has(variable.name, time); });
    return there;
}

bool Nest::moves() const {
    const NestAt* first = nullptr;
    for (const auto& place : at) {
        if (!place) continue;
        if (first != nullptr && place->cornerCells != first->cornerCells) return true;
        first = &*place;
    }
    return false;
}

double Dataset::finestCellM() const {
    double cellM = meanCellM(info_.spacingM);
    for (const Nest& nest : nests()) {
        cellM = std::min(cellM, meanCellM(nest.dataset->info().spacingM));
    }
    return cellM;
}

std::vector<fs::path> Dataset::filesAt(int time) const {
    const auto index = static_cast<std::size_t>(time);
    std::vector<fs::path> files{info_.times.at(index).file};
    for (const Nest& nest : nests()) {
        if (!nest.at[index]) continue;
        const auto& times = nest.dataset->info().times;
        files.push_back(times[static_cast<std::size_t>(nest.at[index]->time)].file);
    }
    return files;
}

std::shared_ptr<Dataset> Dataset::open(std::span<const fs::path> files, const PluginHost& host,
                                       const Progress& progress) {
    return open(files, host, HeaderCache::standardFolder(), progress);
}

std::shared_ptr<Dataset> Dataset::open(std::span<const fs::path> files, const PluginHost& host,
                                       const fs::path& cacheFolder, const Progress& progress) {
    // What a map says of a file is not known of the file.
    const fs::path& cache = host.map().empty() ? cacheFolder : fs::path();
    return openDomains(describeSeries(files, host, cache, progress), [](const Series& series) {
        return std::make_shared<SeriesDataset>(series);
    });
}

}  // namespace neph
