// nc_file.cpp: calls of NetCDF-C, and the translation of their failures into errors for users.
#include "readers/wrf_netcdf/nc_file.h"

#include <fmt/format.h>
#include <hdf5.h>
#include <netcdf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <mutex>
#include <string_view>

namespace wrf {
namespace {

/// Lock that is held during every call of the library.
class LibraryLock {
  public:
    LibraryLock() : lock_(mutex()) {
        // HDF5 prints every failed look-up until it is switched off, in each thread separately;
        // NetCDF does so only in the first thread.
        H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    }

  private:
    static std::mutex& mutex() {
        static std::mutex mutex;
        return mutex;
    }
    std::scoped_lock<std::mutex> lock_;
};

void require(int status, const std::string& doing) {
    if (status == NC_NOERR) return;
    throw Failure{fmt::format("{}: {}", doing, nc_strerror(status)), {}, {}, {}};
}

/// A text attribute without surrounding blanks; nothing if absent or not text.
std::optional<std::string> textAttribute(int file, int variable, const char* name) {
    nc_type type = 0;
    std::size_t length = 0;
    if (nc_inq_att(file, variable, name, &type, &length) != NC_NOERR) return {};
    if (type != NC_CHAR || length > 65536) return {};
    std::string text(length, '\0');
    if (nc_get_att_text(file, variable, name, text.data()) != NC_NOERR) return {};
    while (!text.empty() && (text.back() == '\0' || text.back() == ' ')) text.pop_back();
    text.erase(0, std::min(text.find_first_not_of(' '), text.size()));
    return text;
}

/// An attribute that is a single number; nothing if absent or of another kind.
std::optional<double> numberAttribute(int file, int variable, const char* name) {
    nc_type type = 0;
    std::size_t length = 0;
    if (nc_inq_att(file, variable, name, &type, &length) != NC_NOERR) return {};
    if (type == NC_CHAR || type == NC_STRING || length != 1) return {};
    double value = 0.0;
    if (nc_get_att_double(file, variable, name, &value) != NC_NOERR) return {};
    return value;
}

std::uint64_t bytesOnDisk(const std::string& path) {
    std::error_code code;
    const auto bytes = std::filesystem::file_size(path, code);
    return code ? 0 : bytes;
}

/// Replaces missing values by NaN and packed values by their physical ones.
void unpack(const NcVariable& variable, std::span<float> values) {
    // The library fills cells that were never written with NC_FILL_FLOAT, 9.97e36.
    constexpr float kNothingWritten = 9.9e36f;
    const bool packed = variable.scale != 1.0f || variable.offset != 0.0f;
    const float fill = variable.fill.value_or(std::numeric_limits<float>::quiet_NaN());
    for (float& value : values) {
        const bool missing = value == fill || std::abs(value) >= kNothingWritten;
        value = missing ? std::numeric_limits<float>::quiet_NaN() : value;
    }
    if (!packed) return;
    for (float& value : values) value = value * variable.scale + variable.offset;
}

}  // namespace

Container containerOf(const std::string& path) {
    std::array<char, 8> magic{};
    std::ifstream(path, std::ios::binary).read(magic.data(), magic.size());
    const std::string_view text(magic.data(), magic.size());
    if (text == "\x89HDF\r\n\x1a\n") return Container::hdf5;
    const bool known = magic[3] == 1 || magic[3] == 2 || magic[3] == 5;
    return text.substr(0, 3) == "CDF" && known ? Container::classic : Container::unknown;
}

NcFile::NcFile(const std::string& path) : path_(path), floats_(path) {
    const auto failure = [&](const std::string& reason) {
        return Failure{"is a NetCDF file that cannot be opened",
                       fmt::format("{} bytes; {}", bytesOnDisk(path), reason),
                       "a whole NetCDF file",
                       "it was probably cut short while it was written or copied: copy it again"};
    };
    if (containerOf(path) == Container::classic) {
        layout_ = ClassicLayout::of(path);
        if (!layout_) throw failure("its header is damaged");
    }
    const LibraryLock lock;
    const int status = nc_open(path.c_str(), NC_NOWRITE, &id_);
    if (status != NC_NOERR) {
        throw failure(fmt::format("NetCDF reports \"{}\"", nc_strerror(status)));
    }
    try {
        readVariables();
    } catch (...) {
        nc_close(id_);
        throw;
    }
}

NcFile::~NcFile() {
    const LibraryLock lock;
    nc_close(id_);
}

/// Dimensions, and names, types and attributes of all variables; no values.
void NcFile::readVariables() {
    int dimensionCount = 0;
    int variableCount = 0;
    require(nc_inq(id_, &dimensionCount, &variableCount, nullptr, nullptr), "header");
    std::array<char, NC_MAX_NAME + 1> name{};
    for (int id = 0; id < dimensionCount; ++id) {
        std::size_t length = 0;
        require(nc_inq_dim(id_, id, name.data(), &length), "dimensions");
        dimensions_.push_back({name.data(), length});
    }
    for (int id = 0; id < variableCount; ++id) {
        NcVariable variable;
        nc_type type = 0;
        int rank = 0;
        std::array<int, NC_MAX_VAR_DIMS> axes{};
        require(nc_inq_var(id_, id, name.data(), &type, &rank, axes.data(), nullptr), "variables");
        variable.id = id;
        variable.name = name.data();
        variable.text = type == NC_CHAR;
        variable.units = textAttribute(id_, id, "units").value_or("");
        variable.description = textAttribute(id_, id, "description").value_or("");
        const auto scale = numberAttribute(id_, id, "scale_factor");
        const auto offset = numberAttribute(id_, id, "add_offset");
        const auto fill = numberAttribute(id_, id, "_FillValue");
        variable.scale = static_cast<float>(scale.value_or(1.0));
        variable.offset = static_cast<float>(offset.value_or(0.0));
        if (fill) variable.fill = static_cast<float>(*fill);
        variable.number = type == NC_FLOAT || type == NC_DOUBLE || (type == NC_SHORT && scale);
        for (int axis = 0; axis < rank; ++axis) {
            const auto dimension = static_cast<std::size_t>(axes[static_cast<std::size_t>(axis)]);
            if (dimension < dimensions_.size()) variable.axes.push_back(dimensions_[dimension]);
        }
        int storage = NC_CONTIGUOUS;
        std::vector<std::size_t> chunk(static_cast<std::size_t>(rank));
        if (rank > 0 && nc_inq_var_chunking(id_, id, &storage, chunk.data()) == NC_NOERR &&
            storage == NC_CHUNKED) {
            variable.chunk = chunk;
        }
        variables_.push_back(std::move(variable));
    }
}

const NcDimension* NcFile::dimension(std::string_view name) const {
    const auto found = std::ranges::find(dimensions_, name, &NcDimension::name);
    return found == dimensions_.end() ? nullptr : &*found;
}

const NcVariable* NcFile::variable(std::string_view name) const {
    const auto found = std::ranges::find(variables_, name, &NcVariable::name);
    return found == variables_.end() ? nullptr : &*found;
}

std::optional<std::string> NcFile::text(const char* name) const {
    const LibraryLock lock;
    return textAttribute(id_, NC_GLOBAL, name);
}

std::optional<double> NcFile::number(const char* name) const {
    const LibraryLock lock;
    return numberAttribute(id_, NC_GLOBAL, name);
}

std::optional<NcFile::Shortage> NcFile::shortage() const {
    if (!layout_) return {};
    const Shortage result{layout_->bytesOfAll(), bytesOnDisk(path_)};
    if (result.found >= result.expected) return {};
    return result;
}

/// Throws Failure if the file ends before the end of `variable` at its record `lastRecord`, where
/// the library would return zeros.
void NcFile::requireWhole(const NcVariable& variable, std::size_t lastRecord) const {
    if (!layout_) return;
    const std::uint64_t expected =
        layout_->bytesNeeded(static_cast<std::size_t>(variable.id), lastRecord);
    const std::uint64_t found = bytesOnDisk(path_);
    if (found >= expected) return;
    throw Failure{fmt::format("the file ends before the end of variable {}", variable.name),
                  fmt::format("{} bytes", found), fmt::format("at least {} bytes", expected),
                  "it was probably cut short while it was written or copied: copy it again"};
}

void NcFile::read(const NcVariable& variable, std::span<const std::size_t> start,
                  std::span<const std::size_t> count, std::span<float> values) const {
    if (!readClassic(variable, start, count, values)) {
        readWithLibrary(variable, start, count, values);
    }
    unpack(variable, values);
}

/// False if the library has to read: other containers, other types, several records at once, and
/// data beyond the end of the file, for which readWithLibrary() gives the error.
bool NcFile::readClassic(const NcVariable& variable, std::span<const std::size_t> start,
                         std::span<const std::size_t> count, std::span<float> values) const {
    const auto index = static_cast<std::size_t>(variable.id);
    if (!layout_ || !floats_.usable() || start.empty()) return false;
    const std::size_t first = layout_->hasRecords(index) ? 1 : 0;
    if (first == 1 && count[0] != 1) return false;
    const auto begin = layout_->floatsAt(index, first == 1 ? start[0] : 0);
    if (!begin) return false;
    std::vector<std::size_t> shape;
    for (std::size_t axis = first; axis < variable.axes.size(); ++axis) {
        shape.push_back(variable.axes[axis].length);
    }
    return floats_.read(*begin, shape, start.subspan(first), count.subspan(first), values);
}

void NcFile::readWithLibrary(const NcVariable& variable, std::span<const std::size_t> start,
                             std::span<const std::size_t> count, std::span<float> values) const {
    const LibraryLock lock;
    requireWhole(variable, start.empty() ? 0 : start[0] + count[0] - 1);
    if (!variable.chunk.empty() && cacheEnlarged_.insert(variable.id).second)
        enlargeChunkCache(variable);
    const int status =
        nc_get_vara_float(id_, variable.id, start.data(), count.data(), values.data());
    // NC_ERANGE: doubles beyond float become infinities, which unpack() treats as missing.
    if (status != NC_NOERR && status != NC_ERANGE) {
        throw Failure{
            fmt::format("variable {} cannot be read: {}", variable.name, nc_strerror(status)),
            {},
            {},
            "the file is damaged: copy it again, or leave this time out"};
    }
}

/// Makes the chunk cache hold one row of chunks: all that a band of rows over the full width and
/// depth touches, so that the next band does not decompress them again. Reading whole fields needs
/// no more.
void NcFile::enlargeChunkCache(const NcVariable& variable) const {
    constexpr std::size_t kMaxCacheBytes = 128U << 20U;  // per variable
    constexpr std::size_t kSlots = 1009;                 // prime, well above the chunks of a row
    constexpr float kPreferRead = 0.75f;                 // the library's default
    const std::size_t rank = variable.axes.size();
    std::size_t bytes = sizeof(float);
    for (std::size_t axis = 0; axis < rank; ++axis) {
        const std::size_t chunk = variable.chunk[axis];
        const bool crossed = axis + 1 == rank || (rank >= 3 && axis == rank - 3);  // x and z
        bytes *= crossed ? (variable.axes[axis].length + chunk - 1) / chunk * chunk : chunk;
    }
    nc_set_var_chunk_cache(id_, variable.id, std::min(bytes, kMaxCacheBytes), kSlots, kPreferRead);
}

std::string NcFile::readText(const NcVariable& variable, std::span<const std::size_t> start,
                             std::span<const std::size_t> count) const {
    const LibraryLock lock;
    std::size_t size = 1;
    for (std::size_t length : count) size *= length;
    requireWhole(variable, start.empty() ? 0 : start[0] + count[0] - 1);
    std::string text(size, '\0');
    require(nc_get_vara_text(id_, variable.id, start.data(), count.data(), text.data()),
            variable.name);
    return text;
}

}  // namespace wrf
