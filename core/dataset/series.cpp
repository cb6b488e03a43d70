// series.cpp: decides which files belong together; reads headers in parallel.
#include "core/dataset/series.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/dataset/file_list.h"
#include "core/dataset/header_cache.h"
#include "core/dataset/nest_place.h"
#include "core/plugin/file_kind.h"

namespace neph {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostReaders = 8;  // files whose headers are read at once
constexpr std::size_t kNamedLeftOut = 3;

/// A file that may be part of the series.
struct Candidate {
    fs::path path;
    fs::path folder{};  ///< the folder that the user named; empty if the file itself was named
    std::optional<HeaderStamp> stamp{};  ///< taken first, so that a later change invalidates it
    std::optional<DatasetInfo> description{};
    std::optional<Error> fault{};

    bool mayFail() const { return !folder.empty(); }
};

/// Whether a reader accepts the folder itself, as for a MicroHH case.
bool takenWhole(const fs::path& folder, const PluginHost& host, const Progress& progress) {
    try {
        host.pick(folder, progress);
        return true;
    } catch (const Error&) {
        return false;
    }
}

Error notRead(const fs::path& path, const RecognisedFile& known) {
    return Error({.where = path.string(),
                  .what = "no reader knows this format",
                  .found = known.what,
                  .hint = known.step});
}

/// The first few names, for messages.
std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), kNamedLeftOut); ++i) {
        text += (i == 0 ? "" : ", ") + names[i];
    }
    return names.size() > kNamedLeftOut ? text + ", ..." : text;
}

/// Names of the folders in a folder, for messages.
std::string foldersIn(const fs::path& folder) {
    std::vector<std::string> names;
    std::error_code code;
    for (const auto& entry : fs::directory_iterator(folder, code)) {
        if (entry.is_directory(code)) names.push_back(entry.path().filename().string());
    }
    std::ranges::sort(names);
    return listed(names);
}

/// Replaces folders by their files, unless a reader accepts the folder as a whole.
std::vector<Candidate> candidatesOf(std::span<const fs::path> named, const PluginHost& host,
                                    const Progress& progress) {
    std::vector<Candidate> candidates;
    for (const fs::path& path : named) {
        std::error_code code;
        if (!fs::is_directory(path, code) || takenWhole(path, host, progress)) {
            candidates.push_back({path});
            continue;
        }
        const auto known = recogniseFile(path);
        if (known) throw notRead(path, *known);
        std::vector<fs::path> files = filesIn(std::span(&path, 1));
        if (files.empty()) {
            const std::string inside = foldersIn(path);
            throw Error({.where = path.string(),
                         .what = "holds no files",
                         .found = inside.empty() ? "" : "folders: " + inside,
                         .expected = "model output in this folder",
                         .hint = inside.empty()
                                     ? ""
                                     : "open the one that holds the run; --members opens "
                                       "runs of one grid as an ensemble"});
        }
        for (fs::path& file : files) candidates.push_back({std::move(file), path});
    }
    if (candidates.empty()) {
        throw Error({.what = "no files were given", .hint = "name at least one"});
    }
    return candidates;
}

/// Files of one series need the same native grid of the same domain; their variables may differ.
/// The cells by which the grid of a nest has moved from `a` to `b`, 0 for all others; nothing if
/// they are no series.
std::optional<glm::ivec2> sameGrid(const DatasetInfo& a, const DatasetInfo& b) {
    if (a.size != b.size || a.edgesM != b.edgesM || a.domain != b.domain) return {};
    const bool nests = a.nest.number > 1 && !a.map.projection.empty();
    if (nests && (a.map != b.map || a.spacingM != b.spacingM)) {
        return cellsBetween(a, glm::dvec2(0.0), b, glm::dvec2(0.0));
    }
    if (a.spacingM != b.spacingM) return {};
    // Without a place, by where it lies in its parent.
    if (a.nest.number > 1 && a.nest.ratio > 0 && a.nest.ratio == b.nest.ratio &&
        a.map.projection.empty() && b.map.projection.empty()) {
        return (b.nest.cornerCells - a.nest.cornerCells) * a.nest.ratio;
    }
    return glm::ivec2(0);
}

/// Describes a nest as on the grid of its first file, which lies `cells` from there.
void moveFrom(const DatasetInfo& first, glm::ivec2 cells, DatasetInfo& nest) {
    const glm::dvec2 perMetre = first.spacingM / nest.spacingM;
    nest.map = first.map;
    nest.nest = first.nest;
    nest.spacingM = first.spacingM;
    for (TimeInfo& time : nest.times) {
        time.gridOffsetM = time.gridOffsetM * perMetre + glm::dvec2(cells) * first.spacingM;
    }
}

