// microhh_case.cpp: finds grid, times and fields of a case; files are recognised by their sizes.
#include "readers/raw_les/microhh_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <set>

#include "readers/les/levels.h"
#include "readers/les/microhh_air.h"
#include "readers/raw_les/ini.h"
#include "readers/raw_les/microhh_derived.h"
#include "readers/raw_les/microhh_names.h"
#include "readers/raw_les/raw_values.h"

namespace les {
namespace {

namespace fs = std::filesystem;
namespace plugin = neph::plugin;

constexpr double kMaxAxis = 1U << 20U;  // cells along one axis; no model comes near

/// One case directory. describe() runs the steps in order.
class Case {
  public:
    explicit Case(const std::string& path);
    Contents describe();

  private:
    double number(const std::string& key, double fallback) const;
    /// A number above 0 and up to `most`. Throws Error otherwise.
    double required(const std::string& key, double most) const;
    void readGrid();
    void requireGridOf(const std::vector<double>& numbers) const;
    void findFields();
    void chooseTimes();
    void noteMissing();
    bool atAllTimes(const std::string& name) const;
    void addDerived();
    void describeModel();
    void addFields();
    void addAir();
    std::size_t wordBytes() const { return bytesOf(type_); }

    fs::path folder_;
    std::string ini_;
    std::map<std::string, std::string> keys_;
    std::array<std::size_t, 3> size_{};
    NumberType type_ = NumberType::float32;  ///< of all files of the case
    bool swapped_ = false;
    std::map<std::string, std::map<std::int64_t, std::string>> fields_;  ///< name, digits, path
    std::map<std::int64_t, Error> broken_;  ///< digits, a known field of another size
    std::vector<std::int64_t> times_;       ///< digits, increasing
    Contents contents_;
};

Case::Case(const std::string& path) {
    folder_ = fs::is_directory(path) ? path : folderOf(path);
    if (path.ends_with(".ini") && !fs::is_directory(path)) {
        ini_ = path;
    } else {
        const auto found = iniFiles(folder_.string());
        if (found.size() != 1) {
            throw Error{found.empty() ? "has no .ini file with a section [grid] in its folder"
                                      : "has several .ini files",
                        joined(found), "the .ini of the run",
                        found.empty() ? "copy it there" : "open the .ini itself"};
        }
        ini_ = found.front();
    }
    keys_ = parseIni(readText(ini_));
}

double Case::number(const std::string& key, double fallback) const {
    const auto found = keys_.find(key);
    return found == keys_.end() ? fallback : parseNumber(found->second).value_or(fallback);
}

double Case::required(const std::string& key, double most) const {
    const auto found = keys_.find(key);
    const auto value = found == keys_.end() ? std::nullopt : parseNumber(found->second);
    if (value && *value > 0.0 && *value <= most) return *value;
    throw Error{fmt::format("{} is {}", key, found == keys_.end() ? "missing" : "not a valid size"),
                found == keys_.end() ? "" : inQuotes(found->second), "a number above 0", "", ini_};
}

/// Sizes from the .ini. The size of grid.0000000 shows whether numbers are float or double, its
/// first value whether they are in the other byte order.
void Case::readGrid() {
    std::array<std::size_t, 3> size{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::array<const char*, 3> kNames{"grid/itot", "grid/jtot", "grid/ktot"};
        size[axis] = static_cast<std::size_t>(required(kNames[axis], kMaxAxis));
    }
    size_ = size;
    const std::string path = (folder_ / kMicrohhGrid).string();
    const std::size_t count = 2 * (size[0] + size[1] + size[2]);
    const auto found = fileSize(path);
    if (!found || (*found != count * 4 && *found != count * 8)) {
        throw Error{found ? "does not have the size of the grid in the .ini" : "is missing",
                    found ? fmt::format("{} bytes", *found) : std::string(),
                    fmt::format("{} bytes (float) or {} bytes (double): x, xh, y, yh, z, zh of "
                                "{} x {} x {} cells",
                                count * 4, count * 8, size[0], size[1], size[2]),
                    "it is written when the case is initialised (microhh init)", path};
    }
    type_ = *found == count * 4 ? NumberType::float32 : NumberType::float64;
    auto numbers = readNumbers(path, type_, false, count);
    const double dx = required("grid/xsize", 1e9) / static_cast<double>(size[0]);
    if (!(std::abs(numbers[0] - 0.5 * dx) < 1e-3 * dx)) {
        swapped_ = true;
        numbers = readNumbers(path, type_, true, count);
    }
    requireGridOf(numbers);
}

/// Checks x and y against the .ini. `numbers` are x, xh, y, yh, z, zh in metres. Throws Error.
void Case::requireGridOf(const std::vector<double>& numbers) const {
    std::size_t first = 0;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const std::string name = axis == 0 ? "x" : "y";
        const double step =
            required("grid/" + name + "size", 1e9) / static_cast<double>(size_[axis]);
        const double found = numbers[first];
        if (!(std::abs(found - 0.5 * step) < 1e-3 * step)) {
            throw Error{fmt::format("its {} coordinates differ from the .ini", name),
                        fmt::format("the first centre at {:.6g} m", found),
                        fmt::format("{:.6g} m, half of {}size / {}tot", 0.5 * step, name,
                                    axis == 0 ? "i" : "j"),
                        "does the .ini belong to this run?", (folder_ / kMicrohhGrid).string()};
        }
        if (!evenStep({numbers.data() + first, size_[axis]})) {
            throw Error{fmt::format("its {} coordinates are not even", name),
                        {},
                        fmt::format("a step of {:.6g} m everywhere", step),
                        "does the .ini belong to this run?",
                        (folder_ / kMicrohhGrid).string()};
        }
        first += 2 * size_[axis];
    }
}

/// Finds the files that hold whole fields. Other files with such names, such as cross-sections and
/// restart data, have other sizes; a time of which a known field has another size is left out.
void Case::findFields() {
    const std::uint64_t expected = std::uint64_t{size_[0]} * size_[1] * size_[2] * wordBytes();
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder_, error)) {
        const auto name = fieldName(entry.path().filename().string());
        if (!name) continue;
        const std::string path = entry.path().string();
        const std::uint64_t found = fileSize(path).value_or(0);
        if (found == expected) {
            fields_[name->variable][name->number] = path;
        } else if (findMicrohhField(name->variable) != nullptr) {
            Error fault{fmt::format("is {} than a field of this grid",
                                    found < expected ? "shorter" : "longer"),
                        fmt::format("{} bytes", found),
                        fmt::format("{} bytes: {} x {} x {} numbers of {} bytes", expected,
                                    size_[0], size_[1], size_[2], wordBytes()),
                        "the run or the copy that wrote it was interrupted"};
            describeSize(path, fault);
            broken_.emplace(name->number, std::move(fault));
        }
    }
}

