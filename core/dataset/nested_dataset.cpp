// nested_dataset.cpp: finds the outermost domain, and each nest's place at each of its times.
#include "core/dataset/nested_dataset.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/base/error.h"
#include "core/dataset/grid_text.h"
#include "core/dataset/nest_place.h"

namespace neph {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kNamedDomainFiles = 3;
constexpr double kFastAirMPerS = 50.0;  // a jet: what moves faster is rare

std::string domainNamesOf(const std::vector<std::string>& names) {
    std::vector<std::string> some(
        names.begin(),
        names.begin() + static_cast<std::ptrdiff_t>(std::min(names.size(), kNamedDomainFiles)));
    return fmt::format("{}{}", fmt::join(some, ", "),
                       names.size() > kNamedDomainFiles ? ", ..." : "");
}

std::string gridText(const DatasetInfo& file) {
    return fmt::format("{} x {} x {} cells of {:.6g} x {:.6g} m{}{}", file.size.x, file.size.y,
                       file.size.z, file.spacingM.x, file.spacingM.y,
                       file.domain.empty() ? "" : ", ", file.domain);
}

/// How a grid differs from that of the series, for messages.
std::string differenceText(const DatasetInfo& file, const DatasetInfo& series) {
    if (file.size != series.size || file.spacingM != series.spacingM) return gridText(file);
    return file.domain != series.domain ? file.domain : "another place or cells of other widths";
}

/// The domains of one run, and what was found of each as the outermost one.
class Arrangement {
  public:
    explicit Arrangement(const std::vector<NestedPart>& parts) : parts_(parts) {}

    /// Index of the outermost domain: one that contains the first, or is the first, and most
    /// others; the coarsest of these.
    std::size_t outermost() const {
        std::size_t best = 0;
        for (std::size_t i = 1; i < parts_.size(); ++i) {
            if (!whyNot(i, 0).empty()) continue;
            if (nestsOf(i).size() > nestsOf(best).size()) best = i;
        }
        return best;
    }
    std::vector<std::size_t> nestsOf(std::size_t whole) const {
        std::vector<std::size_t> nests;
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            if (i != whole && whyNot(whole, i).empty()) nests.push_back(i);
        }
        return nests;
    }
    /// Why a domain is no nest of another; empty if it is one.
    std::string whyNot(std::size_t whole, std::size_t nest) const {
        const auto known = reasons_.find({whole, nest});
        if (known != reasons_.end()) return known->second;
        return reasons_[{whole, nest}] = findReason(whole, nest, 0);
    }

  private:
    std::string findReason(std::size_t whole, std::size_t nest, std::size_t depth) const {
        const DatasetInfo& outer = parts_[whole].dataset->info();
        const DatasetInfo& inner = parts_[nest].dataset->info();
        if (inner.nest.number > 0 && inner.nest.number == outer.nest.number) {
            return "both are " + domainName(inner);
        }
        const FoundPlace found = placeWithin(outer, outer.times.front().gridOffsetM, inner,
                                             inner.times.front().gridOffsetM);
        if (const auto* reason = std::get_if<std::string>(&found)) {
            const auto between = parentOf(nest);
            const bool chained = between && *between != whole && depth < parts_.size() &&
                                 outer.map.projection.empty() && inner.map.projection.empty();
            if (!chained || !findReason(whole, *between, depth + 1).empty()) return *reason;
            const std::string last = findReason(*between, nest, depth + 1);
            if (!last.empty()) return last;
        }
        return shareTime(parts_[whole], parts_[nest]) ? "" : "they have no time in common";
    }

    /// The domain that is the parent of another by the run's numbers.
    std::optional<std::size_t> parentOf(std::size_t nest) const {
        const int parent = parts_[nest].dataset->info().nest.parent;
        for (std::size_t i = 0; parent > 0 && i < parts_.size(); ++i) {
            if (i != nest && parts_[i].dataset->info().nest.number == parent) return i;
        }
        return {};
    }

