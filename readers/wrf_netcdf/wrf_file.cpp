// wrf_file.cpp: the description of a WRF file, from its header and times.
#include "readers/wrf_netcdf/wrf_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "readers/shared/calendar.h"
#include "readers/shared/writing.h"
#include "readers/wrf_netcdf/advice.h"
#include "readers/wrf_netcdf/grid.h"
#include "readers/wrf_netcdf/place.h"
#include "readers/wrf_netcdf/winds.h"

namespace wrf {
namespace {

constexpr std::size_t kMaxCells = 1U << 20U;  // along one axis; no model comes near

/// The role-carrying quantities that WRF does not store as such; see wrf_fields.cpp.
Field derived(const char* name, const char* standardName, const char* units,
              const std::string& description, NephRole role, Source source) {
    Field field;
    field.name = name;
    field.standardName = standardName;
    field.units = units;
    field.description = description;
    field.reason = "computed: " + description;
    field.role = role;
    field.source = source;
    return field;
}

Field vapourOf(const AirSources& air, const std::array<int, 3>& size) {
    const NcVariable& stored = *air.vapour.front().variable;
    Field field = derived(stored.name.c_str(), "humidity_mixing_ratio", "kg kg-1",
                          stored.description, NEPH_ROLE_WATER_VAPOUR, Source::sum);
    field.terms = air.vapour;
    field.size = size;
    return field;
}

/// "WRF V4.2.2" from " OUTPUT FROM WRF V4.2.2 MODEL".
std::string modelOf(const NcFile& file) {
    const std::string title = file.text("TITLE").value_or("");
    const std::size_t start = title.find("WRF");
    std::string model = start == std::string::npos ? "WRF" : title.substr(start);
    if (const std::size_t end = model.find(" MODEL"); end != std::string::npos) model.resize(end);
    return model;
}

}  // namespace

bool looksLikeWrf(const NcFile& file) {
    const bool named = file.dimension("west_east") != nullptr &&
                       file.dimension("south_north") != nullptr &&
                       file.dimension("bottom_top") != nullptr;
    return (named || hasWrfNames(file)) && !isForeign(file) && axesOf(file).has_value();
}

WrfFile::WrfFile(const std::string& path) : tiles_(path) {
    if (!looksLikeWrf(tiles_.first())) throw adviceFor(tiles_.first());
    requireCells();
    const auto physics = tiles_.first().number("MP_PHYSICS");
    if (physics && std::abs(*physics) < 1000.0) scheme_ = schemeOf(static_cast<int>(*physics));
    times_ = readTimes(tiles_.first(), tiles_.axes());
    description_.notes = times_.notes;
    describeGrid();
    addFields();
    requireUpward();
    dropUnfinished();
    description_.times = times_.times;
    describeModel();
}

void WrfFile::requireCells() const {
    const Axes& axes = tiles_.axes();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (axes.length[axis] > 0 && axes.length[axis] <= kMaxCells) continue;
        throw Failure{fmt::format("dimension {} has {}", axes.centre[axis],
                                  axes.length[axis] == 0 ? "no length" : "an impossible length"),
                      "dimensions " + listOf(tiles_.first().dimensions()),
                      "at least one cell on every axis",
                      "the run or the copy that wrote this file was interrupted"};
    }
    constexpr std::size_t kMostCells = std::size_t{1} << 36U;
    const std::size_t layer = axes.length[0] * axes.length[1];
    if (layer <= kMostCells / axes.length[2]) return;
    throw Failure{"the grid is larger than any model's",
                  fmt::format("{} x {} x {} cells", axes.length[0], axes.length[1], axes.length[2]),
                  fmt::format("at most {} cells", kMostCells),
                  "the header is damaged: copy the file again"};
}