/// Times at which there is any hydrometeor, and none is broken. Those without some of the others
/// are kept, with a note.
void Case::chooseTimes() {
    std::set<std::int64_t> times;
    for (const auto& [name, files] : fields_) {
        const MicrohhField* known = findMicrohhField(name);
        if (known == nullptr || known->role != NEPH_ROLE_MIXING_RATIO) continue;
        for (const auto& [time, path] : files) times.insert(time);
    }
    std::vector<std::string> left;
    for (const auto& [time, fault] : broken_) {
        times.erase(time);
        const bool writing = changedLately(fault.where);
        left.push_back(fs::path(fault.where).filename().string() + " " +
                       (writing ? "is being written" : fault.what));
    }
    if (times.empty() && !broken_.empty()) throw broken_.begin()->second;
    if (times.empty()) {
        throw Error{"contains no hydrometeor",
                    {},
                    "files such as ql.0003600 and qr.0003600",
                    "write them together: dumplist=ql,qr in section [dump]"};
    }
    times_.assign(times.begin(), times.end());
    if (left.empty()) return;
    contents_.description.notes.push_back(
        fmt::format("{} time(s) are left out: {}.", left.size(), joined(left)));
}

/// Notes the hydrometeors that the run has, or the case has at some times, where they are missing.
void Case::noteMissing() {
    auto& notes = contents_.description.notes;
    for (const std::string_view name : hydrometeorsOf(keys_)) {
        if (fields_.contains(std::string(name))) continue;
        notes.push_back(fmt::format(
            "{}, {}, is not in the case directory, although the run has it: it is not drawn. To "
            "write it, add {} to dumplist in section [dump] of the .ini.",
            name, findMicrohhField(name)->description, name));
    }
    for (const auto& [name, files] : fields_) {
        const MicrohhField* known = findMicrohhField(name);
        if (known == nullptr || known->role != NEPH_ROLE_MIXING_RATIO) continue;
        std::vector<std::string> without;
        for (std::size_t i = 0; i < times_.size(); ++i) {
            if (!files.contains(times_[i])) {
                without.push_back(contents_.description.times[i].label);
            }
        }
        if (without.empty()) continue;
        notes.push_back(
            fmt::format("{}, {}, has no file at {} of {} times, and is not drawn then: {}.", name,
                        known->description, without.size(), times_.size(), joined(without)));
    }
}

