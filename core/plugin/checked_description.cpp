// checked_description.cpp: checks on what a reader says of a file. Nothing refers to its memory
// afterwards.
#include "core/plugin/checked_description.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <set>
#include <span>
#include <string_view>
#include <utility>

#include "core/base/error.h"
#include "core/base/utc_time.h"
#include "core/geo/map_place.h"
#include "core/plugin/abi_versions.h"

namespace neph {
namespace {

// Limits on what a description may claim: far above any model's output, far below what would
// exhaust memory.
constexpr std::uint32_t kMaxEntries = 1'000'000;
constexpr std::size_t kMaxTextLength = 65536;
constexpr std::int32_t kMaxAxis = 1 << 20;
constexpr std::int64_t kMaxCells = std::int64_t{1} << 36;
constexpr double kMaxSpacingM = 1e7;  // a quarter of the way around the Earth
constexpr double kMaxExtentM = 1e9;

// The enumerations of dataset_info.h and of the ABI have the same values, so casts convert them.
static_assert(static_cast<int>(VariableRole::mixingRatio) == NEPH_ROLE_MIXING_RATIO);
static_assert(static_cast<int>(VariableRole::interfaceHeight) == NEPH_ROLE_INTERFACE_HEIGHT);
static_assert(static_cast<int>(VariableRole::waterVapour) == NEPH_ROLE_WATER_VAPOUR);
static_assert(kVariableRoles == NEPH_ROLE_DUST_NUMBER + 1);
static_assert(kMicrophysics == NEPH_MICROPHYSICS_MORRISON + 1);
static_assert(static_cast<int>(Species::cloud) == NEPH_SPECIES_CLOUD);
static_assert(kSpeciesCount == NEPH_SPECIES_HAIL + 1);

/// A string of the plugin, at most kMaxTextLength long; empty for a null pointer.
std::string checkedText(const char* text, std::string_view of) {
    if (text == nullptr) return {};
    const std::size_t length = strnlen(text, kMaxTextLength);
    if (length == kMaxTextLength) throw ReaderFault{fmt::format("text of {} has no end", of)};
    return {text, length};
}

template <typename T>
const T& checkedStruct(const T* pointer, std::string_view of) {
    if (pointer == nullptr) throw ReaderFault{fmt::format("{} is null", of)};
    if (!servesAbi(pointer->header.abi_version) || pointer->header.struct_size < sizeof(T)) {
        throw ReaderFault{fmt::format("{} has ABI {} and {} bytes, not {} and {}", of,
                                      pointer->header.abi_version, pointer->header.struct_size,
                                      servedAbiText(), sizeof(T))};
    }
    return *pointer;
}

/// A struct that readers built for an earlier form of it hand over shorter: at least `firstForm`
/// bytes, and zero for the rest.
template <typename T>
T completedStruct(const T* pointer, std::size_t firstForm, std::string_view of) {
    if (pointer == nullptr) throw ReaderFault{fmt::format("{} is null", of)};
    const NephHeader header = pointer->header;
    if (!servesAbi(header.abi_version) || header.struct_size < firstForm) {
        throw ReaderFault{fmt::format("{} has ABI {} and {} bytes, not {} and {}", of,
                                      header.abi_version, header.struct_size, servedAbiText(),
                                      firstForm)};
    }
    T whole{};
    std::memcpy(&whole, pointer, std::min<std::size_t>(header.struct_size, sizeof whole));
    return whole;
}

template <typename T>
std::span<const T> checkedList(const T* list, std::uint32_t count, std::string_view of) {
    if (count > kMaxEntries) throw ReaderFault{fmt::format("{} {} are claimed", count, of)};
    if (count > 0 && list == nullptr) throw ReaderFault{fmt::format("the list of {} is null", of)};
    return {list, count};
}

/// The product is checked step by step, so that it cannot overflow.
glm::ivec3 checkedSize(const std::int32_t (&size)[3], std::string_view of) {
    std::int64_t cells = 1;
    for (std::int32_t length : size) {
        if (length < 1 || length > kMaxAxis) {
            throw ReaderFault{
                fmt::format("size {} x {} x {} of {}", size[0], size[1], size[2], of)};
        }
        cells *= length;
        if (cells > kMaxCells) throw ReaderFault{fmt::format("{} cells of {}", cells, of)};
    }
    return {size[0], size[1], size[2]};
}

/// Unknown roles become `other` and unknown species none, so that newer readers still work.
VariableInfo checkedVariable(const NephVariable* pointer) {
    const NephVariable raw = completedStruct(pointer, offsetof(NephVariable, reason), "a variable");
    VariableInfo variable;
    variable.name = checkedText(raw.name, "a variable's name");
    if (variable.name.empty()) throw ReaderFault{"a variable has no name"};
    variable.standardName = checkedText(raw.standard_name, variable.name);
    variable.units = checkedText(raw.units, variable.name);
    variable.description = checkedText(raw.description, variable.name);
    variable.size = checkedSize(raw.size, variable.name);
    variable.reason = checkedText(raw.reason, variable.name);
    if (raw.role >= 0 && raw.role < kVariableRoles) {
        variable.role = static_cast<VariableRole>(raw.role);
    }
    if (raw.species >= 0 && raw.species < kSpeciesCount) {
        variable.species = static_cast<Species>(raw.species);
    }
    return variable;
}

/// Whether a variable's size fits its role on a grid of `cells`.
bool fitsGrid(const VariableInfo& variable, glm::ivec3 cells) {
    if (variable.role == VariableRole::other) return true;
    if (variable.role == VariableRole::interfaceHeight) ++cells.z;
    const bool ofSpecies = variable.role == VariableRole::mixingRatio ||
                           variable.role == VariableRole::effectiveRadius ||
                           variable.role == VariableRole::numberConcentration;
    const bool profile = variable.size == glm::ivec3(1, 1, cells.z);
    return variable.size == cells || (profile && !ofSpecies);
}

/// Removes the role of variables that do not lie on the grid, with a note; they can still be read
/// by name.
void dropMisfits(DatasetInfo& description) {
    for (VariableInfo& variable : description.variables) {
        if (fitsGrid(variable, description.size)) continue;
        variable.role = VariableRole::other;
        variable.species.reset();
        description.notes.push_back(
            fmt::format("{} is not used: it has {} x {} x {} values and does not lie on the grid.",
                        variable.name, variable.size.x, variable.size.y, variable.size.z));
    }
}

std::vector<TimeInfo> checkedTimes(const NephDescription& raw) {
    std::vector<TimeInfo> times;
    for (const NephTime* pointer : checkedList(raw.times, raw.time_count, "times")) {
        const NephTime time = completedStruct(pointer, offsetof(NephTime, grid_offset_m), "a time");
        if (!std::isfinite(time.seconds)) throw ReaderFault{"a time is not a finite number"};
        const glm::dvec2 offsetM(time.grid_offset_m[0], time.grid_offset_m[1]);
        for (const double metres : {offsetM.x, offsetM.y}) {
            if (std::abs(metres) <= kMaxExtentM) continue;
            throw ReaderFault{fmt::format("the grid has moved by {} m", metres)};
        }
        times.push_back({.label = checkedText(time.label, "a time"),
                         .seconds = time.seconds,
                         .file = {},
                         .indexInFile = static_cast<int>(times.size()),
                         .gridOffsetM = offsetM});
    }
    if (times.empty()) throw ReaderFault{"it has no times"};
    return times;
}

std::vector<VariableInfo> checkedVariables(const NephDescription& raw) {
    std::vector<VariableInfo> variables;
    std::set<std::string> names;
    for (const NephVariable* pointer :
         checkedList(raw.variables, raw.variable_count, "variables")) {
        variables.push_back(checkedVariable(pointer));
        if (!names.insert(variables.back().name).second) {
            throw ReaderFault{fmt::format("variable {} is there twice", variables.back().name)};
        }
    }
    return variables;
}

/// Faces of cells along one axis; empty for none. They start at 0 and increase.
std::vector<double> checkedEdges(const double* edges, int cells) {
    if (edges == nullptr) return {};
    const std::span<const double> faces(edges, static_cast<std::size_t>(cells) + 1);
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const bool fits = i == 0 ? faces[0] == 0.0 : faces[i] > faces[i - 1];
        if (!fits || !(faces[i] <= kMaxExtentM)) {
            throw ReaderFault{fmt::format("face {} of the cells lies at {} m", i, faces[i])};
        }
    }
    return {faces.begin(), faces.end()};
}

/// Domain, faces and parts, which readers built for an earlier form of the struct lack.
void addNewer(const NephDescription& raw, DatasetInfo& description) {
    for (int axis = 0; axis < 2; ++axis) {
        description.edgesM[static_cast<std::size_t>(axis)] =
            checkedEdges(raw.edges_m[axis], description.size[axis]);
    }
    description.domain = checkedText(raw.domain, "the domain");
    for (const char* part : checkedList(raw.parts, raw.part_count, "parts")) {
        description.parts.emplace_back(checkedText(part, "a part"));
    }
}

/// What a nested run states of its domains. A corner that no grid can have makes the ratio unknown.
NestNumbers checkedNest(const NephDescription& raw) {
    constexpr std::uint32_t kMostDomains = 1000, kMostRatio = 100;
    constexpr int kMostCorner = 1 << 20;
    if (raw.domain_number > kMostDomains || raw.parent_number > kMostDomains) return {};
    NestNumbers nest{.number = static_cast<int>(raw.domain_number),
                     .parent = static_cast<int>(raw.parent_number),
                     .cornerCells = {raw.parent_corner[0], raw.parent_corner[1]}};
    const bool possible = nest.cornerCells.x >= 0 && nest.cornerCells.x <= kMostCorner &&
                          nest.cornerCells.y >= 0 && nest.cornerCells.y <= kMostCorner &&
                          raw.parent_ratio <= kMostRatio;
    if (possible) nest.ratio = static_cast<int>(raw.parent_ratio);
    return nest;
}

/// The place on the earth, if it can be used; else a note says why not.
void addPlace(const NephDescription& raw, DatasetInfo& description) {
    MapGrid map{.projection = checkedText(raw.projection, "the projection"),
                .originM = {raw.map_origin_m[0], raw.map_origin_m[1]},
                .mapPerGrid = {raw.map_per_grid[0], raw.map_per_grid[1]}};
    description.noPlace = checkedText(raw.no_place, "the reason for no place");
    if (map.projection.empty()) return;
    for (int axis = 0; axis < 2; ++axis) {
        if (map.mapPerGrid[axis] == 0.0) map.mapPerGrid[axis] = 1.0;
    }
    std::string reason;
    try {
        if (!MapPlace(map).geoAt(0.5 * description.extentM())) {
            reason = "the middle of the grid lies beyond the edge of its map";
        }
    } catch (const Error& error) {
        reason = error.parts().what;
    }
    if (reason.empty()) {
        description.map = std::move(map);
        return;
    }
    description.notes.push_back(fmt::format("The place on the earth is not known: {} ({}).", reason,
                                            map.projection.substr(0, 200)));
}

/// The date of each time, from that of the clock's zero; a text that is no date is a note.
void addDates(const NephDescription& raw, DatasetInfo& description) {
    const std::string text = checkedText(raw.utc_of_zero, "the date");
    if (text.empty()) return;
    const auto zero = utcOfText(text);
    if (!zero) {
        description.notes.push_back(
            fmt::format("Dates are not known: {} is no time in UTC such as 2021-08-14T18:00:00Z.",
                        text.substr(0, 200)));
        return;
    }
    const UtcTime last = utcOf({.year = 9999, .day = 365, .hour = 24.0});
    for (TimeInfo& time : description.times) {
        // In doubles: a time of a damaged file may be beyond any calendar.
        const double seconds = zero->time_since_epoch().count() + time.seconds;
        const bool known = std::abs(seconds) <= last.time_since_epoch().count();
        if (known) time.utc = UtcTime(UtcTime::duration(seconds));
    }
}

}  // namespace

