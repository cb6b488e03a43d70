// nested_volume.cpp: one lattice for all domains, the finest grid that fits, and the reading.
#include "core/volume/nested_volume.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "core/dataset/grid_text.h"
#include "core/dataset/nest_place.h"
#include "core/volume/resample.h"

namespace neph {
namespace {

/// A domain before its plan is made.
struct Within {
    const Nest* nest = nullptr;  ///< null: the outermost domain
    Dataset* dataset = nullptr;
    int time = 0;
    int ratio = 1;
    glm::ivec2 cornerCells{0};
    ReadPlan full;  ///< at full resolution, of what the region needs
};

/// Whether a nest has a cell in `box`, columns of the outermost domain.
bool touches(const Nest& nest, const NestAt& at, const CellBox& box) {
    const glm::ivec2 upper = at.cornerCells + glm::ivec2(nest.dataset->info().size);
    return glm::all(glm::lessThan(at.cornerCells, glm::ivec2(box.upper) * nest.ratio)) &&
           glm::all(glm::greaterThan(upper, glm::ivec2(box.lower) * nest.ratio));
}

/// `box` in metres of a nest, with a cell more on every side for what is interpolated.
BoxM regionWithin(const Within& domain, const CellBox& box) {
    const DatasetInfo& info = domain.dataset->info();
    BoxM wanted;
    for (int axis = 0; axis < 2; ++axis) {
        // The middle of the first and of the last cell: they are read whole.
        const double lower = box.lower[axis] * domain.ratio - domain.cornerCells[axis] - 0.5;
        const double upper = box.upper[axis] * domain.ratio - domain.cornerCells[axis] + 0.5;
        wanted.lowerM[axis] = std::max(lower, 0.5) * info.spacingM[axis];
        wanted.upperM[axis] = std::min(upper, info.size[axis] - 0.5) * info.spacingM[axis];
    }
    constexpr double kNoLimit = std::numeric_limits<double>::infinity();
    wanted.lowerM.z = -kNoLimit;  // levels are common to all domains: see planOf
    wanted.upperM.z = kNoLimit;
    return wanted;
}

/// The outermost domain's plan at full resolution, with a cell more on every side.
ReadPlan withMarginCell(ReadPlan plan, const DatasetInfo& info) {
    for (int axis = 0; axis < 2; ++axis) {
        plan.even.lower[axis] = std::max(plan.even.lower[axis] - 1, 0);
        plan.even.upper[axis] = std::min(plan.even.upper[axis] + 1, info.size[axis]);
    }
    plan.box = plan.even;
    return coarsened(std::move(plan), 1, info);
}

/// How many fields the domains have together.
std::uint64_t speciesOfAll(const std::vector<Within>& domains) {
    std::uint64_t species = 0;
    for (int s = 0; s < kSpeciesCount; ++s) {
        species += std::ranges::any_of(domains, [&](const Within& domain) {
            return domain.dataset->info().find(VariableRole::mixingRatio,
                                               static_cast<Species>(s)) != nullptr;
        });
    }
    return species;
}

/// How the cells of the result lie on the lattice.
struct ResultCells {
    CellBox box;      ///< columns of the outermost domain that are shown
    int lattice = 1;  ///< lattice cells along one of the outermost domain
    int cell = 1;     ///< ... along one of the result
    std::optional<BoxM> region = {};
    /// Whether domains may be coarsened to blocks that lie across result cells, as memory requires.
    bool across = false;
};

/// The plan of a domain whose cells are `own` lattice cells wide: where they are finer than the
/// result's, in the largest blocks that divide these.
ReadPlan planWithin(const Within& domain, const ResultCells& result, int own) {
    const DatasetInfo& info = domain.dataset->info();
    const int most = result.cell / own;
    if (most < 2) return coarsened(domain.full, 1, info);
    ReadPlan plan = domain.full;  // nothing is interpolated: no cells beyond the box
    for (int axis = 0; axis < 2; ++axis) {
        const int corner = domain.cornerCells[axis];
        int& lower = plan.even.lower[axis];
        int& upper = plan.even.upper[axis];
        lower = std::max(lower, result.box.lower[axis] * domain.ratio - corner);
        upper = std::min(upper, result.box.upper[axis] * domain.ratio - corner);
    }
    plan.box = plan.even;
    const glm::ivec2 from = (domain.cornerCells + glm::ivec2(plan.even.lower)) * own -
                            glm::ivec2(result.box.lower) * result.lattice;
    const auto divides = [&](int blocks) {
        const int width = blocks * own;
        return result.cell % width == 0 && from.x % width == 0 && from.y % width == 0;
    };
    int blocks = most;
    while (!result.across && blocks > 1 && !divides(blocks)) --blocks;
    return coarsened(std::move(plan), blocks, info);
}

/// The plans of all domains for cells of the result.
NestedPlan planOf(const std::vector<Within>& domains, const ResultCells& result) {
    const CellBox& box = result.box;
    const int lattice = result.lattice, cell = result.cell;
    const DatasetInfo& outer = domains.front().dataset->info();
    NestedPlan plan;
    plan.shown = domains.front().full;
    plan.shown.even = plan.shown.box = box;
    plan.at = {glm::ivec2(box.lower) * lattice, cell};
    RegularGrid& grid = plan.shown.grid;
    for (const Within& domain : domains) joinLevels(domain.full.grid, grid);
    if (result.region) cutLevels(*result.region, grid);
    for (int axis = 0; axis < 2; ++axis) {
        const int cells = box.size()[axis] * lattice;
        grid.size[axis] = (cells + cell - 1) / cell;
        grid.spacingM[axis] = outer.spacingM[axis] * cell / lattice;
        grid.originM[axis] = outer.spacingM[axis] * box.lower[axis];
    }
    countBytes(speciesOfAll(domains), plan.shown);
    std::uint64_t largest = 0;
    for (const Within& domain : domains) {
        const DatasetInfo& info = domain.dataset->info();
        const int own = lattice / domain.ratio;  // lattice cells
        DomainPlan part{.name = domain.nest == nullptr ? "" : domain.nest->name,
                        .dataset = domain.dataset,
                        .time = domain.time,
                        .plan = planWithin(domain, result, own)};
        part.plan.grid.originM.z = grid.originM.z;
        part.plan.grid.spacingM.z = grid.spacingM.z;
        part.plan.grid.size.z = grid.size.z;
        part.at = {(domain.cornerCells + glm::ivec2(part.plan.even.lower)) * own,
                   own * part.plan.coarsening};
        if (domain.nest != nullptr) {
            part.edges = NestEdges{domain.cornerCells * own,
                                   (domain.cornerCells + glm::ivec2(info.size)) * own,
                                   static_cast<double>(kNestEdgeCells * own)};
        }
        largest = std::max(largest, coarsened(part.plan, part.plan.coarsening, info).machineBytes);
        plan.domains.push_back(std::move(part));
    }
    plan.shown.machineBytes += largest;
    return plan;
}

std::string spacingText(const RegularGrid& grid) {
    const std::string x = lengthText(grid.spacingM.x), y = lengthText(grid.spacingM.y);
    return x == y ? x : x + " x " + y;
}

/// "d02 (1 km) within d01 (3 km), shown at 1 km."
std::string textOf(const std::vector<Within>& domains, const NestedPlan& plan,
                   const NestedPlan& finest) {
    std::string names;
    for (const Within& domain : domains) {
        if (domain.nest == nullptr) continue;
        names += fmt::format("{}{} ({})", names.empty() ? "" : ", ", domain.nest->name,
                             cellWidthText(domain.dataset->info()));
    }
    const DatasetInfo& outer = domains.front().dataset->info();
    const std::string name = domainName(outer);
    const std::string text =
        fmt::format("{} within {} ({}), shown at {}", names, name.empty() ? "the outermost" : name,
                    cellWidthText(outer), spacingText(plan.shown.grid));
    if (plan.at == finest.at) return text + ".";
    return fmt::format("{}: at {} it would take {}, not {}; a region is shown more finely.", text,
                       spacingText(finest.shown.grid), planSizeText(finest.shown.gpuBytes),
                       planSizeText(plan.shown.gpuBytes));
}

/// The nests that lie in `box` at a time; those without output are noted.
std::vector<Within> nestsIn(Dataset& dataset, int time, const CellBox& box,
                            std::vector<std::string>& notes) {
    std::vector<Within> found;
    const DatasetInfo& info = dataset.info();
    for (const Nest& nest : dataset.nests()) {
        const auto& at = nest.at[static_cast<std::size_t>(time)];
        if (!at) {
            notes.push_back(fmt::format("{}: {} is absent, without output at this time.",
                                        info.times[static_cast<std::size_t>(time)].label,
                                        nest.name));
        } else if (touches(nest, *at, box)) {
            found.push_back({&nest, nest.dataset.get(), at->time, nest.ratio, at->cornerCells, {}});
        }
    }
    return found;
}

/// One rule for all domains: a species is mass in all where it is in one.
RadiusPlan radiiOfAll(const RadiusPlan& radii, const NestedPlan& plan) {
    RadiusPlan common = radii;
    for (const DomainPlan& domain : plan.domains) {
        const DatasetInfo there = domain.dataset->infoAt(domain.time);
        const RadiusPlan own = planAt(radii, there, domain.name);
        for (std::size_t s = 0; s < kSpeciesCount; ++s) {
            const auto species = static_cast<Species>(s);
            if (there.find(VariableRole::mixingRatio, species) == nullptr) continue;
            if (!own.holdsMass(species) || radii.holdsMass(species)) continue;
            common.rules[s] = own.rules[s];
            common.notes.push_back(fmt::format(
                "{} lacks what the size of {} needs: all domains hold it as mass.",
                domain.name.empty() ? "The outermost domain" : domain.name, info(species).id));
        }
    }
    return common;
}

}  // namespace

NestedPlan planNested(Dataset& dataset, int time, const std::optional<BoxM>& region,
                      const MemoryBudget& budget, const Progress& progress,
                      const std::optional<NativeLevels>& levels) {
    NestedPlan alone;
    alone.shown = planRead(dataset, time, region, budget, progress, levels);
    alone.domains.push_back({.name = {}, .dataset = &dataset, .time = time, .plan = alone.shown});
    const CellBox box = alone.shown.even;
    std::vector<Within> domains = nestsIn(dataset, time, box, alone.notes);
    if (domains.empty()) return alone;
    domains.insert(domains.begin(), {nullptr, &dataset, time, 1, glm::ivec2(0), {}});
    int lattice = 1, finest = 1;
    for (Within& domain : domains) {
        lattice = std::lcm(lattice, domain.ratio);
        finest = std::max(finest, domain.ratio);
        domain.full = domain.nest == nullptr
                          ? withMarginCell(alone.shown, dataset.info())
                          : planRead(*domain.dataset, domain.time, regionWithin(domain, box), {},
                                     progress, levels);
    }
    const int least = lattice / finest;
    const NestedPlan full = planOf(domains, {box, lattice, least, region});
    const int most = lattice * std::max(box.size().x, box.size().y);
    for (int cell = least;; ++cell) {
        for (const bool across : {false, true}) {
            NestedPlan plan = planOf(domains, {box, lattice, cell, region, across});
            const bool fits =
                plan.shown.machineBytes <= budget.machine && plan.shown.gpuBytes <= budget.gpu;
            if (!fits && !(across && cell >= most)) continue;
            plan.shown.coarsening = (cell + least - 1) / least;
            plan.shown.nested = textOf(domains, plan, full);
            plan.notes = alone.notes;
            return plan;
        }
    }
}

ReadPlan planShown(Dataset& dataset, int time, const std::optional<BoxM>& region,
                   const MemoryBudget& budget, const Progress& progress,
                   const std::optional<NativeLevels>& levels) {
    return planNested(dataset, time, region, budget, progress, levels).shown;
}

SpeciesVolume readNested(Dataset& dataset, int time, const NestedPlan& plan,
                         const RadiusPlan& radii, const Progress& progress) {
    if (plan.domains.size() == 1) {
        SpeciesVolume volume = resample(dataset, time, {plan.shown, radii}, progress);
        volume.nativeCellM = dataset.finestCellM();
        volume.notes.insert(volume.notes.end(), plan.notes.begin(), plan.notes.end());
        return volume;
    }
    const RadiusPlan common = radiiOfAll(radii, plan);
    SpeciesVolume result;
    result.grid = plan.shown.grid;
    result.nativeCellM = dataset.finestCellM();
    std::uint64_t all = 0, done = 0;
    for (const DomainPlan& domain : plan.domains) all += domain.plan.machineBytes + 1;
    for (const DomainPlan& domain : plan.domains) {
        const auto part = [&](double fraction) {
            const double share = static_cast<double>(domain.plan.machineBytes + 1) * fraction;
            return goOn(progress, (static_cast<double>(done) + share) / static_cast<double>(all));
        };
        const SpeciesVolume own =
            resample(*domain.dataset, domain.time, {domain.plan, common}, part);
        composeDomain(own, domain.at, domain.edges, plan.at, result,
                      [&](double) { return part(1.0); });
        done += domain.plan.machineBytes + 1;
        if (domain.name.empty()) {
            result.timeLabel = own.timeLabel;
            result.timeSeconds = own.timeSeconds;
        }
        for (const std::string& note : own.notes) {
            if (std::ranges::find(result.notes, note) != result.notes.end()) continue;
            result.notes.push_back(domain.name.empty() ? note : domain.name + ": " + note);
        }
    }
    result.notes.insert(result.notes.end(), plan.notes.begin(), plan.notes.end());
    return result;
}

}  // namespace neph
