// microhh_case.cpp: finds grid, times and fields of a case; files are recognised by their sizes.
#include "readers/raw_les/microhh_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <set>

#include "readers/raw_les/ini.h"
#include "readers/raw_les/levels.h"

namespace raw {
namespace {

namespace fs = std::filesystem;
namespace plugin = neph::plugin;

constexpr double kMaxCells = 1U << 20U;  // along one axis; no model comes near
constexpr const char* kGridName = "grid.0000000";

/// Meaning of a field, by its name.
struct KnownField {
    std::string_view name;
    NephRole role;
    NephSpecies species;
    std::string_view units, description;
};
// Hydrometeors are mass fractions, per kg of moist air; the density to multiply by is rhoref.
constexpr std::array kKnown{
    KnownField{"ql", NEPH_ROLE_MIXING_RATIO, NEPH_SPECIES_CLOUD, "kg kg-1", "cloud water"},
    KnownField{"qi", NEPH_ROLE_MIXING_RATIO, NEPH_SPECIES_ICE, "kg kg-1", "cloud ice"},
    KnownField{"qr", NEPH_ROLE_MIXING_RATIO, NEPH_SPECIES_RAIN, "kg kg-1", "rain"},
    KnownField{"qs", NEPH_ROLE_MIXING_RATIO, NEPH_SPECIES_SNOW, "kg kg-1", "snow"},
    KnownField{"qg", NEPH_ROLE_MIXING_RATIO, NEPH_SPECIES_GRAUPEL, "kg kg-1", "graupel"},
    KnownField{"qh", NEPH_ROLE_MIXING_RATIO, NEPH_SPECIES_HAIL, "kg kg-1", "hail"},
    KnownField{"nr", NEPH_ROLE_NUMBER_CONCENTRATION, NEPH_SPECIES_RAIN, "kg-1",
               "number of rain drops"},
};

struct FieldName {
    std::string variable;
    std::int64_t number = 0;  ///< the digits: time in units of 10^iotimeprec seconds
};

/// Splits `<variable>.<7 or more digits>`; nothing for any other name.
std::optional<FieldName> fieldName(const std::string& name) {
    const std::size_t dot = name.rfind('.');
    if (dot == std::string::npos || dot == 0 || name.size() - dot - 1 < 7) return {};
    const std::string_view digits = std::string_view(name).substr(dot + 1);
    if (digits.find_first_not_of("0123456789") != std::string_view::npos) return {};
    const auto number = parseInteger(digits);
    if (!number) return {};
    return FieldName{name.substr(0, dot), *number};
}

bool isCaseIni(const std::string& path) {
    const auto text = findText(path);
    return text && parseIni(*text).contains("grid/itot");
}

std::vector<std::string> iniFiles(const std::string& folder) {
    std::vector<std::string> found;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        const std::string path = entry.path().string();
        if (entry.path().extension() == ".ini" && isCaseIni(path)) found.push_back(path);
    }
    std::ranges::sort(found);
    return found;
}

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
    void describeModel();
    void addFields();
    void addAir();
    /// The values of all levels, starting at `first`.
    std::vector<double> profile(const std::vector<double>& numbers, std::size_t first) const;
    std::size_t wordBytes() const { return bytesOf(type_); }

    fs::path folder_;
    std::string ini_;
    std::map<std::string, std::string> keys_;
    std::array<std::size_t, 3> size_{};
    NumberType type_ = NumberType::float32;  ///< of all files of the case
    bool swapped_ = false;
    std::map<std::string, std::map<std::int64_t, std::string>> fields_;  ///< name, digits, path
    std::vector<std::int64_t> times_;                                    ///< digits, increasing
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
        size[axis] = static_cast<std::size_t>(required(kNames[axis], kMaxCells));
    }
    size_ = size;
    const std::string path = (folder_ / kGridName).string();
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
                        "does the .ini belong to this run?", (folder_ / kGridName).string()};
        }
        evenSpacing(name, size_[axis], [&](std::size_t i) { return numbers[first + i]; });
        first += 2 * size_[axis];
    }
}

