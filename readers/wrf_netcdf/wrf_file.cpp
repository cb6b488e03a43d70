// wrf_file.cpp: the description of a WRF file, from its header and Times.
#include "readers/wrf_netcdf/wrf_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "readers/wrf_netcdf/schemes.h"
#include "readers/wrf_netcdf/wrf_times.h"

namespace wrf {
namespace {

constexpr std::size_t kMaxCells = 1U << 20U;  // along one axis; no model comes near

/// A field without which no image can be made: heights and air density depend on it.
struct RequiredField {
    const char* name;
    const char* meaning;
    bool onInterfaces;
    const char* why;

    std::string hint() const {
        return fmt::format("{}; write {} with the history stream (iofields)", why, name);
    }
    const char* axes() const {
        return onInterfaces ? "(Time, bottom_top_stag, south_north, west_east)"
                            : "(Time, bottom_top, south_north, west_east)";
    }
};
constexpr std::array<RequiredField, 5> kRequiredFields{{
    {"PH", "perturbation geopotential", true, "heights are (PH+PHB)/9.81"},
    {"PHB", "base-state geopotential", true, "heights are (PH+PHB)/9.81"},
    {"P", "perturbation pressure", false, "air density needs pressure, P+PB"},
    {"PB", "base-state pressure", false, "air density needs pressure, P+PB"},
    {"T", "perturbation potential temperature", false, "air density needs temperature"},
}};

/// WRF's names of variables that have a role. The standard name is empty where CF has none.
struct KnownVariable {
    std::string_view name;
    NephRole role;
    NephSpecies species;
    std::string_view standardName, units;
};
constexpr std::string_view kRatio = "kg kg-1";
constexpr std::string_view kNumber = "kg-1";
constexpr std::array kKnown{
    KnownVariable{"QCLOUD", NEPH_ROLE_MIXING_RATIO, NEPH_SPECIES_CLOUD,
                  "cloud_liquid_water_mixing_ratio", kRatio},
    KnownVariable{"QICE", NEPH_ROLE_MIXING_RATIO, NEPH_SPECIES_ICE, "cloud_ice_mixing_ratio",
                  kRatio},
    KnownVariable{"QRAIN", NEPH_ROLE_MIXING_RATIO, NEPH_SPECIES_RAIN, "", kRatio},
    KnownVariable{"QSNOW", NEPH_ROLE_MIXING_RATIO, NEPH_SPECIES_SNOW, "", kRatio},
    KnownVariable{"QGRAUP", NEPH_ROLE_MIXING_RATIO, NEPH_SPECIES_GRAUPEL, "", kRatio},
    KnownVariable{"QHAIL", NEPH_ROLE_MIXING_RATIO, NEPH_SPECIES_HAIL, "", kRatio},
    KnownVariable{"QVAPOR", NEPH_ROLE_OTHER, NEPH_SPECIES_NONE, "humidity_mixing_ratio", kRatio},
    KnownVariable{"RE_CLOUD", NEPH_ROLE_EFFECTIVE_RADIUS, NEPH_SPECIES_CLOUD,
                  "effective_radius_of_cloud_liquid_water_particles", "m"},
    KnownVariable{"RE_ICE", NEPH_ROLE_EFFECTIVE_RADIUS, NEPH_SPECIES_ICE, "", "m"},
    KnownVariable{"RE_SNOW", NEPH_ROLE_EFFECTIVE_RADIUS, NEPH_SPECIES_SNOW, "", "m"},
    KnownVariable{"QNCLOUD", NEPH_ROLE_NUMBER_CONCENTRATION, NEPH_SPECIES_CLOUD, "", kNumber},
    KnownVariable{"QNICE", NEPH_ROLE_NUMBER_CONCENTRATION, NEPH_SPECIES_ICE, "", kNumber},
    KnownVariable{"QNRAIN", NEPH_ROLE_NUMBER_CONCENTRATION, NEPH_SPECIES_RAIN, "", kNumber},
    KnownVariable{"QNSNOW", NEPH_ROLE_NUMBER_CONCENTRATION, NEPH_SPECIES_SNOW, "", kNumber},
    KnownVariable{"QNGRAUPEL", NEPH_ROLE_NUMBER_CONCENTRATION, NEPH_SPECIES_GRAUPEL, "", kNumber},
    KnownVariable{"QNHAIL", NEPH_ROLE_NUMBER_CONCENTRATION, NEPH_SPECIES_HAIL, "", kNumber},
};

template <typename Names>
std::string joined(const Names& names) {
    std::string text;
    for (const auto& name : names) text += (text.empty() ? "" : ", ") + std::string(name);
    return text.empty() ? "none" : text;
}

std::string listOf(const std::vector<NcDimension>& dimensions) {
    std::vector<std::string> names;
    names.reserve(dimensions.size());
    for (const NcDimension& d : dimensions)
        names.push_back(fmt::format("{} = {}", d.name, d.length));
    return joined(names);
}

/// Size in x, y, z of a field on the model grid, staggered or not; nothing for a variable of
/// another shape.
std::optional<std::array<int, 3>> fieldSize(const NcVariable& variable) {
    const auto& axes = variable.axes;
    const std::size_t first = !axes.empty() && axes[0].name == "Time" ? 1 : 0;
    const std::size_t rank = axes.size() - first;
    if (rank < 2 || rank > 3) return {};
    const NcDimension& x = axes[axes.size() - 1];
    const NcDimension& y = axes[axes.size() - 2];
    if (!x.name.starts_with("west_east") || !y.name.starts_with("south_north")) return {};
    const std::size_t z = rank == 3 ? axes[first].length : 1;
    for (const std::size_t length : {x.length, y.length, z}) {
        if (length < 1 || length > kMaxCells) return {};
    }
    return std::array{static_cast<int>(x.length), static_cast<int>(y.length), static_cast<int>(z)};
}

}  // namespace

bool looksLikeWrf(const NcFile& file) {
    return file.dimension("west_east") != nullptr && file.dimension("south_north") != nullptr &&
           file.dimension("bottom_top") != nullptr;
}

WrfFile::WrfFile(const std::string& path) : file_(path) {
    if (!looksLikeWrf(file_)) {
        throw Failure{"is a NetCDF file, but not WRF output",
                      "dimensions " + listOf(file_.dimensions()),
                      "dimensions west_east, south_north, bottom_top, bottom_top_stag and "
                      "variables PH, PHB, P, PB, T, Q…",
                      "open wrfout files as written by the model"};
    }
    describeGrid();
    requireFields();
    describeTimes();
    describeModel();
    addDerived();
    addStored();
    if (const auto cut = file_.shortage()) {
        notes_.push_back(
            fmt::format("The file is cut short ({} of {} bytes): its last fields cannot be read.",
                        cut->found, cut->expected));
    }
}

void WrfFile::describeGrid() {
    constexpr std::array<const char*, 3> kAxes{"west_east", "south_north", "bottom_top"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t length = file_.dimension(kAxes[axis])->length;
        if (length == 0 || length > kMaxCells) {
            throw Failure{fmt::format("dimension {} has {}", kAxes[axis],
                                      length == 0 ? "no length" : "an impossible length"),
                          "dimensions " + listOf(file_.dimensions()),
                          "at least one cell on every axis",
                          "the run or the copy that wrote this file was interrupted"};
        }
        size_[axis] = static_cast<int>(length);
    }
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const char* name = axis == 0 ? "DX" : "DY";
        const auto spacing = file_.number(name);
        if (!spacing || !std::isfinite(*spacing) || *spacing <= 0.0) {
            throw Failure{fmt::format("global attribute {} (grid spacing) is {}", name,
                                      spacing ? "not a length" : "missing"),
                          spacing ? fmt::format("{}", *spacing) : "", "metres, above zero",
                          "copy the global attributes from the original wrfout (ncks -A)"};
        }
        spacingM_[axis] = *spacing;
    }
}

