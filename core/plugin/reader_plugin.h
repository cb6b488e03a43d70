// reader_plugin.h: a reader in C++: derive from File, throw Error, and export it with one macro.
//
// A thin layer over reader_abi.h for authors of readers; needs only C++17 and its standard library.
// Exceptions become the texts of NephError; descriptions are plain values that this header converts
// to the structs of the ABI. docs/write-a-reader.md builds a working reader from scratch.
#pragma once
#include <array>
#include <cstdint>
#include <cstring>
#include <exception>
#include <functional>
#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "reader_abi.h"

namespace neph::plugin {

/// Bad input, in the parts that the host formats: what is wrong (naming the variable or key), what
/// was found, what was expected, the next step. `where` is the file; if it is empty, the host fills
/// in the path that it opened.
struct Error {
    std::string what, found, expected, hint, where{};
};

/// Thrown by Request::tick when the host has asked to stop; do not catch it.
struct Cancelled {};

struct Time {
    std::string label;     ///< as the model writes it
    double seconds = 0.0;  ///< on one clock that all files of a series share
    /// How far the grid has moved over the ground, along x and y. reader_abi.h
    std::array<double, 2> gridOffsetM{};
};

struct Variable {
    std::string name;          ///< unique within the file
    std::string standardName;  ///< CF standard name, or empty
    std::string units;         ///< SI, of the values that `read` returns
    std::string description;
    NephRole role = NEPH_ROLE_OTHER;
    NephSpecies species = NEPH_SPECIES_NONE;
    std::array<int, 3> size{1, 1, 1};  ///< x, y, z; 1 where the variable lacks the axis
    std::string reason{};              ///< why it has its role, one phrase; or empty
};

/// Everything that is known without reading a field.
struct Description {
    std::string model, scheme;
    NephMicrophysics microphysics = NEPH_MICROPHYSICS_UNKNOWN;
    double cloudDropletsPerM3 = 0.0;  ///< prescribed by the run; 0 if unknown
    std::array<int, 3> size{};        ///< cells in x, y, z; x runs east, y north, z up
    std::array<double, 2> spacingM{};
    /// Faces of cells in x and y where these are not even, from 0; empty otherwise. reader_abi.h
    std::array<std::vector<double>, 2> edgesM{};
    std::string domain;                      ///< files with different texts never form one series
    std::vector<std::string> parts;          ///< paths of other files that are read as well
    std::string projection;                  ///< PROJ string to metres; empty: place unknown
    std::array<double, 2> mapOriginM{};      ///< the grid's south-west corner on that map
    std::array<double, 2> mapPerGrid{1, 1};  ///< metres on the map per metre of the grid
    std::string utcOfZero;      ///< when `seconds` are 0, "YYYY-MM-DDThh:mm:ssZ"; empty: unknown
    std::string noPlace;        ///< why there is none, where that is as it should be
    unsigned rowsTogether = 0;  ///< rows along y that are stored as one; 0 or 1: each by itself
    /// Numbers of a nested run's domains, and where it lies in its parent. reader_abi.h
    unsigned domainNumber = 0, parentNumber = 0;
    std::array<int, 2> parentCorner{};  ///< cells of the parent
    unsigned parentRatio = 0;           ///< cells along one of the parent; 0: unknown
    std::vector<Time> times;
    std::vector<Variable> variables;
    std::vector<std::string> notes;  ///< what was skipped or assumed, one sentence each
    std::vector<std::pair<std::string, std::string>> attributes;
};

/// One box of one variable at one time, checked against the description.
struct Request {
    std::size_t variable = 0, time = 0;           ///< indices into the description
    std::array<std::size_t, 3> lower{}, upper{};  ///< half-open, cells x, y, z
    float* values = nullptr;                      ///< x fastest, then y, then z; NaN where missing
    std::function<void(double)> tick;             ///< call with a fraction in [0, 1] between pieces