/// Finds the files that hold whole fields. Other files with such names, such as cross-sections and
/// restart data, have other sizes; a hydrometeor of another size is an Error.
void Case::findFields() {
    const std::uint64_t expected = std::uint64_t{size_[0]} * size_[1] * size_[2] * wordBytes();
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder_, error)) {
        const auto name = fieldName(entry.path().filename().string());
        if (!name) continue;
        const std::string path = entry.path().string();
        const auto found = fileSize(path);
        if (found == expected) {
            fields_[name->variable][name->number] = path;
        } else if (std::ranges::find(kKnown, name->variable, &KnownField::name) != kKnown.end()) {
            throw Error{fmt::format("is {} than a field of this grid",
                                    found.value_or(0) < expected ? "shorter" : "longer"),
                        fmt::format("{} bytes", found.value_or(0)),
                        fmt::format("{} bytes: {} x {} x {} numbers of {} bytes", expected,
                                    size_[0], size_[1], size_[2], wordBytes()),
                        "the run or the copy that wrote it was interrupted", path};
        }
    }
}

/// Keeps the times with all hydrometeors of the case: a cloud without its rain would mislead.
void Case::chooseTimes() {
    std::set<std::int64_t> any;
    std::vector<std::string> names;
    std::vector<const std::map<std::int64_t, std::string>*> all;
    for (const KnownField& known : kKnown) {
        const auto field = fields_.find(std::string(known.name));
        if (known.role != NEPH_ROLE_MIXING_RATIO || field == fields_.end()) continue;
        names.push_back(fmt::format("{} at {} times", known.name, field->second.size()));
        all.push_back(&field->second);
        for (const auto& [time, path] : field->second) any.insert(time);
    }
    for (const std::int64_t time : any) {
        const auto has = [&](const auto* field) { return field->contains(time); };
        if (std::ranges::all_of(all, has)) times_.push_back(time);
    }
    if (times_.empty()) {
        throw Error{
            all.empty() ? "contains no hydrometeor" : "has no time with all of its hydrometeors",
            all.empty() ? "" : joined(names), "files such as ql.0003600 and qr.0003600",
            "write them together: dumplist=ql,qr in section [dump]"};
    }
    if (times_.size() == any.size()) return;
    contents_.description.notes.push_back(
        fmt::format("{} of {} times are left out, because hydrometeors are missing: {}.",
                    any.size() - times_.size(), any.size(), joined(names)));
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

/// Adds every field; those that are not known have no role.
void Case::addFields() {
    for (const auto& [name, files] : fields_) {
        plugin::Variable variable;
        variable.name = name;
        const auto known = std::ranges::find(kKnown, name, &KnownField::name);
        if (known != kKnown.end()) {
            variable.role = known->role;
            variable.species = known->species;
            variable.units = known->units;
            variable.description = known->description;
        }
        variable.size = contents_.description.size;
        RawField field;
        field.size = size_;
        field.type = type_;
        field.swapped = swapped_;
        contents_.add(
            std::move(variable),
            {.stored = [field, files = files, name = name, times = times_](std::size_t time) {
                const auto file = files.find(times[time]);
                if (file == files.end()) {
                    throw Error{fmt::format("variable {} was not written at this time", name),
                                fmt::format("files of {} other times", files.size()),
                                fmt::format("{}.{:07}", name, times[time]),
                                {}};
                }
                RawField at = field;
                at.path = file->second;
                return at;
            }});
    }
}

std::vector<double> Case::profile(const std::vector<double>& numbers, std::size_t first) const {
    return {numbers.begin() + static_cast<std::ptrdiff_t>(first),
            numbers.begin() + static_cast<std::ptrdiff_t>(first + size_[2])};
}

/// Adds reference density, pressure and temperature: moist air, horizontally uniform.
///
/// thermo_basestate contains, with n = ktot: θ_l and q_t on n levels; then θ_v, pressure, Exner
/// function and density, each on n levels and on n + 1 interfaces. rhoref contains only the last.
void Case::addAir() {
    const std::size_t n = size_[2];
    const auto numbersOf = [&](const char* name, std::size_t count) -> std::vector<double> {
        const std::string path = (folder_ / name).string();
        if (fileSize(path) != count * wordBytes()) return {};
        return readNumbers(path, type_, swapped_, count);
    };
    const auto add = [&](plugin::Variable variable, const std::vector<double>& values) {
        Source source;
        for (const double value : values) source.profile.push_back(static_cast<float>(value));
        variable.size = {1, 1, static_cast<int>(n)};
        contents_.add(std::move(variable), std::move(source));
    };
    const auto base = numbersOf("thermo_basestate.0000000", 10 * n + 4);
    std::vector<double> density = numbersOf("rhoref.0000000", 2 * n + 1);
    if (density.empty() && !base.empty()) density = profile(base, 8 * n + 3);
    if (!density.empty()) {
        add({"rhoref", "", "kg m-3", "reference density of moist air", NEPH_ROLE_DRY_AIR_DENSITY},
            profile(density, 0));
    }
    if (base.empty()) return;
    const auto vapour = profile(base, n);
    const auto virtualTheta = profile(base, 2 * n);
    const auto exner = profile(base, 6 * n + 2);
    std::vector<double> temperature(n);
    for (std::size_t k = 0; k < n; ++k) {
        // θ_v = θ (1 + (R_v/R_d − 1) q), R_v = 461.5, R_d = 287.04 in MicroHH's constants.h
        temperature[k] =
            virtualTheta[k] * exner[k] / (1.0 + (461.5 / 287.04 - 1.0) * std::max(vapour[k], 0.0));
    }
    add({"pref", "air_pressure", "Pa", "reference pressure", NEPH_ROLE_AIR_PRESSURE},
        profile(base, 4 * n + 1));
    add({"tref", "air_temperature", "K", "reference temperature", NEPH_ROLE_AIR_TEMPERATURE},
        temperature);
}

Contents Case::describe() {
    readGrid();
    findFields();
    chooseTimes();
    describeModel();
    // zh lists n interfaces; the top one is zsize.
    const std::string path = (folder_ / kGridName).string();
    const std::size_t n = size_[2];
    const std::size_t first = 2 * (size_[0] + size_[1]);
    const auto numbers = readNumbers(path, type_, swapped_, first + 2 * n);
    contents_.interfacesM = profile(numbers, first + n);
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
    contents_.completeAir();
    return std::move(contents_);
}

}  // namespace

int scoreMicrohh(const std::string& path) {
    constexpr int kPart = 5;
    constexpr int kCase = 80;
    std::error_code error;
    if (fs::is_directory(path, error)) {
        return fileSize((fs::path(path) / kGridName).string()) && !iniFiles(path).empty() ? kCase
                                                                                          : 0;
    }
    if (path.ends_with(".ini")) return isCaseIni(path) ? kCase : 0;
    const std::string name = fs::path(path).filename().string();
    if (!fieldName(name) || !fileSize((fs::path(folderOf(path)) / kGridName).string())) return 0;
    return name == kGridName ? kCase : kPart;
}

std::unique_ptr<plugin::File> openMicrohh(const std::string& path) {
    const std::string name = fs::path(path).filename().string();
    if (!fs::is_directory(path) && name != kGridName && fieldName(name)) {
        throw Error{"is one field of a MicroHH case", "numbers without a header",
                    "the case directory, its .ini or its grid.0000000",
                    "open the folder: " + folderOf(path)};
    }
    return makeFile(Case(path).describe());
}

}  // namespace raw
