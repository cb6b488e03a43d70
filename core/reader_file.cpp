// reader_file.cpp: calls through the ABI and the checks on what comes back.
#include "core/reader_file.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <exception>
#include <set>
#include <string_view>

#include "core/error.h"

namespace neph {
namespace {

// Bounds on what a description may claim: far above any model's output, far below what would
// exhaust memory.
constexpr std::uint32_t kMaxEntries = 1'000'000;
constexpr std::size_t kMaxTextLength = 65536;
constexpr std::int32_t kMaxAxis = 1 << 20;
constexpr std::int64_t kMaxCells = std::int64_t{1} << 36;

/// One faulty claim of a plugin; becomes an Error that names plugin and file.
struct Fault {
    std::string text;
};

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

FileVariable checkedVariable(const NephVariable* pointer) {
    const NephVariable& raw = checkedStruct(pointer, "a variable");
    FileVariable variable;
    variable.name = checkedText(raw.name, "a variable's name");
    if (variable.name.empty()) throw Fault{"a variable has no name"};
    variable.standardName = checkedText(raw.standard_name, variable.name);
    variable.units = checkedText(raw.units, variable.name);
    variable.description = checkedText(raw.description, variable.name);
    variable.size = checkedSize(raw.size, variable.name);
    const bool roleKnown =
        raw.role >= NEPH_ROLE_OTHER && raw.role <= NEPH_ROLE_NUMBER_CONCENTRATION;
    variable.role = roleKnown ? raw.role : NEPH_ROLE_OTHER;
    const bool speciesKnown = raw.species >= NEPH_SPECIES_CLOUD && raw.species <= NEPH_SPECIES_HAIL;
    variable.species = speciesKnown ? raw.species : NEPH_SPECIES_NONE;
    return variable;
}

std::vector<FileTime> checkedTimes(const NephDescription& raw) {
    std::vector<FileTime> times;
    for (const NephTime* pointer : checkedList(raw.times, raw.time_count, "times")) {
        const NephTime& time = checkedStruct(pointer, "a time");
        if (!std::isfinite(time.seconds)) throw Fault{"a time is not a finite number"};
        times.push_back({checkedText(time.label, "a time"), time.seconds});
    }
    if (times.empty()) throw Fault{"it has no times"};
    return times;
}

std::vector<FileVariable> checkedVariables(const NephDescription& raw) {
    std::vector<FileVariable> variables;
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

FileDescription checkedDescription(const NephDescription* pointer) {
    const NephDescription& raw = checkedStruct(pointer, "the description");
    FileDescription description;
    description.model = checkedText(raw.model, "the model");
    description.scheme = checkedText(raw.scheme, "the scheme");
    const bool schemeKnown = raw.microphysics >= NEPH_MICROPHYSICS_UNKNOWN &&
                             raw.microphysics <= NEPH_MICROPHYSICS_MORRISON;
    description.microphysics = schemeKnown ? raw.microphysics : NEPH_MICROPHYSICS_UNKNOWN;
    const double droplets = raw.cloud_droplets_per_m3;
    if (!std::isfinite(droplets) || droplets < 0.0) {
        throw Fault{fmt::format("{} cloud droplets per m3", droplets)};
    }
    description.cloudDropletsPerM3 = droplets;
    description.size = checkedSize(raw.size, "the grid");
    for (double spacing : raw.spacing_m) {
        if (!std::isfinite(spacing) || spacing <= 0.0) {
            throw Fault{fmt::format("a grid spacing of {} m", spacing)};
        }
    }
    description.spacingM = {raw.spacing_m[0], raw.spacing_m[1]};
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

Error errorFrom(const NephError& raw, const std::filesystem::path& path,
                const ReaderPlugin& reader) {
    ErrorParts parts{partOf(raw.where), partOf(raw.what), partOf(raw.found), partOf(raw.expected),
                     partOf(raw.hint)};
    if (parts.where.empty()) parts.where = path.string();
    if (parts.what.empty())
        parts.what = fmt::format("reader {} failed and gave no reason", reader.id);
    return Error(std::move(parts));
}

Error faultOf(const ReaderPlugin& reader, const std::filesystem::path& path,
              const std::string& text) {
    return Error({.where = path.string(),
                  .what = fmt::format("reader {} is faulty: {}", reader.id, text),
                  .hint = fmt::format("report this to the author of {}", reader.library.string())});
}

/// Runs one call of a plugin; what it throws against the rules becomes an Error.
template <typename Call>
auto guarded(const ReaderPlugin& reader, const std::filesystem::path& path, Call&& call) {
    try {
        return call();
    } catch (const Fault& fault) {
        throw faultOf(reader, path, fault.text);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& problem) {
        throw faultOf(reader, path, fmt::format("it threw {}", problem.what()));
    }
}

struct ProgressBridge {
    const Progress& progress;
    std::exception_ptr thrown{};  ///< kept here, because nothing may be thrown through the plugin
};

std::int32_t reportProgress(void* context, double fraction) {
    auto& bridge = *static_cast<ProgressBridge*>(context);
    try {
        return goOn(bridge.progress, fraction) ? 1 : 0;
    } catch (...) {
        bridge.thrown = std::current_exception();
        return 0;
    }
}

}  // namespace

void ReaderFile::Closer::operator()(NephFile* file) const {
    calls->close(file);
}

ReaderFile::ReaderFile(std::shared_ptr<const ReaderPlugin> reader, std::filesystem::path path)
    : reader_(std::move(reader)), path_(std::move(path)), file_(nullptr, Closer{reader_->calls}) {
    NephError error = emptyError();
    NephFile* raw = nullptr;
    const NephStatus status =
        guarded(*reader_, path_, [&] { return reader_->calls->open(path_.c_str(), &raw, &error); });
    if (status != NEPH_OK) throw errorFrom(error, path_, *reader_);
    if (raw == nullptr) throw faultOf(*reader_, path_, "open gave no handle");
    file_.reset(raw);
    description_ = guarded(
        *reader_, path_, [&] { return checkedDescription(reader_->calls->describe(file_.get())); });
}

void ReaderFile::read(std::size_t variable, std::size_t time, glm::ivec3 lower, glm::ivec3 upper,
                      std::span<float> values, const Progress& progress) {
    ProgressBridge bridge{progress};
    NephReadRequest request{};
    request.header = {NEPH_READER_ABI_VERSION, sizeof(NephReadRequest)};
    request.variable = static_cast<std::uint32_t>(variable);
    request.time = static_cast<std::uint32_t>(time);
    for (int axis = 0; axis < 3; ++axis) {
        request.lower[axis] = lower[axis];
        request.upper[axis] = upper[axis];
    }
    request.values = values.data();
    request.value_count = values.size();
    request.progress = &reportProgress;
    request.progress_context = &bridge;
    NephError error = emptyError();
    const NephStatus status = guarded(
        *reader_, path_, [&] { return reader_->calls->read(file_.get(), &request, &error); });
    if (bridge.thrown) std::rethrow_exception(bridge.thrown);
    if (status == NEPH_CANCELLED) throw Cancelled{};
    if (status != NEPH_OK) throw errorFrom(error, path_, *reader_);
    if (request.values_written != values.size()) {
        throw faultOf(
            *reader_, path_,
            fmt::format("read gave {} values of {}, {} were asked for", request.values_written,
                        description_.variables[variable].name, values.size()));
    }
}

}  // namespace neph
