// grads_file.cpp: turns a parsed descriptor into a description: checks the data files, and
// recognises model, grid, times and variables.
#include "readers/raw_les/grads_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "readers/raw_les/cm1.h"
#include "readers/raw_les/grads_data.h"
#include "readers/raw_les/levels.h"

namespace raw {
namespace {

namespace fs = std::filesystem;
namespace plugin = neph::plugin;

/// Builds the description of one descriptor, step by step; describe() states the order.
class GradsFile {
  public:
    explicit GradsFile(const std::string& ctlPath)
        : ctlPath_(ctlPath), folder_(folderOf(ctlPath)), ctl_(parseCtl(readText(ctlPath))) {}
    Contents describe();

  private:
    void requireModelOutput() const;
    void describeModel();
    void describeGrid();
    void describeTimes();
    void addVariable(const CtlVariable& variable, std::uint64_t planesBefore);
    /// Sets role, species and unit of `entry`, and the factor to SI, if the name is known. Null
    /// otherwise. Throws Error for an unknown unit.
    const KnownVariable* identify(const CtlVariable& variable, plugin::Variable& entry,
                                  double& scale);
    void noteCompanions();

    fs::path ctlPath_, folder_;
    Ctl ctl_;
    Cm1Run run_;
    bool cm1_ = false;
    bool flipY_ = false, flipZ_ = false;
    std::shared_ptr<const GradsData> data_;
    Contents contents_;
};

/// Throws Error unless there is a hydrometeor on the grid, with the descriptor to open instead.
void GradsFile::requireModelOutput() const {
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
    const bool any = std::ranges::any_of(ctl_.variables, [](const CtlVariable& variable) {
        const KnownVariable* known = findKnown(variable.name);
        return known != nullptr && known->role == NEPH_ROLE_MIXING_RATIO && variable.levels > 0;
    });
    if (any) return;
    // CM1 writes winds, which are on staggered grids, with descriptors of their own.
    const bool winds = std::ranges::all_of(ctl_.variables, [](const CtlVariable& variable) {
        return std::string_view("uvw").find(toLower(variable.name).front()) != std::string::npos;
    });
    throw Error{winds ? "contains only staggered winds" : "no variable is a hydrometeor",
                joined(names), "at least one of " + knownHydrometeors(), hint};
}

/// Version from the title, "CM1 … using version cm1r21.1"; microphysics from namelist.input.
void GradsFile::describeModel() {
    plugin::Description& d = contents_.description;
    const std::size_t version = ctl_.title.find("using version ");
    cm1_ = ctl_.title.find("CM1") != std::string::npos;
    d.model = cm1_ ? "CM1" : "GrADS binary";
    if (cm1_ && version != std::string::npos) {
        const std::string rest = ctl_.title.substr(version + 14);
        const std::string word = rest.substr(0, rest.find_first_of(",; "));
        d.model = "CM1 " + (word.starts_with("cm1") ? word.substr(3) : word);
    }
    if (const auto text = findText((folder_ / "namelist.input").string()); cm1_ && text) {
        run_ = parseCm1Namelist(*text);
    }
    d.scheme = run_.scheme;
    d.microphysics = run_.microphysics;
    d.cloudDropletsPerM3 = run_.cloudDropletsPerM3;
    if (!ctl_.title.empty()) d.attributes.emplace_back("title", ctl_.title);
    d.attributes.emplace_back("descriptor", ctlPath_.filename().string());
}

/// Spacing, interfaces and orientation. GrADS has no unit of length for its axes, so a descriptor
/// without a stated one is an Error rather than a guess.
void GradsFile::describeGrid() {
    if (!ctl_.metresPerUnit) {
        throw Error{"the unit of xdef, ydef and zdef is not stated",
                    ctl_.title.empty() ? "no title" : "title " + inQuotes(ctl_.title),
                    "\"units of x,y,z are km\" or \"… m\" in the title, as CM1 writes it",
                    "add the comment line '* units of x,y,z are m' (or km) to the .ctl"};
    }
    const double metres = *ctl_.metresPerUnit;
    const auto spacing = [&](const char* name, const CtlAxis& axis) {
        return metres * evenSpacing(name, axis.count, [&](std::size_t i) { return axis.at(i); });
    };
    const double dx = spacing("xdef", ctl_.x);
    const double dy = spacing("ydef", ctl_.y);
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
    for (std::size_t k = 0; k < ctl_.z.count; ++k) centres.push_back(metres * ctl_.z.at(k));
    const bool down = centres.size() > 1 && centres[1] < centres[0];
    if (down) std::ranges::reverse(centres);
    flipZ_ = ctl_.zrev != down;
    contents_.interfacesM = interfacesOf(centres);
    contents_.description.size = {static_cast<int>(ctl_.x.count), static_cast<int>(ctl_.y.count),
                                  static_cast<int>(ctl_.z.count)};
    if (one > 0.0) return;
    throw Error{"the grid has a single column", {}, "at least two cells in x or y", {}};
}

/// Times from cm1out_metadata for CM1, from tdef for other models.
void GradsFile::describeTimes() {
    auto& d = contents_.description;
    const auto seconds = cm1_ ? cm1Seconds(folder_.string()) : std::nullopt;
    if (seconds && data_->times.back() < seconds->size()) {
        for (const std::size_t i : data_->times) {
            d.times.push_back({fmt::format("{:.6g} s", (*seconds)[i]), (*seconds)[i]});
        }
        return;
    }
    if (cm1_) {
        d.notes.push_back(
            seconds ? "cm1out_metadata does not contain all times: times are numbered, not in "
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

/// A variable on fewer levels than the grid has no role, unless it is a mixing ratio, which can be
/// extended upwards by zeros.
const KnownVariable* GradsFile::identify(const CtlVariable& variable, plugin::Variable& entry,
                                         double& scale) {
    const KnownVariable* known = variable.levels > 0 ? findKnown(variable.name) : nullptr;
    if (known == nullptr) return nullptr;
    if (variable.levels < ctl_.z.count && known->role != NEPH_ROLE_MIXING_RATIO) return nullptr;
    const auto factor = siFactor(*known->quantity, variable.unit);
    if (!factor) {
        const char* accepted = acceptedUnits(*known->quantity);
        throw Error{
            fmt::format("the unit of variable {} is not known", variable.name),
            variable.unit.empty() ? std::string("none in parentheses at the end of its line")
                                  : inQuotes(variable.unit),
            accepted,
            fmt::format(
                "end the line of {} in the .ctl with ({})", variable.name,
                std::string_view(accepted).substr(0, std::string_view(accepted).find(' ')))};
    }
    scale = *factor;
    entry.role = known->role;
    entry.species = known->species;
    entry.standardName = known->standardName;
    entry.units = siUnit(*known->quantity);
    if (entry.species == NEPH_SPECIES_GRAUPEL && run_.hail) entry.species = NEPH_SPECIES_HAIL;
    return known;
}

/// `planesBefore`: horizontal planes of all variables before this one in a record.
void GradsFile::addVariable(const CtlVariable& variable, std::uint64_t planesBefore) {
    plugin::Variable entry{variable.name, "", variable.unit, variable.description};
    double scale = 1.0;
    const KnownVariable* known = identify(variable, entry, scale);
    const std::size_t planes = variable.planes();
    entry.size = contents_.description.size;
    Source source;
    if (known == nullptr) {
        entry.size[2] = static_cast<int>(planes);
    } else if (planes < ctl_.z.count) {
        source.storedLevels = planes;
        contents_.description.notes.push_back(
            fmt::format("{} has {} of {} levels: it is set to zero above them.", variable.name,
                        planes, ctl_.z.count));
    }
    if (known != nullptr && known->name == "th") {
        contents_.potentialTemperature = contents_.sources.size();
    }
    if (known != nullptr && known->name == "qv") contents_.vapour = contents_.sources.size();
    source.stored = [=, data = data_, flipY = flipY_, flipZ = flipZ_](std::size_t time) {
        RawField field = data->fieldAt(time, planesBefore);
        field.size[2] = planes;
        field.flipY = flipY;
        field.flipZ = flipZ;
        field.scale = scale;
        return field;
    };
    contents_.add(std::move(entry), std::move(source));
}

/// Notes the staggered winds of the same run, so that nobody looks for them among the variables.
void GradsFile::noteCompanions() {
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

Contents GradsFile::describe() {
    requireModelOutput();
    describeModel();
    describeGrid();
    data_ = std::make_shared<GradsData>(ctl_, folder_);
    for (const std::string& note : data_->notes) contents_.description.notes.push_back(note);
    describeTimes();
    std::uint64_t planes = 0;
    for (const CtlVariable& variable : ctl_.variables) {
        addVariable(variable, planes);
        planes += variable.planes();
    }
    noteCompanions();
    contents_.completeAir();
    return std::move(contents_);
}

}  // namespace

int scoreCtl(const std::string& path) {
    constexpr int kOther = 5;
    constexpr int kModelOutput = 80;
    const auto text = findText(path);
    if (!text || !looksLikeCtl(*text)) return 0;
    try {
        const Ctl ctl = parseCtl(*text);
        return ctl.z.count > 1 && ctl.x.count * ctl.y.count > 1 ? kModelOutput : kOther;
    } catch (const Error&) {
        return kOther;
    }
}

std::unique_ptr<plugin::File> openGrads(const std::string& ctlPath) {
    try {
        return makeFile(GradsFile(ctlPath).describe());
    } catch (Error& error) {
        if (error.where.empty()) error.where = ctlPath;
        throw;
    }
}

std::vector<std::string> modelCtls(const std::string& folder) {
    std::vector<std::string> found;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        const std::string path = entry.path().string();
        if (entry.path().extension() != ".ctl") continue;
        const auto text = findText(path);
        if (!text || !looksLikeCtl(*text)) continue;
        try {
            for (const CtlVariable& variable : parseCtl(*text).variables) {
                const KnownVariable* known = findKnown(variable.name);
                if (known == nullptr || known->role != NEPH_ROLE_MIXING_RATIO ||
                    variable.levels == 0) {
                    continue;
                }
                found.push_back(path);
                break;
            }
        } catch (const Error&) {  // opening it by name reports what is wrong
        }
    }
    std::ranges::sort(found);
    return found;
}

std::optional<std::string> findCtlOf(const std::string& path) {
    constexpr std::size_t kMaxTimes = 10'000;  // file names tried per descriptor
    std::error_code error;
    const std::string folder = folderOf(path);
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        if (entry.path().extension() != ".ctl") continue;
        try {
            const Ctl ctl = parseCtl(readText(entry.path().string()));
            const std::size_t times = ctl.isTemplate ? std::min(ctl.t.count, kMaxTimes) : 1;
            for (std::size_t i = 0; i < times; ++i) {
                if (fs::path(dataPath(ctl, folder, i)) == path) return entry.path().string();
            }
        } catch (const Error&) {  // another kind of .ctl
        }
    }
    return {};
}

}  // namespace raw
