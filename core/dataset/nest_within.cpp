// nest_within.cpp: the data set of a domain and its nests, and where each is at each time.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/dataset/grid_text.h"
#include "core/dataset/nest_place.h"
#include "core/dataset/nested_dataset.h"

namespace neph {
namespace {

/// All but the nests is the outermost domain's.
class NestedDataset : public Dataset {
  public:
    NestedDataset(std::shared_ptr<Dataset> whole, std::vector<Nest> nests, DatasetInfo described)
        : whole_(std::move(whole)), nests_(std::move(nests)) {
        info_ = std::move(described);
    }
    bool has(std::string_view variable, int time) const override {
        return whole_->has(variable, time);
    }
    Array3f read(std::string_view variable, int time, std::optional<CellBox> box,
                 const Progress& progress) override {
        return whole_->read(variable, time, box, progress);
    }
    std::span<const Nest> nests() const override { return nests_; }
    std::unique_ptr<Dataset> anotherHandle() const override {
        std::shared_ptr<Dataset> whole = whole_->anotherHandle();
        if (!whole) return nullptr;
        std::vector<Nest> nests = nests_;
        for (Nest& nest : nests) {
            nest.dataset = nest.dataset->anotherHandle();
            if (!nest.dataset) return nullptr;
        }
        return std::make_unique<NestedDataset>(std::move(whole), std::move(nests), info_);
    }

  private:
    std::shared_ptr<Dataset> whole_;
    std::vector<Nest> nests_;
};

/// Index of the nest's time nearest to one of the whole; nothing beyond the tolerance.
std::optional<int> timeNear(const NestedPart& nest, double seconds, double tolerance) {
    const auto& times = nest.dataset->info().times;
    const double wanted = seconds - nest.seconds;
    auto after = std::ranges::lower_bound(times, wanted, {}, &TimeInfo::seconds);
    if (after != times.begin() &&
        (after == times.end() || wanted - std::prev(after)->seconds < after->seconds - wanted)) {
        --after;
    }
    if (std::abs(after->seconds - wanted) > tolerance) return {};
    return static_cast<int>(after - times.begin());
}

/// Places nests one after another, coarser ones first.
class NestPlacer {
  public:
    explicit NestPlacer(const NestedPart& whole) : whole_(whole) {}

    void place(const NestedPart& part) {
        const DatasetInfo& outer = whole_.dataset->info();
        const DatasetInfo& inner = part.dataset->info();
        Nest nest{part.name, part.dataset, 0, {}};
        for (std::size_t t = 0; t < outer.times.size(); ++t) {
            nest.at.emplace_back();
            const auto time = timeNear(part, whole_.seconds + outer.times[t].seconds,
                                       nestToleranceSeconds(outer));
            if (!time) continue;
            const auto found = placeAt(t, inner, static_cast<std::size_t>(*time));
            if (!found || (nest.ratio != 0 && nest.ratio != found->ratio)) continue;
            nest.ratio = found->ratio;
            nest.at.back() = NestAt{*time, found->cornerCells};
        }
        if (nest.ratio != 0) nests_.push_back(std::move(nest));
    }
    std::vector<Nest> take() {
        std::ranges::stable_sort(nests_, {}, &Nest::ratio);
        return std::move(nests_);
    }

  private:
    std::optional<NestPlace> placeAt(std::size_t t, const DatasetInfo& inner, std::size_t time) {
        const DatasetInfo& outer = whole_.dataset->info();
        const FoundPlace& found =
            lastPlace(outer.times[t].gridOffsetM, inner, inner.times[time].gridOffsetM);
        if (const auto* place = std::get_if<NestPlace>(&found)) return *place;
        if (!outer.map.projection.empty() || !inner.map.projection.empty()) return {};
        // Without a map a nest is known by its place in its own parent, which is a nest as well.
        for (const Nest& parent : nests_) {
            const DatasetInfo& between = parent.dataset->info();
            if (between.nest.number != inner.nest.parent || !parent.at[t]) continue;
            const FoundPlace inside =
                placeWithin(between, {}, inner, inner.times[time].gridOffsetM);
            const auto* place = std::get_if<NestPlace>(&inside);
            if (place == nullptr) continue;
            return NestPlace{parent.ratio * place->ratio,
                             parent.at[t]->cornerCells * place->ratio + place->cornerCells};
        }
        return {};
    }

    /// Asks the maps only where one of both has moved.
    const FoundPlace& lastPlace(glm::dvec2 outerM, const DatasetInfo& inner, glm::dvec2 innerM) {
        if (last_.inner != &inner || last_.outerM != outerM || last_.innerM != innerM) {
            last_ = {&inner, outerM, innerM,
                     placeWithin(whole_.dataset->info(), outerM, inner, innerM)};
        }
        return last_.found;
    }

    struct Last {
        const DatasetInfo* inner = nullptr;
        glm::dvec2 outerM{0.0}, innerM{0.0};
        FoundPlace found;
    };

    const NestedPart& whole_;
    std::vector<Nest> nests_;
    Last last_;
};

/// What the nests are, and at how many times.
std::vector<std::string> notesOf(const NestedPart& whole, const std::vector<Nest>& nests) {
    std::vector<std::string> notes;
    std::string names;
    for (const Nest& nest : nests) {
        names += fmt::format("{}{} ({})", names.empty() ? "" : ", ", nest.name,
                             cellWidthText(nest.dataset->info()));
    }
    notes.push_back(fmt::format("{} composed within {} ({}), each where it is the finest.", names,
                                whole.name, cellWidthText(whole.dataset->info())));
    for (const Nest& nest : nests) {
        const auto there = static_cast<std::size_t>(
            std::ranges::count_if(nest.at, [](const auto& at) { return at.has_value(); }));
        const std::size_t own = nest.dataset->info().times.size();
        if (there < nest.at.size()) {
            notes.push_back(fmt::format("{} is there at {} of the {} times of {}.", nest.name,
                                        there, nest.at.size(), whole.name));
        }
        if (there < own) {
            notes.push_back(fmt::format(
                "{} has {} more time{}, at which {} has none: open it by itself for them.",
                nest.name, own - there, own - there == 1 ? "" : "s", whole.name));
        }
    }
    return notes;
}

}  // namespace

std::shared_ptr<Dataset> nestWithin(const NestedPart& whole, std::vector<NestedPart> parts) {
    // A parent has coarser cells than its nests.
    std::ranges::stable_sort(parts, std::ranges::greater(), [](const NestedPart& part) {
        return part.dataset->info().spacingM.x;
    });
    NestPlacer placer(whole);
    for (const NestedPart& part : parts) placer.place(part);
    std::vector<Nest> nests = placer.take();
    if (nests.empty()) return whole.dataset;
    DatasetInfo described = whole.dataset->info();
    const auto add = [&](const std::string& note) {
        if (std::ranges::find(described.notes, note) == described.notes.end()) {
            described.notes.push_back(note);
        }
    };
    for (const Nest& nest : nests) {
        for (const std::string& note : nest.dataset->info().notes) {
            const auto& known = whole.dataset->info().notes;
            if (std::ranges::find(known, note) == known.end()) add(nest.name + ": " + note);
        }
    }
    for (const std::string& note : notesOf(whole, nests)) add(note);
    return std::make_shared<NestedDataset>(whole.dataset, std::move(nests), std::move(described));
}

}  // namespace neph
