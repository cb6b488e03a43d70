// grads_contents.cpp: turns a parsed descriptor into a description: checks the data files, and
// recognises model, grid, times and variables.
#include "readers/raw_les/grads_contents.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>

#include "readers/les/cm1_run.h"
#include "readers/les/levels.h"
#include "readers/les/revolve.h"
#include "readers/raw_les/cm1.h"
#include "readers/raw_les/grads_data.h"
#include "readers/raw_les/grads_roles.h"
#include "readers/raw_les/plausible.h"

namespace les {
namespace {

namespace fs = std::filesystem;
namespace plugin = neph::plugin;

/// Builds the description of one descriptor, step by step; describe() states the order.
class GradsContents {
  public:
    GradsContents(const std::string& ctlPath, Ctl ctl)
        : ctlPath_(ctlPath), folder_(folderOf(ctlPath)), ctl_(std::move(ctl)) {}
    Contents describe();
    bool axisymmetric() const { return run_.axisymmetric; }

  private:
    void requireModelOutput() const;
    void describeModel();
    void requireLevels() const;
    void settleAxis();
    void describeGrid();
    /// Spacing of an axis; negative if it decreases. Sets faces of cells that are not even.
    double describeAxis(std::size_t axis, const char* name, const CtlAxis& from);
    void settleNumbers();
    /// The variables that are known, as they are stored at `times[i]`.
    std::vector<Probe> probesAt(std::size_t i, bool airOnly) const;
    void describeTimes();
    void addVariables();
    void addTerrain();
    void noteMissing();
    void noteCompanions();