/// Throws Failure unless heights, pressure and temperature can be computed.
void WrfFile::requireFields() const {
    for (const RequiredField& field : kRequiredFields) {
        const NcVariable* variable = file_.variable(field.name);
        if (variable == nullptr) {
            std::vector<std::string> names;
            for (const NcVariable& v : file_.variables()) {
                if (fieldSize(v)) names.push_back(v.name);
            }
            throw Failure{fmt::format("variable {} ({}) is missing", field.name, field.meaning),
                          joined(names), fmt::format("{} on {}", field.name, field.axes()),
                          field.hint()};
        }
        std::array<int, 3> expected = size_;
        if (field.onInterfaces) ++expected[2];
        if (!variable->number || fieldSize(*variable) != expected) {
            throw Failure{
                fmt::format("variable {} ({}) has the wrong shape", field.name, field.meaning),
                listOf(variable->axes),
                fmt::format("numbers on {}: {} x {} x {} in x, y, z", field.axes(), expected[0],
                            expected[1], expected[2]),
                "open wrfout files as written by the model"};
        }
    }
}

void WrfFile::describeTimes() {
    constexpr const char* kForm = "Times(Time, DateStrLen) as YYYY-MM-DD_hh:mm:ss";
    const NcVariable* variable = file_.variable("Times");
    if (variable == nullptr || !variable->text || variable->axes.size() != 2) {
        throw Failure{"variable Times is missing or is not text", "", kForm,
                      "open wrfout files as written by the model"};
    }
    const std::size_t count = variable->axes[0].length;
    const std::size_t length = variable->axes[1].length;
    if (count == 0 || count > 1'000'000 || length > 1024) {
        throw Failure{count == 0 ? "the file contains no time (dimension Time has no length)"
                                 : "variable Times has an impossible size",
                      listOf(variable->axes), kForm, "the model may not have written a time yet"};
    }
    const std::array<std::size_t, 2> start{0, 0};
    const std::array<std::size_t, 2> whole{count, length};
    const std::string text = file_.readText(*variable, start, whole);
    for (std::size_t i = 0; i < count; ++i) {
        const std::string label(text.substr(i * length, length).c_str());
        const auto seconds = secondsOf(label);
        if (!seconds) {
            throw Failure{
                fmt::format("entry {} of variable Times cannot be read", i),
                fmt::format("\"{}\"", label), kForm,
                "the model was interrupted while writing this time, or the file is damaged"};
        }
        times_.push_back({label, *seconds});
    }
}