void WrfFile::describeGrid() {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        description_.size[axis] = static_cast<int>(tiles_.axes().length[axis]);
    }
    description_.spacingM = spacingOf(tiles_, description_.notes);
    describePlaceAndDate();
    const bool placed = !description_.projection.empty();
    numberDomain(tiles_.first(), description_);
    const bool numbered = isIdealised(tiles_.first()) && description_.parentRatio > 0;
    description_.domain = domainOf(tiles_, placed || numbered);
    const std::string motion =
        motionNote(tiles_, times_.records.front(), times_.records.back(), placed);
    if (!motion.empty()) description_.notes.push_back(motion);
    if (!tiles_.partNote().empty()) description_.notes.push_back(tiles_.partNote());
    const auto paths = tiles_.paths();
    if (paths.size() < 2) return;
    description_.parts = paths;
    description_.notes.push_back(
        fmt::format("The domain is read from the {} tiles that MPI ranks wrote.", paths.size()));
}

/// Times count from year 1. The Gregorian calendar began in 1582: years before it are the clocks of
/// idealised runs.
void WrfFile::describePlaceAndDate() {
    if (const auto place = placeOf(tiles_, description_.spacingM, description_.notes)) {
        description_.projection = place->projection;
        description_.mapOriginM = place->mapOriginM;
        description_.mapPerGrid = place->mapPerGrid;
        const auto offsetsM = offsetsOf(tiles_, *place, description_.spacingM, times_.records);
        for (std::size_t i = 0; i < offsetsM.size(); ++i) {
            times_.times[i].gridOffsetM = offsetsM[i];
        }
    }
    const bool dated = times_.times.front().seconds >= *shared::secondsOfDate("1583-01-01");
    if (dated && times_.gregorian) {
        description_.utcOfZero = "0001-01-01T00:00:00Z";
    } else if (dated) {
        description_.notes.push_back(
            "Times are in another calendar than the Gregorian: dates in UTC are not known.");
    }
    if (isIdealised(tiles_.first())) {
        description_.noPlace = "the run is idealised (MAP_PROJ 0)";
    }
}

/// Version, scheme, notes and global attributes.
void WrfFile::describeModel() {
    const NcFile& file = tiles_.first();
    description_.model = modelOf(file);
    description_.scheme = schemeName(scheme_);
    description_.microphysics = scheme_.microphysics;
    if (scheme_.number < 0) {
        description_.notes.push_back(
            "MP_PHYSICS is missing: the scheme, and with it which hydrometeors the run has, is "
            "unknown.");
    }
    if (const std::string kind = kindNote(file); !kind.empty()) description_.notes.push_back(kind);
    if (const auto cut = file.shortage()) {
        const auto writing = shared::beingWritten(file.path());
        description_.notes.push_back(
            fmt::format("The file is {} ({} of {} bytes): its last fields cannot be read{}.",
                        writing ? "being written" : "cut short", cut->found, cut->expected,
                        writing ? " yet" : ""));
    }
    for (const char* name : {"TITLE", "START_DATE", "SIMULATION_START_DATE",
                             "SIMULATION_INITIALIZATION_TYPE", "MAP_PROJ_CHAR"}) {
        if (const auto value = file.text(name)) description_.attributes.emplace_back(name, *value);
    }
    for (const char* name : {"DX", "DY", "DT", "MP_PHYSICS", "MAP_PROJ", "CEN_LAT", "CEN_LON",
                             "GRID_ID", "RA_LW_PHYSICS", "RA_SW_PHYSICS"}) {
        if (const auto value = file.number(name)) {
            description_.attributes.emplace_back(name, fmt::format("{:.6g}", *value));
        }
    }
}

