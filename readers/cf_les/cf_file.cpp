// cf_file.cpp: describes a data set, step by step; describe() states the order.
#include "readers/cf_les/cf_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "readers/cf_les/map_file.h"
#include "readers/cf_les/place.h"
#include "readers/cf_les/times.h"
#include "readers/cf_les/variables.h"
#include "readers/les/cm1_run.h"
#include "readers/les/names.h"
#include "readers/les/revolve.h"
#include "readers/les/text.h"

namespace cf {
namespace {

namespace fs = std::filesystem;
namespace plugin = neph::plugin;

bool hasWater(const nc::NcFile& file, const Model& model) {
    const Axes axes(file, model);
    return std::ranges::any_of(file.variables(), [&](const nc::NcVariable& variable) {
        return isWater(file, variable, model, axes);
    });
}

/// The row that a file belongs to: the first whose marks it has, of those the first with
/// hydrometeors. Null if there is none; plain CF counts only with hydrometeors.
const Model* rowOf(const nc::NcFile& file) {
    const Model* first = nullptr;
    for (const Model& model : models()) {
        if (!isOf(file, model)) continue;
        if (hasWater(file, model)) return &model;
        const bool plain = &model == &models().back();
        if (first == nullptr && !plain) first = &model;
    }
    return first;
}

/// Builds the description of one data set.
class Describer {
  public:
    Describer(Model model, std::string mapPath)
        : model_(std::move(model)), mapPath_(std::move(mapPath)) {}
    std::unique_ptr<plugin::File> open(std::unique_ptr<nc::NcFile> opened);

  private:
    void readRun(const nc::NcFile& file);
    void requireWholeDomain(const nc::NcFile& file, const Grid& grid) const;
    void dropOtherTimes(FileSet& files, const Times& times);
    void describeModel(const nc::NcFile& file);
    void describeTimes(const nc::NcFile& file, const Times& times);
    void describeGrid(const Grid& grid);
    void noteLacking();

