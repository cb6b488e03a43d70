// plugin_file.cpp: calls through the ABI, and the checks on their results.
#include "core/plugin/plugin_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <exception>
#include <limits>
#include <set>
#include <string_view>
#include <utility>

#include "core/base/error.h"

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
static_assert(kVariableRoles == NEPH_ROLE_NUMBER_CONCENTRATION + 1);
static_assert(kMicrophysics == NEPH_MICROPHYSICS_MORRISON + 1);
static_assert(static_cast<int>(Species::cloud) == NEPH_SPECIES_CLOUD);
static_assert(kSpeciesCount == NEPH_SPECIES_HAIL + 1);

/// One faulty claim of a plugin; it becomes an Error that names plugin and file.
struct Fault {
    std::string text;
};

/// A string of the plugin, at most kMaxTextLength long; empty for a null pointer.
std::string checkedText(const char* text, std::string_view of) {
    if (text == nullptr) return {};
    const std::size_t length = strnlen(text, kMaxTextLength);
    if (length == kMaxTextLength) throw Fault{fmt::format("text of {} has no end", of)};
    return {text, length};
}

template <typename T>
const T& checkedStruct(const T* pointer, std::string_view of) {
    if (pointer == nullptr) throw Fault{fmt::format("{} is null", of)};
    if (pointer->header.abi_version != NEPH_READER_ABI_VERSION ||
        pointer->header.struct_size < sizeof(T)) {
        throw Fault{fmt::format("{} has ABI {} and {} bytes, not ABI {} and {}", of,
                                pointer->header.abi_version, pointer->header.struct_size,
                                NEPH_READER_ABI_VERSION, sizeof(T))};
    }
    return *pointer;
}

template <typename T>
std::span<const T> checkedList(const T* list, std::uint32_t count, std::string_view of) {
    if (count > kMaxEntries) throw Fault{fmt::format("{} {} are claimed", count, of)};
    if (count > 0 && list == nullptr) throw Fault{fmt::format("the list of {} is null", of)};
    return {list, count};
}

/// The product is checked step by step, so that it cannot overflow.
glm::ivec3 checkedSize(const std::int32_t (&size)[3], std::string_view of) {
    std::int64_t cells = 1;
    for (std::int32_t length : size) {
        if (length < 1 || length > kMaxAxis) {
            throw Fault{fmt::format("size {} x {} x {} of {}", size[0], size[1], size[2], of)};
        }
        cells *= length;
        if (cells > kMaxCells) throw Fault{fmt::format("{} cells of {}", cells, of)};
    }
    return {size[0], size[1], size[2]};
}

/// Unknown roles become `other` and unknown species none, so that newer readers still work.
VariableInfo checkedVariable(const NephVariable* pointer) {
    const NephVariable& raw = checkedStruct(pointer, "a variable");
    VariableInfo variable;
    variable.name = checkedText(raw.name, "a variable's name");
    if (variable.name.empty()) throw Fault{"a variable has no name"};
    variable.standardName = checkedText(raw.standard_name, variable.name);
    variable.units = checkedText(raw.units, variable.name);
    variable.description = checkedText(raw.description, variable.name);
    variable.size = checkedSize(raw.size, variable.name);
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
        const NephTime& time = checkedStruct(pointer, "a time");
        if (!std::isfinite(time.seconds)) throw Fault{"a time is not a finite number"};
        times.push_back(
            {checkedText(time.label, "a time"), time.seconds, {}, static_cast<int>(times.size())});
    }
    if (times.empty()) throw Fault{"it has no times"};
    return times;
}