    std::size_t length(std::size_t axis) const { return upper[axis] - lower[axis]; }
    std::size_t count() const { return length(0) * length(1) * length(2); }
};

/// One open file. The constructor of a derived class reads only metadata and throws Error.
class File {
  public:
    virtual ~File() = default;
    virtual const Description& description() const = 0;
    /// Fills request.count() values. Throws Error.
    virtual void read(const Request& request) = 0;
};

/// The argument of NEPHOSCOPE_READER.
struct Reader {
    const char* id;
    const char* version;
    const char* title;       ///< what it reads, for display
    const char* extensions;  ///< usual extensions, separated by spaces; or ""
    /// 0: not this format; 1 to 9: known, but `open` will refuse it and give the reason; 10 to 100:
    /// can be read. An exception counts as 0.
    int (*score)(const char* path);
    std::unique_ptr<File> (*open)(const char* path);
    /// The same with a file that says what the variables are; null if the reader takes none.
    std::unique_ptr<File> (*openWithMap)(const char* path, const char* map) = nullptr;
};

/// Use as Reader::open if the constructor of T takes the path.
template <typename T>
std::unique_ptr<File> openAs(const char* path) {
    return std::make_unique<T>(path);
}

namespace detail {

template <typename T>
NephHeader header() {
    return {NEPH_READER_ABI_VERSION, static_cast<std::uint32_t>(sizeof(T))};
}

/// The description as structs of the ABI, which point into `from`.
class Layout {
  public:
    explicit Layout(const Description& from) {
        for (const Time& t : from.times) {
            times_.push_back({header<NephTime>(),
                              t.label.c_str(),
                              t.seconds,
                              {t.gridOffsetM[0], t.gridOffsetM[1]}});
        }
        for (const Variable& v : from.variables) {
            variables_.push_back({header<NephVariable>(),
                                  v.name.c_str(),
                                  v.standardName.c_str(),
                                  v.units.c_str(),
                                  v.description.c_str(),
                                  v.role,
                                  v.species,
                                  {v.size[0], v.size[1], v.size[2]},
                                  v.reason.c_str()});
        }
        for (const auto& [name, value] : from.attributes) {
            attributes_.push_back({header<NephAttribute>(), name.c_str(), value.c_str()});
        }
        for (const std::string& note : from.notes) notes_.push_back(note.c_str());
        for (const std::string& part : from.parts) parts_.push_back(part.c_str());
        pointTo(times_, timePointers_);
        pointTo(variables_, variablePointers_);
        pointTo(attributes_, attributePointers_);
        fill(from);
    }
    const NephDescription* get() const { return &description_; }

  private:
    template <typename T>
    static void pointTo(const std::vector<T>& structs, std::vector<const T*>& pointers) {
        for (const T& each : structs) pointers.push_back(&each);
    }
    void fill(const Description& from) {
        description_.header = header<NephDescription>();
        description_.model = from.model.c_str();
        description_.scheme = from.scheme.c_str();
        description_.microphysics = from.microphysics;
        description_.cloud_droplets_per_m3 = from.cloudDropletsPerM3;
        for (std::size_t axis = 0; axis < 3; ++axis) description_.size[axis] = from.size[axis];
        for (std::size_t axis = 0; axis < 2; ++axis) {
            description_.spacing_m[axis] = from.spacingM[axis];
            const std::vector<double>& edges = from.edgesM[axis];
            description_.edges_m[axis] = edges.empty() ? nullptr : edges.data();
        }
        description_.domain = from.domain.c_str();
        description_.part_count = static_cast<std::uint32_t>(parts_.size());
        description_.parts = parts_.data();
        description_.projection = from.projection.c_str();
        for (std::size_t axis = 0; axis < 2; ++axis) {
            description_.map_origin_m[axis] = from.mapOriginM[axis];
            description_.map_per_grid[axis] = from.mapPerGrid[axis];
        }
        description_.utc_of_zero = from.utcOfZero.c_str();
        description_.no_place = from.noPlace.c_str();
        description_.rows_together = from.rowsTogether;
        fillNest(from);
        description_.time_count = static_cast<std::uint32_t>(timePointers_.size());
        description_.times = timePointers_.data();
        description_.variable_count = static_cast<std::uint32_t>(variablePointers_.size());
        description_.variables = variablePointers_.data();
        description_.note_count = static_cast<std::uint32_t>(notes_.size());
        description_.notes = notes_.data();
        description_.attribute_count = static_cast<std::uint32_t>(attributePointers_.size());
        description_.attributes = attributePointers_.data();
    }

    void fillNest(const Description& from) {
        description_.domain_number = from.domainNumber;
        description_.parent_number = from.parentNumber;
        for (std::size_t axis = 0; axis < 2; ++axis) {
            description_.parent_corner[axis] = from.parentCorner[axis];
        }
        description_.parent_ratio = from.parentRatio;
    }