DatasetInfo checkedDescription(const NephDescription* pointer) {
    const NephDescription raw =
        completedStruct(pointer, offsetof(NephDescription, edges_m), "the description");
    DatasetInfo description;
    description.model = checkedText(raw.model, "the model");
    description.scheme = checkedText(raw.scheme, "the scheme");
    if (raw.microphysics >= 0 && raw.microphysics < kMicrophysics) {
        description.microphysics = static_cast<Microphysics>(raw.microphysics);
    }
    const double droplets = raw.cloud_droplets_per_m3;
    if (!std::isfinite(droplets) || droplets < 0.0) {
        throw ReaderFault{fmt::format("{} cloud droplets per m3", droplets)};
    }
    description.cloudDropletsPerM3 = droplets;
    description.size = checkedSize(raw.size, "the grid");
    for (double spacing : raw.spacing_m) {
        if (!(spacing > 0.0 && spacing <= kMaxSpacingM)) {
            throw ReaderFault{fmt::format("a grid spacing of {} m", spacing)};
        }
    }
    description.spacingM = {raw.spacing_m[0], raw.spacing_m[1]};
    addNewer(raw, description);
    description.rowsTogether = raw.rows_together;
    description.nest = checkedNest(raw);
    description.times = checkedTimes(raw);
    description.variables = checkedVariables(raw);
    for (const char* note : checkedList(raw.notes, raw.note_count, "notes")) {
        description.notes.push_back(checkedText(note, "a note"));
    }
    for (const NephAttribute* entry :
         checkedList(raw.attributes, raw.attribute_count, "attributes")) {
        const NephAttribute& attribute = checkedStruct(entry, "an attribute");
        description.attributes[checkedText(attribute.name, "an attribute")] =
            checkedText(attribute.value, "an attribute");
    }
    addPlace(raw, description);
    addDates(raw, description);
    dropMisfits(description);
    return description;
}

}  // namespace neph