/// Scheme, droplet number, grid spacing and times, from the .ini.
void Case::describeModel() {
    plugin::Description& d = contents_.description;
    d.model = "MicroHH";
    if (const auto micro = keys_.find("micro/swmicro"); micro != keys_.end()) {
        d.scheme = micro->second == "2mom_warm" ? "two-moment warm rain (swmicro=2mom_warm)"
                                                : fmt::format("swmicro={}", micro->second);
    }
    for (const char* key : {"micro/Nc0", "micro/nc0"}) {
        const double droplets = number(key, 0.0);
        if (droplets > 0.0 && droplets < 1e12) d.cloudDropletsPerM3 = droplets;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) d.size[axis] = static_cast<int>(size_[axis]);
    d.spacingM = {number("grid/xsize", 0.0) / static_cast<double>(size_[0]),
                  number("grid/ysize", 0.0) / static_cast<double>(size_[1])};
    d.attributes.emplace_back("descriptor", fs::path(ini_).filename().string());
    d.attributes.emplace_back("numbers", type_ == NumberType::float32 ? "float" : "double");
    for (const char* key : {"thermo/swthermo", "thermo/swbasestate"}) {
        if (const auto found = keys_.find(key); found != keys_.end()) {
            d.attributes.emplace_back(found->first, found->second);
        }
    }
    // The digits count units of 10^iotimeprec seconds.
    const double unit = std::pow(10.0, std::clamp(number("time/iotimeprec", 0.0), -9.0, 9.0));
    for (const std::int64_t time : times_) {
        const double seconds = static_cast<double>(time) * unit;
        d.times.push_back({fmt::format("{:.9g} s", seconds), seconds});
    }
}

/// Adds every field; those that are not known have no role. A hydrometeor without a file at a time
/// is zero then.
void Case::addFields() {
    for (const auto& [name, files] : fields_) {
        plugin::Variable variable;
        variable.name = name;
        const MicrohhField* known = findMicrohhField(name);
        const bool hydrometeor = known != nullptr && known->role == NEPH_ROLE_MIXING_RATIO;
        if (known != nullptr) {
            variable.units = known->units;
            variable.description = known->description;
            variable.reason = "its name among MicroHH's files";
        }
        if (hydrometeor) {
            variable.role = known->role;
            variable.species = known->species;
        }
        variable.size = contents_.description.size;
        RawField field;
        field.size = size_;
        field.type = type_;
        field.swapped = swapped_;
        contents_.add(std::move(variable), storedAt([field, files = files, name = name, hydrometeor,
                                                     times = times_](std::size_t time) {
                          const auto file = files.find(times[time]);
                          if (file == files.end() && !hydrometeor) {
                              throw Error{
                                  fmt::format("variable {} was not written at this time", name),
                                  fmt::format("files of {} other times", files.size()),
                                  fmt::format("{}.{:07}", name, times[time]),
                                  {}};
                          }
                          RawField at = field;
                          at.path = file == files.end() ? "" : file->second;
                          return at;
                      }));
        for (const auto& [digits, path] : files) contents_.description.parts.push_back(path);
    }
}

bool Case::atAllTimes(const std::string& name) const {
    return fields_.contains(name) &&
           std::ranges::all_of(times_, [&](auto time) { return fields_.at(name).contains(time); });
}