/// Version, scheme, notes and global attributes.
void WrfFile::describeModel() {
    std::string title = file_.text("TITLE").value_or("");
    const std::size_t start = title.find("WRF");
    model_ = start == std::string::npos ? "WRF" : title.substr(start);
    if (const std::size_t end = model_.find(" MODEL"); end != std::string::npos) model_.resize(end);
    const auto physics = file_.number("MP_PHYSICS");
    if (physics && std::abs(*physics) < 1000.0) {
        scheme_ = schemeName(static_cast<int>(*physics));
        microphysics_ = microphysicsOf(static_cast<int>(*physics));
    }
    const auto projection = file_.number("MAP_PROJ");
    if (projection && *projection != 0.0) {
        notes_.push_back(
            "Cells are treated as DX by DY everywhere: the map scale factor is not applied.");
    }
    if (file_.variable("QVAPOR") == nullptr) {
        notes_.push_back("QVAPOR is missing: the air is treated as dry.");
    }
    for (const char* name : {"TITLE", "START_DATE", "SIMULATION_START_DATE",
                             "SIMULATION_INITIALIZATION_TYPE", "MAP_PROJ_CHAR"}) {
        if (const auto value = file_.text(name)) attributes_.emplace_back(name, *value);
    }
    for (const char* name : {"DX", "DY", "DT", "MP_PHYSICS", "MAP_PROJ", "CEN_LAT", "CEN_LON",
                             "GRID_ID", "RA_LW_PHYSICS", "RA_SW_PHYSICS"}) {
        if (const auto value = file_.number(name)) {
            attributes_.emplace_back(name, fmt::format("{:.6g}", *value));
        }
    }
}

/// Variables that the host needs and WRF does not store as such; see wrf_fields.cpp.
void WrfFile::addDerived() {
    const std::array<int, 3> interfaces{size_[0], size_[1], size_[2] + 1};
    const auto add = [this](neph::plugin::Variable variable, Source source) {
        variables_.push_back({std::move(variable), source, nullptr});
    };
    add({"interface_height", "altitude", "m",
         "height of layer interfaces above sea level, (PH+PHB)/9.81", NEPH_ROLE_INTERFACE_HEIGHT,
         NEPH_SPECIES_NONE, interfaces},
        Source::interfaceHeight);
    add({"air_pressure", "air_pressure", "Pa", "P+PB", NEPH_ROLE_AIR_PRESSURE, NEPH_SPECIES_NONE,
         size_},
        Source::airPressure);
    add({"air_temperature", "air_temperature", "K", "(T+300) (p/1e5)^(2/7)",
         NEPH_ROLE_AIR_TEMPERATURE, NEPH_SPECIES_NONE, size_},
        Source::airTemperature);
    add({"dry_air_density", "", "kg m-3",
         "density of dry air, from pressure, temperature and QVAPOR", NEPH_ROLE_DRY_AIR_DENSITY,
         NEPH_SPECIES_NONE, size_},
        Source::dryAirDensity);
}

/// All fields of the file. A name that addDerived() uses is skipped.
void WrfFile::addStored() {
    for (const NcVariable& variable : file_.variables()) {
        const auto size = fieldSize(variable);
        const bool taken =
            std::ranges::find(variables_, variable.name, &Variable::name) != variables_.end();
        if (!variable.number || !size || taken) continue;
        Variable entry;
        entry.name = variable.name;
        entry.units = variable.units;
        entry.description = variable.description;
        entry.size = *size;
        entry.stored = &variable;
        const auto known = std::ranges::find(kKnown, variable.name, &KnownVariable::name);
        if (known != kKnown.end() && *size == size_) {
            entry.role = known->role;
            entry.species = known->species;
            entry.standardName = known->standardName;
            entry.units = known->units;
        }
        variables_.push_back(std::move(entry));
    }
}

}  // namespace wrf