    fs::path ctlPath_, folder_;
    Ctl ctl_;
    Cm1Run run_;
    bool cm1_ = false, namelist_ = false;
    bool flipY_ = false, flipZ_ = false;
    std::shared_ptr<GradsData> data_;
    Terrain terrain_;
    Contents contents_;
};

/// Throws Error unless there is a hydrometeor on the grid, with the descriptor to open instead.
void GradsContents::requireModelOutput() const {
    std::vector<std::string> names;
    for (const CtlVariable& variable : ctl_.variables) names.push_back(variable.name);
    const std::string scalars = (folder_ / "cm1out_s.ctl").string();
    const std::string hint = fileSize(scalars) && ctlPath_.filename() != "cm1out_s.ctl"
                                 ? "open " + scalars + " in the same folder"
                                 : "open the descriptor of the model's scalars, CM1's cm1out_s.ctl";
    if (std::ranges::find(ctl_.variables, "mtime", &CtlVariable::name) != ctl_.variables.end() &&
        ctl_.x.count * ctl_.y.count == 1) {
        throw Error{"is CM1's list of times, not its output", joined(names),
                    "hydrometeors on a grid", hint};
    }
    if (hasHydrometeor(ctl_)) return;
    // CM1 writes winds, which are on staggered grids, with descriptors of their own.
    const bool winds = std::ranges::all_of(ctl_.variables, [](const CtlVariable& variable) {
        return std::string_view("uvw").find(toLower(variable.name).front()) != std::string::npos;
    });
    throw Error{winds ? "contains only staggered winds" : "no variable is a hydrometeor",
                joined(names), "at least one of " + knownHydrometeors(), hint};
}

/// Version from the title, "CM1 … using version cm1r21.1"; microphysics from namelist.input.
void GradsContents::describeModel() {
    plugin::Description& d = contents_.description;
    const std::size_t version = ctl_.title.find("using version ");
    cm1_ = ctl_.title.find("CM1") != std::string::npos;
    const bool wrf = ctl_.title.find("WRF") != std::string::npos;
    d.model = cm1_ ? "CM1" : wrf ? "WRF (GrADS binary)" : "GrADS binary";
    if (cm1_ && version != std::string::npos) {
        const std::string rest = ctl_.title.substr(version + 14);
        const std::string word = rest.substr(0, rest.find_first_of(",; "));
        d.model = "CM1 " + (word.starts_with("cm1") ? word.substr(3) : word);
    }
    if (const auto text = findText((folder_ / "namelist.input").string()); cm1_ && text) {
        run_ = parseCm1Namelist(*text);
        namelist_ = true;
    }
    d.scheme = run_.scheme;
    d.microphysics = run_.microphysics;
    d.cloudDropletsPerM3 = run_.cloudDropletsPerM3;
    if (!ctl_.title.empty()) d.attributes.emplace_back("title", ctl_.title);
    d.attributes.emplace_back("descriptor", ctlPath_.filename().string());
}

/// Throws Error where z is not that of the model's own levels.
void GradsContents::requireLevels() const {
    const std::string name = ctlPath_.filename().string();
    if (!cm1_ || !name.ends_with("_i.ctl")) return;
    throw Error{
        "its fields are interpolated from levels that follow terrain to the nominal heights", name,
        "the fields on the levels of the model",
        "open " + name.substr(0, name.size() - 6) + "_s.ctl of the same run"};
}

/// Throws Error where x is the radius and does not start at the axis. Notes where it could be.
void GradsContents::settleAxis() {
    if (ctl_.y.count != 1 || ctl_.x.count < 2) return;
    const double width = contents_.description.edgesM[0].empty()
                             ? contents_.description.spacingM[0]
                             : contents_.description.edgesM[0][1];
    const double first = *ctl_.metresPerUnit * ctl_.x.at(0);
    const bool fromAxis = std::abs(first - 0.5 * width) <= 0.02 * width;
    if (run_.axisymmetric && !fromAxis) {
        throw Error{"is axisymmetric, but xdef does not start at the axis",
                    fmt::format("the first centre at {:.6g} m", first),
                    fmt::format("{:.6g} m, half a cell", 0.5 * width),
                    "keep all columns from the axis outwards"};
    }
    if (!cm1_ || namelist_ || !fromAxis) return;
    contents_.description.notes.emplace_back(
        "One row of columns is taken as a slab, because no namelist.input says otherwise. If the "
        "run is axisymmetric, put its namelist.input (axisymm = 1) beside the .ctl.");
}

double GradsContents::describeAxis(std::size_t axis, const char* name, const CtlAxis& from) {
    std::vector<double> centres;
    for (std::size_t i = 0; i < from.count; ++i) {
        centres.push_back(*ctl_.metresPerUnit * from.at(i));
    }
    if (const auto step = evenStep(centres)) return *step;
    const bool down = centres[1] < centres[0];
    if (down) std::ranges::reverse(centres);  // described from south to north
    std::vector<double> faces = facesOf(name, centres);
    double least = faces[1];
    for (std::size_t i = 1; i < faces.size(); ++i) least = std::min(least, faces[i] - faces[i - 1]);
    contents_.description.edgesM[axis] = std::move(faces);
    // The positions are printed with six digits.
    least = parseNumber(fmt::format("{:.5g}", least)).value_or(least);
    return down ? -least : least;
}

/// Spacing, interfaces and orientation. GrADS has no unit of length for its axes, so a descriptor
/// without a stated one is an Error rather than a guess.
void GradsContents::describeGrid() {
    if (!ctl_.metresPerUnit) {
        const bool wrf = ctl_.title.find("WRF") != std::string::npos;
        throw Error{
            "the unit of xdef, ydef and zdef is not stated",
            ctl_.title.empty() ? "no title" : "title " + inQuotes(ctl_.title),
            "\"units of x,y,z are km\" or \"… m\" in the title, as CM1 writes it",
            std::string(wrf ? std::string(kOpenWrfout) + "; or, if x, y and z are lengths, " : "") +
                "add the comment line '* units of x,y,z are m' (or km) to the .ctl"};
    }
    const double dx = describeAxis(0, "xdef", ctl_.x);
    const double dy = describeAxis(1, "ydef", ctl_.y);
    if (dx < 0.0) {
        throw Error{
            "xdef decreases", fmt::format("a step of {} m", dx), "x increasing eastwards", {}};
    }
    flipY_ = ctl_.yrev != (dy < 0.0);
    // A two-dimensional run has a single cell in one direction; its spacing is taken from the
    // other.
    const double one = dx > 0.0 ? dx : std::abs(dy);
    contents_.description.spacingM = {one, dy != 0.0 ? std::abs(dy) : one};
    std::vector<double> centres;
    for (std::size_t k = 0; k < ctl_.z.count; ++k) {
        centres.push_back(*ctl_.metresPerUnit * ctl_.z.at(k));
    }
    const bool down = centres.size() > 1 && centres[1] < centres[0];
    if (down) std::ranges::reverse(centres);
    flipZ_ = ctl_.zrev != down;
    contents_.interfacesM = interfacesOf(centres);
    contents_.description.size = {static_cast<int>(ctl_.x.count), static_cast<int>(ctl_.y.count),
                                  static_cast<int>(ctl_.z.count)};
    if (one > 0.0) return;
    throw Error{"the grid has a single column", {}, "at least two cells in x or y", {}};
}

std::vector<Probe> GradsContents::probesAt(std::size_t i, bool airOnly) const {
    std::vector<Probe> probes;
    std::uint64_t start = 0;
    for (const CtlVariable& variable : ctl_.variables) {
        const KnownVariable* known = findKnown(variable.name);
        const auto conversion =
            known != nullptr ? toSi(known->quantity, variable.unit) : std::nullopt;
        const bool air = known != nullptr && (known->quantity == Quantity::pressure ||
                                              known->quantity == Quantity::temperature ||
                                              known->quantity == Quantity::density);
        if (conversion && variable.levels > 0 && (air || !airOnly)) {
            RawField field = data_->fieldAt(i, start);
            field.size[2] = variable.planes();
            field.scale = conversion->scale;
            field.offset = conversion->offset;
            probes.push_back({field, known->quantity});
        }
        start += variable.planes();
    }
    return probes;
}

/// Holds a sample of the numbers against what is possible: for the byte order, and, if the file has
/// another size than stated, for whether the descriptor fits at all.
void GradsContents::settleNumbers() {
    constexpr std::size_t kEnough = 64;
    const std::size_t last = data_->times.size() - 1;
    Shares shares = sharesOf(probesAt(0, false));
    for (const std::size_t i : {last, last / 2}) {
        if (shares.sampled < kEnough && i > 0) shares = sharesOf(probesAt(i, false));
    }
    const bool big = (std::endian::native == std::endian::big) != data_->isSwapped();
    if (isOtherOrder(shares) && !ctl_.sequential) {
        if (ctl_.byteOrder != ByteOrder::unstated) {
            throw Error{"its numbers do not have the byte order that the descriptor states",
                        sharesText(shares, big),
                        fmt::format("{}-endian numbers", big ? "big" : "little"),
                        fmt::format("write '{}' into the options of the .ctl, in place of "
                                    "big_endian, little_endian or byteswapped",
                                    big ? "little_endian" : "big_endian"),
                        dataPath(ctl_, folder_, data_->times.front())};
        }
        data_->swap();
        data_->notes.push_back(fmt::format(
            "The descriptor does not state the byte order: {}, so {}-endian is assumed.",
            sharesText(shares, big), big ? "little" : "big"));
    }
    if (!data_->sizeFault) return;
    for (const std::size_t i : {std::size_t{0}, last}) {
        const Shares air = sharesOf(probesAt(i, true));
        if (air.sampled < kEnough || air.asStated < 1.0) throw *data_->sizeFault;
    }
}

/// Times from cm1out_metadata for CM1, from tdef for other models.
void GradsContents::describeTimes() {
    auto& d = contents_.description;
    const auto known = cm1_ ? cm1Times(folder_.string(), data_->isSwapped()) : std::nullopt;
    if (known && data_->times.back() < known->seconds.size()) {
        const auto offsetsM = cm1Offsets(*known, run_);
        for (const std::size_t i : data_->times) {
            const double seconds = known->seconds[i];
            d.times.push_back({fmt::format("{:.6g} s", seconds), seconds, offsetsM[i]});
        }
        return;
    }
    if (cm1_) {
        d.notes.push_back(
            known ? "cm1out_metadata does not contain all times: times are numbered, not in "
                    "seconds."
                  : "cm1out_metadata is missing or cannot be read: times are numbered, not in "
                    "seconds.");
    }
    for (const std::size_t i : data_->times) {
        if (cm1_) {
            d.times.push_back({fmt::format("time {}", i + 1), static_cast<double>(i)});
        } else {
            const CalendarTime time = ctl_.t.at(i);
            d.times.push_back({labelOf(time), static_cast<double>(minutesOf(time)) * 60.0});
        }
    }
}

void GradsContents::addVariables() {
    GradsRoles roles(ctl_.z.count, run_.hail);
    std::uint64_t start = 0;
    for (const CtlVariable& variable : ctl_.variables) {
        const auto meaning = roles.meaningOf(variable);
        const shared::Conversion toSi = meaning ? meaning->toSi : shared::Conversion{};
        const std::size_t planes = variable.planes();
        Source source = storedAt([=, data = std::shared_ptr<const GradsData>(data_), flipY = flipY_,
                                  flipZ = flipZ_](std::size_t time) {
            RawField field = data->fieldAt(time, start);
            field.size[2] = planes;
            field.flipY = flipY;
            field.flipZ = flipZ;
            field.scale = toSi.scale;
            field.offset = toSi.offset;
            return field;
        });
        roles.add(variable, meaning, std::move(source), contents_);
        start += planes;
    }
    roles.finish(contents_);
    terrain_ = roles.terrain();
}

/// Levels of CM1 follow the terrain; of other models' only heights of cells show that they do.
void GradsContents::addTerrain() {
    Terrain terrain = terrain_;
    if (!cm1_ && !terrain.cellHeight && terrain.ground) {
        if (!isFlat(contents_, terrain)) {
            contents_.description.notes.emplace_back(
                "zs, the height of the ground, is not used: zdef is taken as heights above sea "
                "level. Heights of cells that follow the terrain are read from a variable zh.");
        }
        terrain.ground.reset();
    }
    if (!terrain.ground && !terrain.cellHeight) {
        if (!run_.terrain) return;
        throw Error{
            "its levels follow terrain whose height is not in the files",
            "terrain_flag = .true. in namelist.input, and neither zs nor zh among the "
            "variables",
            "zs, the height of the ground, or zh, that of every cell",
            "run CM1 with output_zs = 1 or output_zh = 1 (section param9 of namelist.input)"};
    }
    if (!isFlat(contents_, terrain)) addTerrainHeights(contents_, terrain);
}

/// Notes hydrometeors of the scheme that are not in the file.
void GradsContents::noteMissing() {
    std::vector<std::string> missing;
    for (const std::string& name : run_.hydrometeors) {
        const bool there = std::ranges::any_of(ctl_.variables, [&](const CtlVariable& variable) {
            return toLower(variable.name) == name;
        });
        if (there) continue;
        const KnownVariable* known = findKnown(name);
        missing.push_back(fmt::format(
            "{} ({})", name, speciesName(known != nullptr ? known->species : NEPH_SPECIES_NONE)));
    }
    if (missing.empty()) return;
    contents_.description.notes.push_back(
        fmt::format("The scheme {} has hydrometeors that are not in the file, so they are not "
                    "drawn: {}.",
                    run_.scheme, joined(missing)));
}

/// Notes the staggered winds of the same run, so that nobody looks for them among the variables.
void GradsContents::noteCompanions() {
    const std::string name = ctlPath_.filename().string();
    if (!name.ends_with("_s.ctl")) return;
    std::vector<std::string> found;
    for (const char* suffix : {"_u.ctl", "_v.ctl", "_w.ctl"}) {
        const std::string companion = name.substr(0, name.size() - 6) + suffix;
        if (fileSize((folder_ / companion).string())) found.push_back(companion);
    }
    if (found.empty()) return;
    contents_.description.notes.push_back(fmt::format(
        "Files with staggered winds in the same folder are not read: {}.", joined(found)));
}

Contents GradsContents::describe() {
    requireModelOutput();
    describeModel();
    requireLevels();
    describeGrid();
    settleAxis();
    data_ = std::make_shared<GradsData>(ctl_, folder_);
    settleNumbers();
    for (const std::string& note : data_->notes) contents_.description.notes.push_back(note);
    contents_.description.parts = data_->paths();
    describeTimes();
    addVariables();
    addTerrain();
    noteMissing();
    noteCompanions();
    contents_.completeAir();
    return std::move(contents_);
}

}  // namespace

std::unique_ptr<plugin::File> makeGrads(const std::string& ctlPath, Ctl ctl) {
    GradsContents contents(ctlPath, std::move(ctl));
    auto file = makeFile(contents.describe());
    return contents.axisymmetric() ? revolved(std::move(file)) : std::move(file);
}

bool hasHydrometeor(const Ctl& ctl) {
    return std::ranges::any_of(ctl.variables, [](const CtlVariable& variable) {
        const KnownVariable* known = findKnown(variable.name);
        return known != nullptr && known->role == NEPH_ROLE_MIXING_RATIO && variable.levels > 0;
    });
}

}  // namespace les