std::vector<VariableInfo> checkedVariables(const NephDescription& raw) {
    std::vector<VariableInfo> variables;
    std::set<std::string> names;
    for (const NephVariable* pointer :
         checkedList(raw.variables, raw.variable_count, "variables")) {
        variables.push_back(checkedVariable(pointer));
        if (!names.insert(variables.back().name).second) {
            throw Fault{fmt::format("variable {} is there twice", variables.back().name)};
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
            throw Fault{fmt::format("face {} of the cells lies at {} m", i, faces[i])};
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

/// The description as this host knows it: what a shorter one lacks is zero.
NephDescription completed(const NephDescription* pointer) {
    constexpr std::size_t kFirstForm = offsetof(NephDescription, edges_m);
    if (pointer == nullptr) throw Fault{"the description is null"};
    const NephHeader header = pointer->header;
    if (header.abi_version != NEPH_READER_ABI_VERSION || header.struct_size < kFirstForm) {
        throw Fault{fmt::format("the description has ABI {} and {} bytes, not ABI {} and {}",
                                header.abi_version, header.struct_size, NEPH_READER_ABI_VERSION,
                                kFirstForm)};
    }
    NephDescription description{};
    std::memcpy(&description, pointer,
                std::min<std::size_t>(header.struct_size, sizeof description));
    return description;
}

/// Copies the description while checking it: nothing refers to the memory of the plugin afterwards.
DatasetInfo checkedDescription(const NephDescription* pointer) {
    const NephDescription raw = completed(pointer);
    DatasetInfo description;
    description.model = checkedText(raw.model, "the model");
    description.scheme = checkedText(raw.scheme, "the scheme");
    if (raw.microphysics >= 0 && raw.microphysics < kMicrophysics) {
        description.microphysics = static_cast<Microphysics>(raw.microphysics);
    }
    const double droplets = raw.cloud_droplets_per_m3;
    if (!std::isfinite(droplets) || droplets < 0.0) {
        throw Fault{fmt::format("{} cloud droplets per m3", droplets)};
    }
    description.cloudDropletsPerM3 = droplets;
    description.size = checkedSize(raw.size, "the grid");
    for (double spacing : raw.spacing_m) {
        if (!(spacing > 0.0 && spacing <= kMaxSpacingM)) {
            throw Fault{fmt::format("a grid spacing of {} m", spacing)};
        }
    }
    description.spacingM = {raw.spacing_m[0], raw.spacing_m[1]};
    addNewer(raw, description);
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
    dropMisfits(description);
    return description;
}

NephError emptyError() {
    NephError error{};
    error.header = {NEPH_READER_ABI_VERSION, sizeof(NephError)};
    return error;
}

template <std::size_t N>
std::string partOf(const char (&text)[N]) {
    return {text, strnlen(text, N)};
}

/// The error of a reader, completed with the path and a reason if they are missing.
Error errorFrom(const NephError& raw, const std::filesystem::path& path,
                const std::string& reader) {
    ErrorParts parts{partOf(raw.where), partOf(raw.what), partOf(raw.found), partOf(raw.expected),
                     partOf(raw.hint)};
    if (parts.where.empty()) parts.where = path.string();
    if (parts.what.empty()) parts.what = fmt::format("reader {} failed and gave no reason", reader);
    return Error(std::move(parts));
}

/// Carries progress through the C callback.
struct ProgressBridge {
    const Progress& progress;
    bool stopped = false;
    std::exception_ptr thrown{};  ///< rethrown later: nothing may be thrown through the plugin
};

std::int32_t reportProgress(void* context, double fraction) {
    auto& bridge = *static_cast<ProgressBridge*>(context);
    try {
        fraction = std::isfinite(fraction) ? std::clamp(fraction, 0.0, 1.0) : 0.0;
        bridge.stopped = bridge.stopped || !goOn(bridge.progress, fraction);
    } catch (...) {
        bridge.thrown = std::current_exception();
        bridge.stopped = true;
    }
    return bridge.stopped ? 0 : 1;
}

constexpr float kUntouched = -6.02e23f;  // a value that no field contains

}  // namespace

void PluginFile::Closer::operator()(NephFile* file) const {
    try {
        calls->close(file);
    } catch (...) {  // breaks the ABI, but there is nobody left to report it to
    }
}

Error PluginFile::faulty(const std::string& text) const {
    return Error({.where = path_.string(),
                  .what = fmt::format("reader {} is faulty: {}", reader_, text),
                  .hint = "report this to the author of the reader"});
}

void PluginFile::guarded(const std::function<void()>& call) const {
    try {
        call();
    } catch (const Error&) {
        throw;
    } catch (const Fault& fault) {
        throw faulty(fault.text);
    } catch (const std::bad_alloc&) {
        throw Error({.where = path_.string(), .what = "there is not enough memory to read it"});
    } catch (const std::exception& problem) {
        throw faulty(fmt::format("it threw {}", problem.what()));
    } catch (...) {
        throw faulty("it threw what is no std::exception");
    }
}

PluginFile::PluginFile(const NephReader& calls, std::string reader, std::filesystem::path path)
    : calls_(&calls),
      reader_(std::move(reader)),
      path_(std::move(path)),
      file_(nullptr, Closer{&calls}) {
    guarded([this] {
        NephError error = emptyError();
        NephFile* raw = nullptr;
        const NephStatus status = calls_->open(path_.c_str(), &raw, &error);
        if (status != NEPH_OK) throw errorFrom(error, path_, reader_);
        if (raw == nullptr) throw Fault{"open gave no handle"};
        file_.reset(raw);
        description_ = checkedDescription(calls_->describe(file_.get()));
    });
}

void PluginFile::read(std::size_t variable, std::size_t time, const CellBox& box,
                      std::span<float> room, const Progress& progress) {
    const std::span<float> values = room.first(room.size() - kGuardValues);
    const std::span<float> guard = room.last(kGuardValues);
    // What the reader does not write stays missing, and what it writes too much shows in the guard.
    std::ranges::fill(values, std::numeric_limits<float>::quiet_NaN());
    std::ranges::fill(guard, kUntouched);
    NephReadRequest request{};
    request.header = {NEPH_READER_ABI_VERSION, sizeof(NephReadRequest)};
    request.variable = static_cast<std::uint32_t>(variable);
    request.time = static_cast<std::uint32_t>(time);
    for (int axis = 0; axis < 3; ++axis) {
        request.lower[axis] = box.lower[axis];
        request.upper[axis] = box.upper[axis];
    }
    request.values = values.data();
    request.value_count = values.size();
    ProgressBridge bridge{progress};
    request.progress = &reportProgress;
    request.progress_context = &bridge;
    const std::string& name = description_.variables.at(variable).name;
    guarded([&] {
        NephError error = emptyError();
        const NephStatus status = calls_->read(file_.get(), &request, &error);
        if (bridge.stopped) return;
        if (status == NEPH_CANCELLED) throw Fault{"read was cancelled, and nobody had asked to"};
        if (status != NEPH_OK) throw errorFrom(error, path_, reader_);
        if (std::ranges::any_of(guard, [](float value) { return value != kUntouched; })) {
            throw Fault{
                fmt::format("read wrote beyond the {} values asked of {}", values.size(), name)};
        }
        if (request.values_written != values.size()) {
            throw Fault{fmt::format("read gave {} values of {}, {} were asked for",
                                    request.values_written, name, values.size())};
        }
    });
    if (bridge.thrown) std::rethrow_exception(bridge.thrown);
    if (bridge.stopped) throw Cancelled{};
}

}  // namespace neph