    std::string path_{};
    Model model_;
    std::string mapPath_;
    les::Cm1Run run_;
    les::Contents contents_;
};

/// CM1 states its scheme by number; the rest is in the namelist beside the file.
void Describer::readRun(const nc::NcFile& file) {
    const auto number = file.number("ptype");
    if (number && std::abs(*number) <= 1000.0) run_ = les::cm1RunOf(static_cast<int>(*number));
    run_.axisymmetric = file.number("axisymm") == 1.0;
    if (model_.version != "CM1 version") return;
    const auto namelist =
        les::findText((fs::path(path_).parent_path() / "namelist.input").string());
    if (namelist) {
        les::Cm1Run stated = les::parseCm1Namelist(*namelist);
        if (number && stated.scheme != run_.scheme) {
            contents_.description.notes.push_back(
                fmt::format("namelist.input is not that of this run ({} there, {} in the file).",
                            stated.scheme, run_.scheme));
            return;
        }
        run_ = std::move(stated);
        return;
    }
    if ((number != 5.0 && number != 2.0) || named(file, "qg") == nullptr) return;
    contents_.description.notes.emplace_back(
        "qg is taken as graupel: whether it is hail (ihail = 1) stands in namelist.input, which is "
        "not beside the file.");
}

/// CM1 states the size of the whole domain.
void Describer::requireWholeDomain(const nc::NcFile& file, const Grid& grid) const {
    if (model_.version != "CM1 version") return;
    const auto nx = file.number("nx"), ny = file.number("ny");
    if (!nx || !ny) return;
    const auto cells = [](std::size_t count) { return static_cast<double>(count); };
    if (*nx == cells(grid.stored[0]) && *ny == cells(grid.stored[1])) return;
    throw nc::Failure{
        "is a part of its domain: the tile of one MPI rank, or a cut",
        fmt::format("{} x {} columns", grid.stored[0], grid.stored[1]),
        fmt::format("{:.0f} x {:.0f} columns, which its attributes nx and ny state", *nx, *ny),
        "put the tiles of all ranks into its folder, or run CM1 with output_filetype "
        "= 2; of a cut, set nx and ny: ncatted -a nx,global,m,i,N FILE"};
}

/// Files beside the first belong to it only if they have its times.
void Describer::dropOtherTimes(FileSet& files, const Times& times) {
    files.dropFiles([&](const nc::NcFile& file) {
        bool same = false;
        try {
            const Axes axes(file, model_);
            std::string dimension;
            for (const nc::NcVariable& variable : file.variables()) {
                const auto layout = axes.layoutOf(variable);
                if (layout && layout->isField() && layout->time) {
                    dimension = variable.axes[*layout->time].name;
                }
            }
            const Times own = timesOf(file, dimension);
            same = std::ranges::equal(own.times, times.times, {}, &plugin::Time::seconds,
                                      &plugin::Time::seconds);
        } catch (const nc::Failure&) {  // without times that can be read
        }
        if (!same) {
            contents_.description.notes.push_back(fmt::format(
                "{} is not used: it has other times.", fs::path(file.path()).filename().string()));
        }
        return !same;
    });
}

void Describer::describeModel(const nc::NcFile& file) {
    plugin::Description& d = contents_.description;
    d.model = model_.title;
    const std::string version =
        model_.version.empty() ? "" : file.text(model_.version.c_str()).value_or("");
    if (!version.empty()) {
        d.model += " " + (version.starts_with("cm1") ? version.substr(3) : version);
    }
    d.scheme = run_.scheme;
    d.microphysics = run_.microphysics;
    d.cloudDropletsPerM3 = run_.cloudDropletsPerM3;
    for (const char* name : {"title", "source", "institution", "history"}) {
        const auto text = file.text(name);
        if (text && !text->empty()) d.attributes.emplace_back(name, *text);
    }
    if (model_.periodic) contents_.notePeriodicSides(model_.title);
    if (!mapPath_.empty()) {
        d.notes.push_back(fmt::format("Names and units are those of {}.",
                                      fs::path(mapPath_).filename().string()));
    }
}

/// Times, and where CM1's grid has gone by them: it moves with umove and vmove from the start.
void Describer::describeTimes(const nc::NcFile& file, const Times& times) {
    plugin::Description& d = contents_.description;
    d.times = times.times;
    for (const std::string& note : times.notes) d.notes.push_back(note);
    const std::array<const char*, 2> names{"umove", "vmove"};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const nc::NcVariable* speed =
            model_.version == "CM1 version" ? named(file, names[axis]) : nullptr;
        if (speed == nullptr || !speed->number || speed->axes.size() != 1) continue;
        const auto toSi = shared::conversion(speed->units, "m s-1");
        for (std::size_t i = 0; toSi && i < d.times.size() && !times.dated; ++i) {
            if (times.records[i] >= speed->axes[0].length) break;
            const std::array<std::size_t, 1> start{times.records[i]}, count{1};
            const double mPerS = (*toSi)(file.readDoubles(*speed, start, count).front());
            if (std::abs(mPerS) < 1000.0) d.times[i].gridOffsetM[axis] = mPerS * d.times[i].seconds;
        }
    }
}

void Describer::describeGrid(const Grid& grid) {
    plugin::Description& d = contents_.description;
    for (std::size_t axis = 0; axis < 3; ++axis) d.size[axis] = static_cast<int>(grid.size[axis]);
    d.spacingM = grid.spacingM;
    d.edgesM = grid.edgesM;
}

/// Hydrometeors that the scheme has and the file lacks.
void Describer::noteLacking() {
    std::vector<std::string> lacking;
    for (const std::string& name : run_.hydrometeors) {
        const auto& variables = contents_.description.variables;
        if (std::ranges::find(variables, name, &plugin::Variable::name) != variables.end())
            continue;
        const les::KnownVariable* known = les::findKnown(name);
        lacking.push_back(
            fmt::format("{} ({})", name,
                        les::speciesName(known != nullptr ? known->species : NEPH_SPECIES_NONE)));
    }
    if (lacking.empty()) return;
    contents_.description.notes.push_back(
        fmt::format("The scheme {} has hydrometeors that are not in the file, so they are not "
                    "drawn: {}.",
                    run_.scheme, les::joined(lacking)));
}

std::unique_ptr<plugin::File> Describer::open(std::unique_ptr<nc::NcFile> opened) {
    path_ = opened->path();
    auto data = std::make_shared<DataSet>(std::move(opened), model_);
    const nc::NcFile& file = data->files.main();
    readRun(file);
    plugin::Description& d = contents_.description;
    data->grid = gridOf(data->files, model_, d.notes);
    requireWholeDomain(file, data->grid);
    std::string dimension;
    for (const Stored& each : data->files.variables()) {
        if (each.file != 0 || !each.layout.isField() || !each.layout.time) continue;
        dimension = each.variable->axes[*each.layout.time].name;
        break;
    }
    const Times times = timesOf(file, dimension);
    dropOtherTimes(data->files, times);
    data->records = times.records;
    describeModel(file);
    describeTimes(file, times);
    describeGrid(data->grid);
    addPlace(data->files, data->grid, times, d);
    d.parts = data->files.parts();
    if (!mapPath_.empty()) d.parts.push_back(mapPath_);
    addVariables(data, run_.hail, contents_);
    noteLacking();
    auto described = les::makeFile(std::move(contents_));
    return run_.axisymmetric ? les::revolved(std::move(described)) : std::move(described);
}

}  // namespace

int scoreOf(const std::string& path) {
    constexpr int kModel = 95, kPlain = 60, kWithoutWater = 7;
    if (nc::containerOf(path) == nc::Container::unknown) return 0;
    if (mapBeside(path)) return kModel;
    const nc::NcFile file(path);
    const Model* row = rowOf(file);
    if (row == nullptr) return 0;
    if (!hasWater(file, *row)) return kWithoutWater;
    return row == &models().back() ? kPlain : kModel;
}

std::unique_ptr<plugin::File> openFile(const std::string& path, const std::string& map) {
    auto file = std::make_unique<nc::NcFile>(path);
    const std::string chosen = map.empty() ? mapBeside(path).value_or("") : map;
    if (!chosen.empty()) return Describer(readMap(chosen), chosen).open(std::move(file));
    const Model* row = rowOf(*file);
    if (row == nullptr) {
        throw nc::Failure{"is NetCDF of no model that is known",
                          {},
                          "output of CM1, SAM, DALES, PALM, MONC, UCLALES, MicroHH or Meso-NH, or "
                          "standard names of CF",
                          "say what its variables are in a nephoscope-map: docs/readers.md"};
    }
    return Describer(*row, "").open(std::move(file));
}

}  // namespace cf