void Case::addDerived() {
    if (atAllTimes("nr")) {
        addRainNumber(contents_);
    } else if (fields_.contains("nr")) {
        contents_.description.notes.emplace_back(
            "nr, the number of rain drops, is not used, because it is not there at all times.");
    }
    if (atAllTimes("thl") && atAllTimes("qt")) addHumidity(contents_);
}

void Case::addAir() {
    const auto add = [&](plugin::Variable variable, const std::vector<double>& values) {
        if (values.empty()) return;
        Source source;
        for (const double value : values) source.profile.push_back(static_cast<float>(value));
        variable.size = {1, 1, static_cast<int>(values.size())};
        contents_.add(std::move(variable), std::move(source));
    };
    const MicrohhAir air = readMicrohhAir(folder_.string(), bytesOf(type_), swapped_, size_[2]);
    add({"rhoref", "", "kg m-3", "reference density of moist air", NEPH_ROLE_DRY_AIR_DENSITY},
        air.densityKgPerM3);
    add({"pref", "air_pressure", "Pa", "reference pressure", NEPH_ROLE_AIR_PRESSURE},
        air.pressurePa);
    add({"tref", "air_temperature", "K", "reference temperature", NEPH_ROLE_AIR_TEMPERATURE},
        air.temperatureK);
}

Contents Case::describe() {
    readGrid();
    findFields();
    chooseTimes();
    describeModel();
    noteMissing();
    // zh lists n interfaces; the top one is zsize.
    const std::string path = (folder_ / kMicrohhGrid).string();
    const std::size_t n = size_[2];
    const std::size_t first = 2 * (size_[0] + size_[1]);
    const auto numbers = readNumbers(path, type_, swapped_, first + 2 * n);
    const auto start = numbers.begin() + static_cast<std::ptrdiff_t>(first + n);
    contents_.interfacesM.assign(start, start + static_cast<std::ptrdiff_t>(n));
    const double top = 2.0 * numbers[first + n - 1] - contents_.interfacesM.back();
    contents_.interfacesM.push_back(number("grid/zsize", top));
    for (std::size_t k = 0; k < n; ++k) {
        if (contents_.interfacesM[k + 1] > contents_.interfacesM[k]) continue;
        throw Error{
            "its level heights do not increase",
            fmt::format("{} m after {} m", contents_.interfacesM[k + 1], contents_.interfacesM[k]),
            "zh, and zsize above it", "does the .ini belong to this run?", path};
    }
    addAir();
    addFields();
    addDerived();
    contents_.completeAir();
    if (hasPeriodicSides(keys_)) contents_.notePeriodicSides("MicroHH");
    return std::move(contents_);
}

/// Whether a folder has a hydrometeor that MicroHH wrote.
bool holdsHydrometeors(const std::string& folder) {
    std::error_code error;
    return std::ranges::any_of(fs::directory_iterator(folder, error), [](const auto& entry) {
        const auto name = fieldName(entry.path().filename().string());
        return name && (name->variable == "ql" || name->variable == "qr" || name->variable == "qi");
    });
}

}  // namespace

int scoreMicrohh(const std::string& path) {
    constexpr int kPart = 5;
    constexpr int kCase = 80;
    std::error_code error;
    if (fs::is_directory(path, error)) {
        const bool grid = fileSize((fs::path(path) / kMicrohhGrid).string()).has_value();
        if (grid && !iniFiles(path).empty()) return kCase;
        return holdsHydrometeors(path) ? kPart : 0;  // opening it names what is missing
    }
    if (path.ends_with(".ini")) return isCaseIni(path) ? kCase : 0;
    const std::string name = fs::path(path).filename().string();
    if (!fieldName(name) || !fileSize((fs::path(folderOf(path)) / kMicrohhGrid).string())) return 0;
    return name == kMicrohhGrid ? kCase : kPart;
}

std::unique_ptr<plugin::File> openMicrohh(const std::string& path) {
    const std::string name = fs::path(path).filename().string();
    if (!fs::is_directory(path) && name != kMicrohhGrid && fieldName(name)) {
        throw Error{"is one field of a MicroHH case", "numbers without a header",
                    "the case directory, its .ini or its grid.0000000",
                    "open the folder: " + folderOf(path)};
    }
    return makeFile(Case(path).describe());
}

}  // namespace les
