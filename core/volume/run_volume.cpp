// run_volume.cpp: members one after the other, so that two volumes are in memory at most.
#include "core/volume/run_volume.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/volume/nested_volume.h"

namespace neph {
namespace {

constexpr double kPlanShare = 0.05;

Progress partOf(const Progress& progress, double from, double to) {
    return
        [&progress, from, to](double share) { return goOn(progress, from + (to - from) * share); };
}

/// Lowest and highest level of the whole domain; a region may cover only some of them.
glm::dvec2 domainHeights(Dataset& dataset, int time, const VolumeRequest& request,
                         const ReadPlan& plan, const std::optional<NativeLevels>& levels,
                         const Progress& progress) {
    const bool cut = request.region && (std::isfinite(request.region->lowerM.z) ||
                                        std::isfinite(request.region->upperM.z));
    const RegularGrid grid =
        cut ? planShown(dataset, time, {}, {}, progress, levels).grid : plan.grid;
    return {grid.originM.z, grid.upperM().z};
}

RunVolume readRun(Dataset& dataset, int time, const VolumeRequest& request,
                  const std::optional<NativeLevels>& levels, const Progress& progress) {
    const Progress planning = partOf(progress, 0.0, kPlanShare);
    RunVolume read;
    const NestedPlan plan =
        planNested(dataset, time, request.region, request.budget, planning, levels);
    read.plan = plan.shown;
    read.domainHeightsM = domainHeights(dataset, time, request, read.plan, levels, planning);
    read.volume = readNested(dataset, time, plan, request.radii, partOf(progress, kPlanShare, 1.0));
    return read;
}

/// Notes of a mean: those that hold for every member are said when a member is shown.
std::vector<std::string> meanNotes(const Ensemble& ensemble, int time, const VolumeRequest& request,
                                   const std::string& label) {
    std::vector<std::string> notes = request.radii.notes;
    std::vector<std::string> lacking;
    for (int member = 0; member < ensemble.count(); ++member) {
        if (!ensemble.timeIn(member, time)) lacking.push_back(ensemble.nameOf(member));
    }
    const std::size_t used = ensemble.membersAt(time).size();
    notes.push_back(fmt::format(
        "{}: the mean of {} members is smoother than any of them: its thin cloud is where some "
        "members have cloud, and not a cloud that could be.",
        label, used));
    if (!lacking.empty()) {
        notes.push_back(fmt::format("{}: the mean is without {}, which {} no such time.", label,
                                    fmt::join(lacking, ", "),
                                    lacking.size() == 1 ? "has" : "have"));
    }
    return notes;
}

RunVolume readMean(Ensemble& ensemble, int time, const VolumeRequest& request,
                   const Progress& progress) {
    const std::vector<int> members = ensemble.membersAt(time);
    const auto count = static_cast<double>(members.size());
    MeanVolume mean;
    RunVolume first;
    for (const int member : members) {
        const double done = mean.count();
        RunVolume read = readMember(ensemble, member, time, request,
                                    partOf(progress, done / count, (done + 1.0) / count));
        if (mean.count() == 0) {
            first.plan = read.plan;
            first.domainHeightsM = read.domainHeightsM;
        }
        mean.add(std::move(read.volume), ensemble.nameOf(member));
    }
    first.volume = mean.take();
    const TimeInfo& when = ensemble.info().times[static_cast<std::size_t>(time)];
    first.volume.timeLabel = when.label;
    first.volume.timeSeconds = when.seconds;
    first.volume.notes = meanNotes(ensemble, time, request, when.label);
    return first;
}

/// Adds `next` to the mean of `before` fields, field by field; an empty one is zero.
void addField(Array3f& mean, Array3f next, glm::ivec3 size, int before) {
    if (mean.empty() && next.empty()) return;
    if (mean.empty()) mean = Array3f(size);
    const auto share = static_cast<float>(1.0 / (before + 1));
    for (std::size_t i = 0; i < mean.values.size(); ++i) {
        const float value = next.empty() ? 0.0f : next.values[i];
        mean.values[i] += (value - mean.values[i]) * share;
    }
}

/// The mean of what some of `values` state, and the first reason of those that do not.
void addMean(std::optional<double>& mean, const std::vector<std::optional<double>>& values) {
    double sum = 0.0;
    int known = 0;
    for (const std::optional<double>& value : values) {
        sum += value.value_or(0.0);
        known += value ? 1 : 0;
    }
    if (known > 0) mean = sum / known;
}

}  // namespace

NativeLevels sharedLevels(Ensemble& ensemble, int time, const Progress& progress) {
    if (const auto known = ensemble.knownLevels(time)) return *known;
    std::optional<NativeLevels> shared;
    for (const int member : ensemble.membersAt(time)) {
        const NativeLevels own =
            readLevels(ensemble.run(member), *ensemble.timeIn(member, time), progress);
        if (!shared) shared = own;
        shared->lowestM = std::min(shared->lowestM, own.lowestM);
        shared->highestM = std::max(shared->highestM, own.highestM);
    }
    ensemble.keepLevels(time, *shared);
    return *shared;
}

RunVolume readMember(Ensemble& ensemble, int member, int time, const VolumeRequest& request,
                     const Progress& progress) {
    const auto own = ensemble.timeIn(member, time);
    if (!own) throw ensemble.lacking(member, time);
    const NativeLevels levels = sharedLevels(ensemble, time, partOf(progress, 0.0, kPlanShare));
    RunVolume read = readRun(ensemble.run(member), *own, request, levels, progress);
    read.volume.timeSeconds = ensemble.info().times[static_cast<std::size_t>(time)].seconds;
    return read;
}

RunVolume readRuns(Dataset& dataset, int time, const VolumeRequest& request,
                   const Progress& progress) {
    Ensemble* ensemble = ensembleOf(dataset);
    if (ensemble == nullptr) return readRun(dataset, time, request, {}, progress);
    if (request.member == kMeanMember) return readMean(*ensemble, time, request, progress);
    return readMember(*ensemble, request.member, time, request, progress);
}

LowestAir readLowestAirOf(Dataset& dataset, int time, int member, const Progress& progress) {
    Ensemble* ensemble = ensembleOf(dataset);
    if (ensemble == nullptr) return readLowestAir(dataset, time, progress);
    const auto airOf = [&](int which) {
        const auto own = ensemble->timeIn(which, time);
        if (!own) throw ensemble->lacking(which, time);
        return readLowestAir(ensemble->run(which), *own, progress);
    };
    if (member != kMeanMember) return airOf(member);
    LowestAir mean;
    std::vector<std::optional<double>> humidity, aerosol;
    for (const int which : ensemble->membersAt(time)) {
        const LowestAir air = airOf(which);
        humidity.push_back(air.humidity);
        aerosol.push_back(air.aerosolPerM);
        mean.reason = air.reason;
        mean.noAerosol = air.noAerosol;
    }
    addMean(mean.humidity, humidity);
    addMean(mean.aerosolPerM, aerosol);
    return mean;
}

void requireSameGrid(const RegularGrid& grid, const RegularGrid& expected,
                     const std::string& member) {
    if (grid == expected) return;
    const auto text = [](const RegularGrid& one) {
        return fmt::format("{} x {} x {} cells, moved by {:.6g} m, {:.6g} m", one.size.x,
                           one.size.y, one.size.z, one.movedM.x, one.movedM.y);
    };
    throw Error({.where = "member " + member,
                 .what = "lies elsewhere at this time than the other members",
                 .found = text(grid),
                 .expected = text(expected),
                 .hint = "members whose grids move apart can be shown one by one, and have no mean "
                         "or map"});
}

void MeanVolume::add(SpeciesVolume volume, const std::string& member) {
    if (count_ == 0) {
        mean_ = std::move(volume);
        count_ = 1;
        return;
    }
    requireSameGrid(volume.grid, mean_.grid, member);
    for (std::size_t s = 0; s < kSpeciesCount; ++s) {
        const auto species = static_cast<Species>(s);
        if (volume.has(species) && mean_.has(species) &&
            volume.holding(species) != mean_.holding(species)) {
            throw Error({.where = "member " + member,
                         .what = fmt::format("does not state the particle sizes of {} as others do",
                                             info(species).label),
                         .hint = fmt::format("for the mean, --set {}.radius_source=constant",
                                             info(species).id)});
        }
        addField(mean_.contentKgPerM3[s], std::move(volume.contentKgPerM3[s]), mean_.grid.size,
                 count_);
        addField(mean_.extinctionPerM[s], std::move(volume.extinctionPerM[s]), mean_.grid.size,
                 count_);
    }
    ++count_;
}

SpeciesVolume MeanVolume::take() {
    mean_.notes.clear();
    count_ = 0;
    return std::exchange(mean_, {});
}

}  // namespace neph
