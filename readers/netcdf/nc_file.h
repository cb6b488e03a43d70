// nc_file.h: one NetCDF file, opened for reading. All calls of the library are made here.
//
// NetCDF-C is not thread-safe, so each method holds one lock for the whole process. The exceptions
// are floats of classic files, which are read without the library, and inflating chunks of floats.
// Sizes and starts are in file order, slowest axis first.
#pragma once
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "readers/netcdf/classic_floats.h"
#include "readers/netcdf/classic_layout.h"
#include "readers/netcdf/deflated_floats.h"
#include "readers/netcdf/failure.h"
#include "readers/netcdf/nc_packing.h"

namespace nc {

struct NcDimension {
    std::string name;
    std::size_t length = 0;
};

struct NcVariable {
    int id = -1;
    std::string name, standardName, units, description, calendar;
    bool number = false;   ///< stored as floats, doubles or integers
    bool integer = false;  ///< of these, as integers
    bool floats = false;   ///< of these, as floats
    bool text = false;     ///< stored as characters
    bool strings = false;  ///< stored as strings
    bool deflated =
        false;  ///< as floats, in chunks that deflate has compressed, and no other filter
    std::vector<NcDimension> axes;
    std::vector<std::size_t> chunk;  ///< cells per axis; empty if not chunked
    NcPacking packing;
};

/// Container format of a file, by its first bytes.
enum class Container { unknown, classic, hdf5 };
Container containerOf(const std::string& path);

/// "Time = 1, bottom_top = 60, …" for messages.
std::string listOf(const std::vector<NcDimension>& dimensions);

/// Names separated by commas; "none" if there are none.
std::string joined(const std::vector<std::string>& names);

class NcFile {
  public:
    /// Throws Failure, with a hint, if the library cannot open the file.
    explicit NcFile(const std::string& path);
    ~NcFile();
    NcFile(const NcFile&) = delete;
    NcFile& operator=(const NcFile&) = delete;

    const std::vector<NcDimension>& dimensions() const { return dimensions_; }
    const std::vector<NcVariable>& variables() const { return variables_; }
    /// Null for an unknown name.
    const NcDimension* dimension(std::string_view name) const;
    /// Case matters only where the file has several variables that differ in nothing else.
    const NcVariable* variable(std::string_view name) const;
    /// The first variable with a CF standard name; null if there is none.
    const NcVariable* variableOfStandardName(std::string_view standardName) const;
    const std::string& path() const { return path_; }

    /// Global attributes; nothing if absent or of another type.
    std::optional<std::string> text(const char* name) const;
    std::optional<double> number(const char* name) const;

    /// The same of a variable; numbers: all of a list, none if absent.
    std::optional<std::string> text(const NcVariable& variable, const char* name) const;
    std::vector<double> numbers(const NcVariable& variable, const char* name) const;

    /// Fills `values` with a box. Missing values become NaN; packed values are unpacked. Throws
    /// Failure.
    void read(const NcVariable& variable, std::span<const std::size_t> start,
              std::span<const std::size_t> count, std::span<float> values) const;
    /// The same for times and coordinates, in doubles.
    std::vector<double> readDoubles(const NcVariable& variable, std::span<const std::size_t> start,
                                    std::span<const std::size_t> count) const;
    /// All entries of a variable of strings with one axis.
    std::vector<std::string> readStrings(const NcVariable& variable) const;
    /// Reads characters; the rules are those of read().
    std::string readText(const NcVariable& variable, std::span<const std::size_t> start,
                         std::span<const std::size_t> count) const;

    /// Expected and actual size of a truncated file; nothing for a complete one. Only classic files
    /// can be truncated and still open.
    struct Shortage {
        std::uint64_t expected = 0, found = 0;
    };
    std::optional<Shortage> shortage() const;
    /// Whether the file is long enough for a variable at a record.
    bool holds(const NcVariable& variable, std::size_t record) const;

  private:
    void readVariables();
    void requireWhole(const NcVariable& variable, std::size_t lastRecord) const;
    bool readClassic(const NcVariable& variable, std::span<const std::size_t> start,
                     std::span<const std::size_t> count, std::span<float> values) const;
    bool readDeflated(const NcVariable& variable, std::span<const std::size_t> start,
                      std::span<const std::size_t> count, std::span<float> values) const;
    DeflatedFloats* deflated(const NcVariable& variable) const;
    void enlargeChunkCache(const NcVariable& variable) const;
    void readWithLibrary(const NcVariable& variable, std::span<const std::size_t> start,
                         std::span<const std::size_t> count, std::span<float> values) const;
    NcVariable describe(int id) const;
    void requireRead(int status, const NcVariable& variable) const;

    std::string path_;
    int id_ = -1;
    std::optional<ClassicLayout> layout_;
    ClassicFloats floats_;
    mutable std::optional<hid_t> hdf5_;  ///< the same file, opened with HDF5; negative: failed
    /// By the id of a variable; null where the library has to read.
    mutable std::map<int, std::unique_ptr<DeflatedFloats>> deflated_;
    mutable std::set<int> cacheEnlarged_;  ///< ids of variables whose chunk cache was enlarged
    std::vector<NcDimension> dimensions_;
    std::vector<NcVariable> variables_;
};

}  // namespace nc