/// Whether a nest lies elsewhere at a time that its series has already: it is then another nest.
bool contradicts(const DatasetInfo& nest, const Series& series) {
    for (const SeriesFile& file : series.files) {
        for (const TimeInfo& time : nest.times) {
            const auto& known = file.description.times;
            const auto same = std::ranges::find(known, time.seconds, &TimeInfo::seconds);
            if (same == known.end()) continue;
            const glm::dvec2 apart = glm::abs(same->gridOffsetM - time.gridOffsetM);
            if (glm::any(glm::greaterThan(apart, 0.5 * nest.spacingM))) return true;
        }
    }
    return false;
}

/// The steps that turn candidates into series.
class SeriesMaker {
  public:
    SeriesMaker(std::vector<Candidate> candidates, const PluginHost& host, fs::path cacheFolder)
        : candidates_(std::move(candidates)), host_(host), cacheFolder_(std::move(cacheFolder)) {}

    std::vector<Series> make(const Progress& progress) {
        findFirst([&](double) { return goOn(progress, 0.0); });
        describeRest(progress);
        for (Candidate& candidate : candidates_) {
            const bool part = !candidate.description && !candidate.fault;
            if (part || (candidate.description && isTaken(candidate))) continue;
            sort(candidate);
        }
        for (auto& [folder, left] : leftOut_) note(folder, left);
        return std::move(domains_);
    }

  private:
    struct LeftOut {
        std::vector<std::string> unreadable;
        std::string reason;  ///< of the first
        struct Kind {
            std::vector<std::string> names;
            RecognisedFile known;  ///< of the first
        };
        std::map<std::string_view, Kind> kinds;  ///< by id: data, but not as a reader takes them
    };

    /// The first readable candidate determines the reader.
    void findFirst(const Progress& progress) {
        for (; first_ < candidates_.size(); ++first_) {
            Candidate& candidate = candidates_[first_];
            try {
                reader_ = host_.pick(candidate.path, progress);
                candidate.description = ReaderFile(reader_, candidate.path, progress).description();
                claimParts(*candidate.description);
                return;
            } catch (const Error& error) {
                if (!candidate.mayFail()) throw;
                candidate.fault = error;
            }
        }
        throw nothingRead();
    }

    /// The error where no candidate can be read. It speaks of the first whose kind is recognised
    /// and that is more than text, as what a run leaves beside its output is.
    Error nothingRead() const {
        const Candidate* told = &candidates_.front();
        std::optional<RecognisedFile> known;
        for (const Candidate& candidate : candidates_) {
            auto kind = recogniseFile(candidate.path);
            // What a reader says about its own format is the best advice.
            const bool refused = candidate.fault && host_.isKnown(candidate.path);
            if (!refused && (!kind || kind->row->aside)) continue;
            told = &candidate;
            if (!refused) known = std::move(kind);
            break;
        }
        const std::string& hint = told->fault->parts().hint;
        return Error({.where = told->folder.string(),
                      .what = "holds no file that can be read",
                      .found = fmt::format("{} file{}; {}: {}", candidates_.size(),
                                           candidates_.size() == 1 ? "" : "s",
                                           told->path.filename().string(),
                                           known ? known->what : told->fault->parts().what),
                      .expected = "output of one model run",
                      .hint = known           ? known->step
                              : !hint.empty() ? hint
                                              : "`nephoscope readers` lists what can be read"});
    }

    void describeRest(const Progress& progress) {
        std::map<fs::path, HeaderCache> caches;
        std::vector<Candidate*> unknown;
        for (std::size_t i = first_ + 1; i < candidates_.size(); ++i) {
            Candidate& candidate = candidates_[i];
            const fs::path folder = candidate.path.parent_path();
            const auto cache = caches.try_emplace(folder, cacheFolder_, folder, *reader_).first;
            candidate.stamp = headerStampOf(candidate.path);
            if (candidate.stamp) {
                candidate.description = cache->second.find(candidate.path, *candidate.stamp);
            }
            if (!candidate.description) unknown.push_back(&candidate);
        }
        shareOut(
            unknown.size(), workerCount(kMostReaders),
            [&](std::size_t i, std::size_t, const Progress& alone) {
                describe(*unknown[i], [&](double) { return goOn(alone, 0.0); });
            },
            progress);
        for (const Candidate* candidate : unknown) {
            if (!candidate->stamp || !candidate->description) continue;
            if (!candidate->description->parts.empty()) continue;  // the stamp covers one file
            caches.at(candidate->path.parent_path())
                .put(candidate->path, *candidate->stamp, *candidate->description);
        }
        for (const auto& [folder, cache] : caches) cache.save();
    }