    std::vector<NephTime> times_;
    std::vector<NephVariable> variables_;
    std::vector<NephAttribute> attributes_;
    std::vector<const char*> notes_;
    std::vector<const char*> parts_;
    std::vector<const NephTime*> timePointers_;
    std::vector<const NephVariable*> variablePointers_;
    std::vector<const NephAttribute*> attributePointers_;
    NephDescription description_{};
};

template <std::size_t N>
void put(char (&target)[N], const std::string& text) {
    const std::size_t length = text.size() < N ? text.size() : N - 1;
    std::memcpy(target, text.data(), length);
    target[length] = '\0';
}

/// Runs `work` and converts an exception to a status and the texts of an error.
template <typename Work>
NephStatus guarded(NephError* to, Work&& work) {
    Error error;
    try {
        work();
        return NEPH_OK;
    } catch (const Cancelled&) {
        return NEPH_CANCELLED;
    } catch (const Error& thrown) {
        error = thrown;
    } catch (const std::bad_alloc&) {
        error.what = "there is not enough memory for its fields";
    } catch (const std::exception& thrown) {
        error.what = thrown.what();
    } catch (...) {
        error.what = "failed for an unknown reason";
    }
    if (to != nullptr && to->header.struct_size >= sizeof(NephError)) {
        put(to->where, error.where);
        put(to->what, error.what);
        put(to->found, error.found);
        put(to->expected, error.expected);
        put(to->hint, error.hint);
    }
    return NEPH_FAILED;
}

/// Converts a request of the ABI. Throws Error if it does not fit the description.
inline Request checked(const NephReadRequest& raw, const Description& description) {
    if (raw.header.struct_size < sizeof(NephReadRequest) ||
        raw.variable >= description.variables.size() || raw.time >= description.times.size()) {
        throw Error{"there is no such variable or time", {}, {}, {}, {}};
    }
    const Variable& variable = description.variables[raw.variable];
    Request request;
    request.variable = raw.variable;
    request.time = raw.time;
    request.values = raw.values;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (raw.lower[axis] < 0 || raw.upper[axis] <= raw.lower[axis] ||
            raw.upper[axis] > variable.size[axis]) {
            throw Error{"the box asked for lies outside variable " + variable.name, {}, {}, {}, {}};
        }
        request.lower[axis] = static_cast<std::size_t>(raw.lower[axis]);
        request.upper[axis] = static_cast<std::size_t>(raw.upper[axis]);
    }
    if (raw.values == nullptr || raw.value_count != request.count()) {
        throw Error{"the buffer does not fit the box of " + variable.name, {}, {}, {}, {}};
    }
    request.tick = [progress = raw.progress, context = raw.progress_context](double fraction) {
        if (progress != nullptr && progress(context, fraction) == 0) throw Cancelled{};
    };
    return request;
}

}  // namespace detail
}  // namespace neph::plugin

/// The handle of the ABI: an open File and its description as the host sees it.
struct NephFile {
    explicit NephFile(std::unique_ptr<neph::plugin::File> opened)
        : file(std::move(opened)), layout(file->description()) {}
    std::unique_ptr<neph::plugin::File> file;
    neph::plugin::detail::Layout layout;
};

namespace neph::plugin::detail {

/// The calls of the ABI for one Reader; a separate type for each, because C calls carry no state.
template <const Reader& kReader>
struct Calls {
    static std::int32_t score(const char* path) {
        try {
            return kReader.score(path);
        } catch (...) {
            return 0;
        }
    }
    static NephStatus open(const char* path, NephFile** file, NephError* error) {
        return guarded(error,
                       [&] { *file = std::make_unique<NephFile>(kReader.open(path)).release(); });
    }
    static NephStatus openWithMap(const char* path, const char* map, NephFile** file,
                                  NephError* error) {
        return guarded(error, [&] {
            *file = std::make_unique<NephFile>(kReader.openWithMap(path, map)).release();
        });
    }
    static const NephDescription* describe(NephFile* file) { return file->layout.get(); }
    static NephStatus read(NephFile* file, NephReadRequest* request, NephError* error) {
        return guarded(error, [&] {
            request->values_written = 0;
            file->file->read(checked(*request, file->file->description()));
            request->values_written = request->value_count;
        });
    }
    static void close(NephFile* file) { delete file; }

    static const NephReader* table(std::uint32_t hostAbiVersion) {
        static const NephReader reader{header<NephReader>(),
                                       kReader.id,
                                       kReader.version,
                                       kReader.title,
                                       kReader.extensions,
                                       &score,
                                       &open,
                                       &describe,
                                       &read,
                                       &close,
                                       kReader.openWithMap == nullptr ? nullptr : &openWithMap};
        return hostAbiVersion >= NEPH_READER_ABI_VERSION ? &reader : nullptr;
    }
};

}  // namespace neph::plugin::detail

/// Exports `reader`, a constant of type neph::plugin::Reader with static storage. Use it once per
/// library.
#define NEPHOSCOPE_READER(reader)                                                           \
    extern "C" NEPH_READER_EXPORT const NephReader* nephReader(uint32_t host_abi_version) { \
        return neph::plugin::detail::Calls<reader>::table(host_abi_version);                \
    }