    static bool shareTime(const NestedPart& whole, const NestedPart& nest) {
        const double tolerance = nestToleranceSeconds(whole.dataset->info());
        return std::ranges::any_of(whole.dataset->info().times, [&](const TimeInfo& outer) {
            return std::ranges::any_of(nest.dataset->info().times, [&](const TimeInfo& inner) {
                const double apart = nest.seconds + inner.seconds - whole.seconds - outer.seconds;
                return std::abs(apart) <= tolerance;
            });
        });
    }

    const std::vector<NestedPart>& parts_;
    mutable std::map<std::pair<std::size_t, std::size_t>, std::string> reasons_;
};

double firstSeconds(const Series& series) {
    double first = series.files.front().description.times.front().seconds;
    for (const SeriesFile& file : series.files) {
        for (const TimeInfo& time : file.description.times) first = std::min(first, time.seconds);
    }
    return first;
}

Error doesNotFit(const Series& series, const Series& whole, const std::string& reason) {
    const DatasetInfo& found = series.files.front().description;
    return Error(
        {.where = series.files.front().path.string(),
         .what = fmt::format("its grid is not that of {}, nor that of a nest within it",
                             whole.files.front().path.string()),
         .found = fmt::format("{} ({})", gridText(found), reason),
         .expected = gridText(whole.files.front().description),
         .hint = "domains of one run are composed where one contains the others, on one map; open "
                 "others by themselves"});
}

/// Notes which domains of folders are left out of `whole`.
void noteLeftOut(const std::vector<Series>& domains, const std::vector<std::size_t>& left,
                 const std::vector<std::string>& reasons, Series& whole) {
    std::map<fs::path, std::vector<std::size_t>> byFolder;
    for (const std::size_t i : left) byFolder[domains[i].folder].push_back(i);
    for (const auto& [folder, some] : byFolder) {
        std::vector<std::string> names;
        for (const std::size_t i : some) {
            for (const SeriesFile& file : domains[i].files) {
                names.push_back(file.path.filename().string());
            }
        }
        const std::string of =
            folder.filename().empty() ? folder.string() : folder.filename().string();
        const DatasetInfo& first = domains[some.front()].files.front().description;
        whole.notes.push_back(fmt::format(
            "{} file{} in {} left out, as of another grid ({}): {} ({}). Name them to open them.",
            names.size(), names.size() == 1 ? "" : "s", of,
            differenceText(first, whole.files.front().description), domainNamesOf(names),
            reasons[some.front()]));
    }
}

}  // namespace

double nestToleranceSeconds(const DatasetInfo& whole) {
    return std::min(whole.spacingM.x, whole.spacingM.y) / kFastAirMPerS;
}

std::shared_ptr<Dataset> openDomains(std::vector<Series> domains, const MakeDataset& make) {
    if (domains.size() == 1) return make(domains.front());
    std::vector<NestedPart> parts;
    for (const Series& series : domains) {
        std::string name = domainName(series.files.front().description);
        if (name.empty()) name = series.files.front().path.filename().string();
        parts.push_back({make(series), firstSeconds(series), std::move(name)});
    }
    const Arrangement arrangement(parts);
    const std::size_t whole = arrangement.outermost();
    std::vector<std::size_t> left;
    std::vector<std::string> reasons(domains.size());
    std::vector<NestedPart> nests;
    std::set<int> numbers;
    for (std::size_t i = 0; i < domains.size(); ++i) {
        if (i == whole) continue;
        reasons[i] = arrangement.whyNot(whole, i);
        const int number = parts[i].dataset->info().nest.number;
        if (reasons[i].empty() && number > 0 && !numbers.insert(number).second) {
            reasons[i] = "another " + parts[i].name + " is there";
        }
        if (reasons[i].empty()) {
            nests.push_back(parts[i]);
        } else if (domains[i].folder.empty()) {
            throw doesNotFit(domains[i], domains[whole], reasons[i]);
        } else {
            left.push_back(i);
        }
    }
    if (whole != 0) {  // what was left out on reading was noted for the first
        auto& notes = domains[0].notes;
        std::ranges::move(notes, std::back_inserter(domains[whole].notes));
    }
    noteLeftOut(domains, left, reasons, domains[whole]);
    parts[whole].dataset = make(domains[whole]);
    return nests.empty() ? parts[whole].dataset : nestWithin(parts[whole], std::move(nests));
}

}  // namespace neph
