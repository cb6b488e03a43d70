// describe.cpp: what a file holds, from the headers of its messages.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "readers/grib/codes.h"
#include "readers/grib/grib_file.h"
#include "readers/grib/hydrometeors.h"
#include "readers/shared/calendar.h"
#include "readers/shared/writing.h"

namespace grib {
namespace {

/// An error of one grid or level without a message of its own names the file alone.
Contents requireContents(const InputFile& file, const Inventory& inventory) {
    if (inventory.messages == 0 && !inventory.unfinished) {
        throw Failure{"it has no GRIB message that can be read",
                      fmt::format("{} bytes", file.size()), "messages of edition 2",
                      "the file is damaged: download it again"};
    }
    if (!inventory.unfinished) return contentsOf(inventory);
    const auto writing = shared::beingWritten(file.path());
    const std::string end = writing ? "being written" : "cut short";
    const std::string hint = writing
                                 ? fmt::format("open it again when that has ended ({})", *writing)
                                 : "download the file again";
    if (inventory.fields.empty()) {
        throw Failure{"the file is " + end,
                      fmt::format("{} bytes, and its first message has {}", file.size(),
                                  inventory.unfinished->length),
                      "whole messages", hint};
    }
    try {
        return contentsOf(inventory);
    } catch (Failure& failure) {  // what is missing may be in what has not arrived
        failure.found += fmt::format("; the file is {}, {} bytes", end, file.size());
        failure.hint = hint;
        throw;
    }
}

/// What NCEP and NOAA's laboratories call a process. NCEP office note 388, table A.
const char* modelOf(const Product& product) {
    constexpr unsigned kNcep = 7, kGsl = 59;
    if (product.centre != kNcep && product.centre != kGsl) return "";
    return product.process == 83 ? "HRRR" : product.process == 105 ? "RAP" : "";
}

/// The CF standard name of a wind along the grid, which ecCodes does not tell from one to the east.
std::string windName(const std::string& standardName, bool alongGrid) {
    if (!alongGrid) return standardName;
    if (standardName == "eastward_wind") return "x_wind";
    if (standardName == "northward_wind") return "y_wind";
    return standardName;
}

NephRole windRole(std::string_view standardName) {
    if (standardName == "x_wind") return NEPH_ROLE_X_WIND;
    if (standardName == "y_wind") return NEPH_ROLE_Y_WIND;
    return standardName == "upward_air_velocity" ? NEPH_ROLE_UPWARD_WIND : NEPH_ROLE_OTHER;
}

}  // namespace

GribFile::GribFile(const char* path)
    : file_(path),
      inventory_(scan(file_)),
      contents_(requireContents(file_, inventory_)),
      reader_(file_, inventory_.fields, contents_.grid),
      air_(reader_, contents_) {
    turnUpward();
    describeGrid();
    describeTimes();
    addAir();
    addHydrometeors();
    addOthers();
    describeModel();
    describeLevels();
    description_.notes.insert(description_.notes.end(), contents_.notes.begin(),
                              contents_.notes.end());
    noteEnd();
    description_.variables.assign(quantities_.begin(), quantities_.end());
}

/// Numbers of hybrid levels run upward in some models and downward in others.
void GribFile::turnUpward() {
    if (contents_.surface != kHybrid) return;
    const std::size_t middle = contents_.grid.size[0] / 2;
    const Columns one{{middle, 0}, {middle + 1, 1}};
    const auto low = air_.heightOfCentre({0, 0, one});
    const auto high = air_.heightOfCentre({0, contents_.levels.size() - 1, one});
    if (!(high[0] < low[0])) return;
    std::ranges::reverse(contents_.levels);
    for (auto& [parameter, stack] : contents_.stacks) {
        for (auto& column : stack) std::ranges::reverse(column);
    }
}

void GribFile::describeGrid() {
    const Grid& grid = contents_.grid;
    description_.size = {static_cast<int>(grid.size[0]), static_cast<int>(grid.size[1]),
                         static_cast<int>(contents_.levels.size())};
    description_.spacingM = grid.spacingM;
    description_.projection = grid.projection;
    description_.mapOriginM = grid.mapOriginM;
    description_.mapPerGrid = grid.mapPerGrid;
    description_.domain = grid.name;
    description_.notes.push_back(grid.note);
}

void GribFile::describeTimes() {
    for (const Moment& moment : contents_.times) {
        description_.times.push_back({moment.label, moment.seconds});
    }
    description_.utcOfZero = "0001-01-01T00:00:00Z";
}

void GribFile::describeModel() {
    const Product& product = contents_.first;
    const std::string model = modelOf(product);
    description_.model = model.empty() ? "GRIB" : model;
    if (!model.empty()) {
        description_.scheme = "Thompson";
        description_.microphysics = NEPH_MICROPHYSICS_THOMPSON;
    } else {
        description_.notes.push_back(
            fmt::format("GRIB does not state the microphysics scheme, and process {} of centre {} "
                        "is not known here.",
                        product.process, product.centre));
    }
    description_.attributes = {
        {"start of the forecast", shared::dateOfSeconds(product.cycleSeconds)},
        {"grid", contents_.grid.name},
        {"levels", fmt::format("{} of {}", contents_.levels.size(),
                               contents_.surface == kHybrid ? "the model (hybrid, type 105)"
                                                            : "pressure (isobaric, type 100)")},
        {"centre", fmt::format("{}", product.centre)},
        {"generating process", fmt::format("{}", product.process)},
        {"messages", fmt::format("{}", inventory_.messages)}};
}

void GribFile::describeLevels() {
    std::vector<std::string>& notes = description_.notes;
    const auto lacking = [](const std::vector<std::size_t>& fields) {
        return std::ranges::find(fields, kNoField) != fields.end();
    };
    const bool terrain = !lacking(contents_.groundHeight);
    if (contents_.surface == kHybrid) {
        notes.push_back(fmt::format(
            "Heights are those of the centres of cells: interfaces are taken halfway between "
            "them, the lowest {}.",
            terrain ? "as HGT of the ground" : "half a layer below the lowest centre"));
        return;
    }
    notes.push_back(
        "Levels are isobaric surfaces, which the model interpolated to: interfaces are taken "
        "halfway between them in height. Native levels show more.");
    notes.push_back(terrain ? "Cells whose centre is below HGT of the ground are empty."
                    : !lacking(contents_.groundPressure)
                        ? "Cells below PRES of the ground are empty."
                        : "The file has neither HGT nor PRES of the ground: "
                          "what lies below it is not known.");
}

void GribFile::noteEnd() {
    if (!inventory_.unfinished) return;
    const Extent& cut = *inventory_.unfinished;
    const auto writing = shared::beingWritten(file_.path());
    description_.notes.push_back(
        fmt::format("The file is {} ({} of {} bytes): its last message cannot be read{}.",
                    writing ? "being written" : "cut short", file_.size(), cut.at + cut.length,
                    writing ? " yet" : ""));
}

Quantity GribFile::onCells(std::string name, std::string units, std::string description) const {
    Quantity quantity;
    quantity.name = std::move(name);
    quantity.units = std::move(units);
    quantity.description = std::move(description);
    quantity.size = description_.size;
    return quantity;
}

void GribFile::addAir() {
    const std::string heat = parameterName(contents_.temperature);
    Quantity height =
        onCells("interface_height", "m",
                fmt::format("height of layer interfaces above sea level, from {} at centres",
                            parameterName(contents_.height)));
    height.standardName = "altitude";
    height.role = NEPH_ROLE_INTERFACE_HEIGHT;
    height.source = Source::interfaceHeight;
    ++height.size[2];
    Quantity pressure = onCells("air_pressure", "Pa",
                                contents_.surface == kHybrid ? parameterName(contents_.pressure)
                                                             : "of the isobaric surfaces");
    pressure.standardName = "air_pressure";
    pressure.role = NEPH_ROLE_AIR_PRESSURE;
    pressure.source = Source::airPressure;
    Quantity temperature = onCells("air_temperature", "K", "from " + heat);
    temperature.standardName = "air_temperature";
    temperature.role = NEPH_ROLE_AIR_TEMPERATURE;
    temperature.source = Source::airTemperature;
    const std::string wet = contents_.hasVapour ? parameterName(contents_.vapour) : "";
    Quantity density =
        onCells("dry_air_density", "kg m-3",
                "density of dry air, from pressure, temperature" +
                    (wet.empty() ? std::string(" (vapour is not in the file)") : " and " + wet));
    density.role = NEPH_ROLE_DRY_AIR_DENSITY;
    density.source = Source::dryAirDensity;
    quantities_ = {height, pressure, temperature, density};
    if (wet.empty()) {
        description_.notes.emplace_back(
            "The file has no SPFH, MIXR, RH or DPT on all levels: the air is treated as dry.");
        return;
    }
    Quantity vapour = onCells("humidity_mixing_ratio", "kg kg-1", "from " + wet);
    vapour.standardName = "humidity_mixing_ratio";
    vapour.role = NEPH_ROLE_WATER_VAPOUR;
    vapour.source = Source::vapour;
    quantities_.push_back(vapour);
    if (wet == "RH" || wet == "DPT") {
        description_.notes.push_back(
            fmt::format("Water vapour follows from {}, with saturation over water; from 100 hPa up "
                        "there is none.",
                        wet));
    }
}

/// A sentence where a field lacks levels that others have.
void GribFile::noteGaps(const Quantity& quantity) {
    const Stack& stack = *contents_.find(quantity.parameter);
    for (std::size_t t = 0; t < stack.size(); ++t) {
        const auto gaps = std::ranges::count(stack[t], kNoField);
        if (gaps == 0) continue;
        description_.notes.push_back(
            fmt::format("{} lacks {} of {} levels at {}: there it is missing.", quantity.name, gaps,
                        stack[t].size(), contents_.times[t].label));
    }
}

void GribFile::addHydrometeors() {
    std::set<std::pair<NephRole, NephSpecies>> taken;
    for (const Hydrometeor& row : hydrometeors()) {
        if (contents_.find(row.parameter) == nullptr) continue;
        const std::string name = parameterName(row.parameter);
        if (!taken.insert({row.role, row.species}).second) {
            description_.notes.push_back(
                fmt::format("{} is not used: the file has another field for the same.", name));
            continue;
        }
        const char* units = row.role == NEPH_ROLE_MIXING_RATIO       ? "kg kg-1"
                            : row.role == NEPH_ROLE_EFFECTIVE_RADIUS ? "m"
                                                                     : "kg-1";
        Quantity quantity = onCells(name, units, row.description);
        quantity.role = row.role;
        quantity.species = row.species;
        quantity.parameter = row.parameter;
        if (row.perMoistAir) quantity.source = Source::perMoistAir;
        if (row.perMoistAir) quantity.description += ", converted to kg of dry air";
        noteGaps(quantity);
        quantities_.push_back(quantity);
    }
    std::string lacking;
    for (const NephSpecies species : {NEPH_SPECIES_CLOUD, NEPH_SPECIES_ICE, NEPH_SPECIES_RAIN,
                                      NEPH_SPECIES_SNOW, NEPH_SPECIES_GRAUPEL}) {
        if (taken.contains({NEPH_ROLE_MIXING_RATIO, species})) continue;
        lacking += (lacking.empty() ? "" : ", ") + std::string(speciesName(species));
    }
    if (!lacking.empty()) {
        description_.notes.push_back(fmt::format("The file has no {} on these levels.", lacking));
    }
}

/// What else lies on all levels at all times, named by the tables of ecCodes.
void GribFile::addOthers() {
    std::set<Parameter> used{contents_.height, contents_.temperature, contents_.vapour};
    std::set<std::string> names;
    if (contents_.surface == kHybrid) used.insert(contents_.pressure);
    for (const Quantity& quantity : quantities_) {
        if (quantity.parameter != Parameter{} || quantity.role == NEPH_ROLE_MIXING_RATIO) {
            used.insert(quantity.parameter);
        }
        names.insert(quantity.name);
    }
    for (const auto& [parameter, stack] : contents_.stacks) {
        const bool whole = std::ranges::all_of(stack, [](const auto& column) {
            return std::ranges::find(column, kNoField) == column.end();
        });
        if (!whole || used.contains(parameter)) continue;
        const Field& field = inventory_.fields[stack.front().front()];
        const ParameterText text = textWithCodes(messageOf(file_, field, false));
        const std::string plain = parameterName(parameter);
        std::string name = text.shortName.empty() ? plain : text.shortName;
        if (!names.insert(name).second) name = plain;
        Quantity quantity = onCells(name, text.units, text.name.empty() ? plain : text.name);
        quantity.standardName = windName(text.standardName, contents_.grid.windsAlongGrid);
        quantity.parameter = parameter;
        if (parameter == Parameter{0, 2, 9}) quantity.standardName = "upward_air_velocity";
        quantity.role = windRole(quantity.standardName);
        if (quantity.role != NEPH_ROLE_OTHER) quantity.units = "m s-1";
        names.insert(quantity.name);
        quantities_.push_back(quantity);
    }
}

}  // namespace grib