void WrfFile::addFields() {
    UnitNotes units;
    air_ = findAir(tiles_, units, description_.notes);
    fields_ = {derived("interface_height", "altitude", "m",
                       "height of layer interfaces above sea level, " + air_.heightText,
                       NEPH_ROLE_INTERFACE_HEIGHT, Source::interfaceHeight),
               derived("air_pressure", "air_pressure", "Pa", air_.pressureText,
                       NEPH_ROLE_AIR_PRESSURE, Source::airPressure),
               derived("air_temperature", "air_temperature", "K", air_.temperatureText,
                       NEPH_ROLE_AIR_TEMPERATURE, Source::airTemperature),
               derived("dry_air_density", "", "kg m-3",
                       "density of dry air, from pressure, temperature and QVAPOR",
                       NEPH_ROLE_DRY_AIR_DENSITY, Source::dryAirDensity)};
    for (Field& field : fields_) field.size = description_.size;
    ++fields_.front().size[2];
    if (!air_.vapour.empty()) fields_.push_back(vapourOf(air_, description_.size));
    auto hydrometeors = findHydrometeors(tiles_, scheme_, units, description_.notes);
    std::ranges::move(hydrometeors, std::back_inserter(fields_));
    auto winds = findWinds(tiles_, units, description_.notes);
    for (Field& wind : winds) wind.size = description_.size;
    std::ranges::move(winds, std::back_inserter(fields_));
    auto others = otherFields(tiles_, fields_);
    std::ranges::move(others, std::back_inserter(fields_));
    // Derived fields first, then the others in the order of the file.
    std::ranges::stable_sort(fields_, {}, [](const Field& field) {
        return field.terms.empty() ? -1 : field.terms.front().variable->id;
    });
    units.addTo(description_.notes);
    for (const Field& field : fields_) {
        if (field.role == NEPH_ROLE_OTHER) continue;
        const NcVariable& leading = leadingVariable(field);
        if (!leading.deflated || leading.chunk.size() < 2) continue;
        const auto rows = static_cast<unsigned>(leading.chunk[leading.chunk.size() - 2]);
        description_.rowsTogether = std::max(description_.rowsTogether, rows);
    }
    description_.variables.assign(fields_.begin(), fields_.end());
}

/// Throws Failure if levels are stored from the top down.
void WrfFile::requireUpward() const {
    const NcVariable& height = *air_.height.front().variable;
    const std::size_t top = height.axes[height.axes.size() - 3].length - 1;
    std::array<float, 2> ends{};
    for (const std::size_t end : {0U, 1U}) {
        const std::size_t z = end == 0 ? 0 : top;
        readSum(air_.height, times_.records.front(), Box{{0, 0, z}, {1, 1, z + 1}},
                std::span(ends).subspan(end, 1));
    }
    if (!(ends[1] < ends[0])) return;
    throw Failure{"its levels run from the top down",
                  fmt::format("{} falls from {:g} to {:g} along {}", height.name, ends[0], ends[1],
                              tiles_.axes().centre[2]),
                  "levels from the ground up",
                  fmt::format("ncpdq -a -{0}{1}{2} IN.nc OUT.nc", tiles_.axes().centre[2],
                              tiles_.axes().face[2].empty() ? "" : ",-", tiles_.axes().face[2])};
}

/// Whether a variable was written at a record: the file is long enough, and the first cell is not
/// missing where it is there one record before.
bool WrfFile::isFinished(const NcVariable& variable, std::size_t record) const {
    const auto shape = tiles_.shapeOf(variable);
    if (!shape || !shape->timed) return true;
    if (!tiles_.first().holds(variable, record)) return false;
    const auto isThere = [&](std::size_t at) {
        float value = 0.0f;
        tiles_.read(variable, at, Box{{0, 0, 0}, {1, 1, 1}}, {&value, 1});
        return !std::isnan(value);
    };
    return isThere(record) || !isThere(record - 1);
}

/// Leaves out the last time if the model was stopped while it wrote it. Models write variables in
/// the order of the file, so the last one that is used tells.
void WrfFile::dropUnfinished() {
    if (times_.times.size() < 2) return;
    const NcVariable* last = nullptr;
    const auto consider = [&](const std::vector<Term>& terms) {
        for (const Term& term : terms) {
            if (last == nullptr || term.variable->id > last->id) last = term.variable;
        }
    };
    for (const Field& field : fields_) {
        if (field.role != NEPH_ROLE_OTHER) consider(field.terms);
    }
    for (const auto* terms : {&air_.height, &air_.pressure, &air_.heat, &air_.vapour}) {
        consider(*terms);
    }
    const std::size_t record = times_.records.back();
    if (last == nullptr || record == 0 || isFinished(*last, record)) return;
    description_.notes.push_back(
        fmt::format("The time {} is left out: its record was begun, but {} is not in it.",
                    times_.times.back().label, last->name));
    times_.times.pop_back();
    times_.records.pop_back();
}

}  // namespace wrf
