// reader.cpp: the door of the WRF reader: core/reader_abi.h on one side, WrfFile on the other.
//
// Nothing is thrown through here: Failure and everything else become texts in the host's buffer.
#include <algorithm>
#include <cstring>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "core/reader_abi.h"
#include "readers/wrf_netcdf/wrf_file.h"

namespace {

template <typename T>
NephHeader header() {
    return {NEPH_READER_ABI_VERSION, static_cast<std::uint32_t>(sizeof(T))};
}

}  // namespace

/// The host's handle: the file, and its description in the ABI's structs, which point into `file`.
struct NephFile {
    explicit NephFile(const char* path) : file(path) { describe(); }

    void describe();

    wrf::WrfFile file;
    std::vector<NephTime> times;
    std::vector<NephVariable> variables;
    std::vector<NephAttribute> attributes;
    std::vector<const NephTime*> timePointers;
    std::vector<const NephVariable*> variablePointers;
    std::vector<const NephAttribute*> attributePointers;
    std::vector<const char*> notePointers;
    NephDescription description{};
};

void NephFile::describe() {
    for (const auto& time : file.times()) {
        times.push_back({header<NephTime>(), time.label.c_str(), time.seconds});
    }
    for (const auto& v : file.variables()) {
        variables.push_back({header<NephVariable>(),
                             v.name.c_str(),
                             v.standardName.c_str(),
                             v.units.c_str(),
                             v.description.c_str(),
                             v.role,
                             v.species,
                             {v.size[0], v.size[1], v.size[2]},
                             0,
                             0.0,
                             0.0});
    }
    for (const auto& [name, value] : file.attributes()) {
        attributes.push_back({header<NephAttribute>(), name.c_str(), value.c_str()});
    }
    for (const auto& time : times) timePointers.push_back(&time);
    for (const auto& variable : variables) variablePointers.push_back(&variable);
    for (const auto& attribute : attributes) attributePointers.push_back(&attribute);
    for (const auto& note : file.notes()) notePointers.push_back(note.c_str());
    description.header = header<NephDescription>();
    description.model = file.model().c_str();
    description.scheme = file.scheme().c_str();
    std::ranges::copy(file.size(), description.size);
    std::ranges::copy(file.spacingM(), description.spacing_m);
    description.time_count = static_cast<std::uint32_t>(timePointers.size());
    description.times = timePointers.data();
    description.variable_count = static_cast<std::uint32_t>(variablePointers.size());
    description.variables = variablePointers.data();
    description.note_count = static_cast<std::uint32_t>(notePointers.size());
    description.notes = notePointers.data();
    description.attribute_count = static_cast<std::uint32_t>(attributePointers.size());
    description.attributes = attributePointers.data();
}

namespace {

template <std::size_t N>
void put(char (&target)[N], const std::string& text) {
    const std::size_t length = std::min(text.size(), N - 1);
    std::memcpy(target, text.data(), length);
    target[length] = '\0';
}

/// Runs `work` and turns what it throws into a status and an error text.
template <typename Work>
NephStatus guarded(NephError* error, Work&& work) {
    wrf::Failure failure;
    try {
        work();
        return NEPH_OK;
    } catch (const wrf::Cancelled&) {
        return NEPH_CANCELLED;
    } catch (const wrf::Failure& thrown) {
        failure = thrown;
    } catch (const std::bad_alloc&) {
        failure.what = "there is not enough memory for its fields";
    } catch (const std::exception& thrown) {
        failure.what = thrown.what();
    } catch (...) {
        failure.what = "failed for an unknown reason";
    }
    if (error != nullptr && error->header.struct_size >= sizeof(NephError)) {
        put(error->what, failure.what);
        put(error->found, failure.found);
        put(error->expected, failure.expected);
        put(error->hint, failure.hint);
    }
    return NEPH_FAILED;
}

std::int32_t score(const char* path) {
    constexpr std::int32_t kContainerOnly = 5;
    constexpr std::int32_t kWrf = 90;
    try {
        if (wrf::containerOf(path) == wrf::Container::unknown) return 0;
        return wrf::looksLikeWrf(wrf::NcFile(path)) ? kWrf : kContainerOnly;
    } catch (...) {
        return kContainerOnly;
    }
}

NephStatus open(const char* path, NephFile** file, NephError* error) {
    return guarded(error, [&] { *file = std::make_unique<NephFile>(path).release(); });
}

const NephDescription* describe(NephFile* file) {
    return &file->description;
}

/// The box of a request, checked against the variable.
wrf::Box boxOf(const NephReadRequest& request, const wrf::Variable& variable) {
    wrf::Box box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (request.lower[axis] < 0 || request.upper[axis] <= request.lower[axis] ||
            request.upper[axis] > variable.size[axis]) {
            throw wrf::Failure{
                "the box asked for lies outside variable " + variable.name, {}, {}, {}};
        }
        box.lower[axis] = static_cast<std::size_t>(request.lower[axis]);
        box.upper[axis] = static_cast<std::size_t>(request.upper[axis]);
    }
    if (request.values == nullptr || request.value_count != box.layer() * box.length(2)) {
        throw wrf::Failure{
            "the buffer does not fit the box of variable " + variable.name, {}, {}, {}};
    }
    return box;
}

NephStatus read(NephFile* file, NephReadRequest* request, NephError* error) {
    return guarded(error, [&] {
        request->values_written = 0;
        if (request->header.struct_size < sizeof(NephReadRequest) ||
            request->variable >= file->file.variables().size() ||
            request->time >= file->file.times().size()) {
            throw wrf::Failure{"there is no such variable or time", {}, {}, {}};
        }
        const wrf::Variable& variable = file->file.variables()[request->variable];
        const wrf::Box box = boxOf(*request, variable);
        const auto tick = [&](double fraction) {
            if (request->progress != nullptr &&
                request->progress(request->progress_context, fraction) == 0) {
                throw wrf::Cancelled{};
            }
        };
        const std::span values(request->values, static_cast<std::size_t>(request->value_count));
        file->file.read(variable, request->time, box, values, tick);
        request->values_written = request->value_count;
    });
}

void close(NephFile* file) {
    delete file;
}

const NephReader kReader{
    header<NephReader>(),
    "wrf_netcdf",
    "1.0",
    "WRF output (NetCDF-3, 64-bit offset, NetCDF-4)",
    "nc",
    &score,
    &open,
    &describe,
    &read,
    &close,
};

}  // namespace

extern "C" NEPH_READER_EXPORT const NephReader* nephReader(std::uint32_t hostAbiVersion) {
    return hostAbiVersion == NEPH_READER_ABI_VERSION ? &kReader : nullptr;
}