    /// Remembers the files that are read together with one that is described.
    void claimParts(const DatasetInfo& description) {
        const std::lock_guard lock(mutex_);
        for (const fs::path& part : description.parts) claimed_.insert(part.lexically_normal());
    }
    bool isClaimed(const fs::path& path) {
        const std::lock_guard lock(mutex_);
        return claimed_.contains(path.lexically_normal());
    }
    /// Whether a candidate is a part of a data set that is in the series already: two of its files
    /// may have been described at once.
    bool isTaken(const Candidate& candidate) {
        const std::vector<fs::path>& parts = candidate.description->parts;
        if (std::ranges::find(parts, candidate.path) == parts.end()) return false;
        return !wholes_.insert(parts.front()).second;
    }

    void describe(Candidate& candidate, const Progress& progress) {
        if (isClaimed(candidate.path)) return;
        try {
            requireReadable(candidate.path);
            candidate.description = ReaderFile(reader_, candidate.path, progress).description();
            claimParts(*candidate.description);
        } catch (const Error& error) {
            if (!candidate.mayFail()) throw foreign(candidate, error);
            candidate.fault = error;
        }
    }

    /// The error for a file that the user named: it may belong to another reader.
    Error foreign(const Candidate& candidate, const Error& error) const {
        const auto reader = host_.pick(candidate.path);
        if (reader == reader_) return error;
        return Error({.where = candidate.path.string(),
                      .what = fmt::format("is not of the same series as {}",
                                          candidates_[first_].path.string()),
                      .found = reader->title,
                      .expected = reader_->title,
                      .hint = "open files of one model run together"});
    }

    /// Adds a candidate to the series of its domain, or leaves it out with a note.
    void sort(Candidate& candidate) {
        const std::string name = candidate.path.filename().string();
        LeftOut* left = candidate.mayFail() ? &leftOut_[candidate.folder] : nullptr;
        if (!candidate.description) {
            const auto known = recogniseFile(candidate.path);
            if (known && !known->row->aside) {
                LeftOut::Kind& kind = left->kinds[known->row->id];
                if (kind.names.empty()) kind.known = *known;
                kind.names.push_back(name);
                return;
            }
            if (left->unreadable.empty()) left->reason = candidate.fault->parts().what;
            left->unreadable.push_back(name);
            return;
        }
        addToDomain(candidate);
    }

    /// Adds a described file to the series of its domain, or begins one.
    void addToDomain(Candidate& candidate) {
        DatasetInfo& file = *candidate.description;
        for (Series& series : domains_) {
            const DatasetInfo& first = series.files.front().description;
            const auto moved = sameGrid(first, file);
            if (!moved) continue;
            if (*moved != glm::ivec2(0)) {
                DatasetInfo there = file;
                moveFrom(first, *moved, there);
                if (contradicts(there, series)) continue;
                file = std::move(there);
                noteMotion(series);
            }
            series.files.push_back({candidate.path, std::move(file)});
            if (!candidate.mayFail()) series.folder.clear();
            return;
        }
        domains_.push_back({reader_, {{candidate.path, std::move(file)}}, {}, candidate.folder});
    }

    static void noteMotion(Series& series) {
        const std::string note =
            "The nest moves from file to file: each time has its own place, and the camera follows "
            "the grid unless it is fixed to the ground.";
        if (std::ranges::find(series.notes, note) == series.notes.end()) {
            series.notes.push_back(note);
        }
    }

    void note(const fs::path& folder, const LeftOut& left) {
        const auto count = [](std::size_t n) {
            return fmt::format("{} file{}", n, n == 1 ? "" : "s");
        };
        const std::string of =
            folder.filename().empty() ? folder.string() : folder.filename().string();
        if (!left.unreadable.empty()) {
            domains_.front().notes.push_back(fmt::format(
                "{} in {} left out, as not of this series: {} ({}).", count(left.unreadable.size()),
                of, listed(left.unreadable), left.reason));
        }
        for (const auto& [id, kind] : left.kinds) {
            domains_.front().notes.push_back(
                fmt::format("{} in {} left out: {} ({}). {}{}.", count(kind.names.size()), of,
                            listed(kind.names), kind.known.what, kind.known.step,
                            kind.names.size() > 1 ? "; so for the others" : ""));
        }
    }

    std::vector<Candidate> candidates_;
    const PluginHost& host_;
    const fs::path cacheFolder_;
    std::size_t first_ = 0;
    std::shared_ptr<const ReaderPlugin> reader_;
    std::vector<Series> domains_;
    std::map<fs::path, LeftOut> leftOut_;
    std::mutex mutex_;            // guards claimed_
    std::set<fs::path> claimed_;  ///< files that are read together with a described one
    std::set<fs::path> wholes_;   ///< the first files of data sets of several
};

}  // namespace

std::vector<Series> describeSeries(std::span<const fs::path> named, const PluginHost& host,
                                   const fs::path& cacheFolder, const Progress& progress) {
    const Progress begin = [&](double) { return goOn(progress, 0.0); };
    return SeriesMaker(candidatesOf(named, host, begin), host, cacheFolder).make(progress);
}

}  // namespace neph
