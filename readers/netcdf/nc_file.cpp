// nc_file.cpp: calls of NetCDF-C, and the translation of their failures into errors for users.
#include "readers/netcdf/nc_file.h"

#include <fmt/format.h>
#include <hdf5.h>
#include <netcdf.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <string_view>

#include "readers/netcdf/nc_attributes.h"
#include "readers/netcdf/nc_filters.h"
#include "readers/shared/writing.h"

namespace nc {
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

std::uint64_t bytesOnDisk(const std::string& path) {
    std::error_code code;
    const auto bytes = std::filesystem::file_size(path, code);
    return code ? 0 : bytes;
}

/// Whether names are equal but for case.
bool sameLetters(std::string_view a, std::string_view b) {
    const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
    return std::ranges::equal(a, b, {}, lower, lower);
}

/// The next step for the owner of a file that ends too early.
std::string hintOfShort(const std::string& path) {
    if (const auto why = shared::beingWritten(path)) {
        return fmt::format("it is being written ({}): open it again when that has ended", *why);
    }
    return "it was probably cut short while it was written or copied: copy it again";
}

}  // namespace

std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text.empty() ? "none" : text;
}

std::string listOf(const std::vector<NcDimension>& dimensions) {
    std::vector<std::string> texts;
    texts.reserve(dimensions.size());
    for (const NcDimension& d : dimensions) {
        texts.push_back(fmt::format("{} = {}", d.name, d.length));
    }
    return joined(texts);
}

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
                       "a whole NetCDF file", hintOfShort(path)};
    };
    const Container container = containerOf(path);
    if (container == Container::unknown) {
        throw Failure{"is no NetCDF file",
                      fmt::format("{} bytes", bytesOnDisk(path)),
                      "CDF and a version, or the signature of HDF5, at its beginning",
                      {}};
    }
    if (container == Container::classic) {
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
    deflated_.clear();
    if (hdf5_ && *hdf5_ >= 0) H5Fclose(*hdf5_);
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
    for (int id = 0; id < variableCount; ++id) variables_.push_back(describe(id));
}

NcVariable NcFile::describe(int id) const {
    NcVariable variable;
    std::array<char, NC_MAX_NAME + 1> name{};
    std::array<int, NC_MAX_VAR_DIMS> axes{};
    nc_type type = 0;
    int rank = 0;
    require(nc_inq_var(id_, id, name.data(), &type, &rank, axes.data(), nullptr), "variables");
    variable.id = id;
    variable.name = name.data();
    variable.text = type == NC_CHAR;
    variable.strings = type == NC_STRING;
    variable.floats = type == NC_FLOAT;
    variable.number = type >= NC_BYTE && type <= NC_UINT64 && type != NC_CHAR;
    variable.integer = variable.number && type != NC_FLOAT && type != NC_DOUBLE;
    variable.standardName = textAttribute(id_, id, "standard_name").value_or("");
    variable.units = textAttribute(id_, id, "units").value_or("");
    variable.calendar = textAttribute(id_, id, "calendar").value_or("");
    variable.description = textAttribute(id_, id, "description").value_or("");
    if (variable.description.empty()) {
        variable.description = textAttribute(id_, id, "long_name").value_or("");
    }
    variable.packing = NcPacking(id_, id, type);
    for (int axis = 0; axis < rank; ++axis) {
        const auto dimension = static_cast<std::size_t>(axes[static_cast<std::size_t>(axis)]);
        if (dimension < dimensions_.size()) variable.axes.push_back(dimensions_[dimension]);
    }
    int storage = NC_CONTIGUOUS;
    std::vector<std::size_t> chunk(static_cast<std::size_t>(rank));
    if (rank > 0 && nc_inq_var_chunking(id_, id, &storage, chunk.data()) == NC_NOERR &&
        storage == NC_CHUNKED) {
        variable.chunk = chunk;
        variable.deflated = variable.floats && onlyDeflated(id_, id);
    }
    return variable;
}

const NcDimension* NcFile::dimension(std::string_view name) const {
    const auto found = std::ranges::find(dimensions_, name, &NcDimension::name);
    return found == dimensions_.end() ? nullptr : &*found;
}

const NcVariable* NcFile::variable(std::string_view name) const {
    auto found = std::ranges::find(variables_, name, &NcVariable::name);
    if (found == variables_.end()) {
        const auto same = [&](const NcVariable& each) { return sameLetters(each.name, name); };
        found = std::ranges::find_if(variables_, same);
    }
    return found == variables_.end() ? nullptr : &*found;
}

const NcVariable* NcFile::variableOfStandardName(std::string_view standardName) const {
    const auto found = std::ranges::find(variables_, standardName, &NcVariable::standardName);
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

std::optional<std::string> NcFile::text(const NcVariable& variable, const char* name) const {
    const LibraryLock lock;
    return textAttribute(id_, variable.id, name);
}

std::vector<double> NcFile::numbers(const NcVariable& variable, const char* name) const {
    const LibraryLock lock;
    return numbersAttribute(id_, variable.id, name);
}

std::optional<NcFile::Shortage> NcFile::shortage() const {
    if (!layout_) return {};
    const Shortage result{layout_->bytesOfAll(), bytesOnDisk(path_)};
    if (result.found >= result.expected) return {};
    return result;
}

bool NcFile::holds(const NcVariable& variable, std::size_t record) const {
    return !layout_ || layout_->bytesNeeded(static_cast<std::size_t>(variable.id), record) <=
                           bytesOnDisk(path_);
}

/// Throws Failure if the file ends before the end of `variable` at its record `lastRecord`, where
/// the library would return zeros.
void NcFile::requireWhole(const NcVariable& variable, std::size_t lastRecord) const {
    if (holds(variable, lastRecord)) return;
    const std::uint64_t expected =
        layout_->bytesNeeded(static_cast<std::size_t>(variable.id), lastRecord);
    const std::uint64_t found = bytesOnDisk(path_);
    throw Failure{fmt::format("the file ends before the end of variable {}", variable.name),
                  fmt::format("{} bytes", found), fmt::format("at least {} bytes", expected),
                  hintOfShort(path_)};
}

void NcFile::read(const NcVariable& variable, std::span<const std::size_t> start,
                  std::span<const std::size_t> count, std::span<float> values) const {
    if (!variable.floats) {
        variable.packing.unpack(readDoubles(variable, start, count), values);
        return;
    }
    if (!readClassic(variable, start, count, values) &&
        !readDeflated(variable, start, count, values)) {
        readWithLibrary(variable, start, count, values);
    }
    variable.packing.unpack(values);
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

/// False if the library has to read or to name the error: anything but sound chunks of floats that
/// were compressed with deflate.
bool NcFile::readDeflated(const NcVariable& variable, std::span<const std::size_t> start,
                          std::span<const std::size_t> count, std::span<float> values) const {
    if (!variable.deflated) return false;
    DeflatedFloats* floats = nullptr;
    std::optional<std::vector<DeflatedFloats::Stored>> chunks;
    {
        const LibraryLock lock;
        floats = deflated(variable);
        if (floats != nullptr) chunks = floats->fetch(start, count);
    }
    if (!chunks || !floats->inflate(*chunks)) return false;
    floats->copy(start, count, values);
    return true;
}

/// How the chunks of a variable are read without the filters of HDF5; null if they cannot be.
DeflatedFloats* NcFile::deflated(const NcVariable& variable) const {
    const auto known = deflated_.find(variable.id);
    if (known != deflated_.end()) return known->second.get();
    if (!hdf5_) {
        hdf5_ = DeflatedFloats::fileOf(path_);
    }
    std::vector<std::size_t> shape;
    for (const NcDimension& axis : variable.axes) shape.push_back(axis.length);
    auto floats =
        *hdf5_ < 0 ? nullptr : DeflatedFloats::of(*hdf5_, variable.name, shape, variable.chunk);
    return deflated_.emplace(variable.id, std::move(floats)).first->second.get();
}

void NcFile::readWithLibrary(const NcVariable& variable, std::span<const std::size_t> start,
                             std::span<const std::size_t> count, std::span<float> values) const {
    const LibraryLock lock;
    requireWhole(variable, start.empty() ? 0 : start[0] + count[0] - 1);
    if (!variable.chunk.empty() && cacheEnlarged_.insert(variable.id).second)
        enlargeChunkCache(variable);
    requireRead(nc_get_vara_float(id_, variable.id, start.data(), count.data(), values.data()),
                variable);
}

std::vector<double> NcFile::readDoubles(const NcVariable& variable,
                                        std::span<const std::size_t> start,
                                        std::span<const std::size_t> count) const {
    const LibraryLock lock;
    requireWhole(variable, start.empty() ? 0 : start[0] + count[0] - 1);
    if (!variable.chunk.empty() && cacheEnlarged_.insert(variable.id).second)
        enlargeChunkCache(variable);
    std::size_t size = 1;
    for (const std::size_t length : count) size *= length;
    std::vector<double> values(size);
    requireRead(nc_get_vara_double(id_, variable.id, start.data(), count.data(), values.data()),
                variable);
    return values;
}

/// Throws Failure if values could not be read. NC_ERANGE: doubles beyond float become infinities,
/// which NcPacking treats as missing.
void NcFile::requireRead(int status, const NcVariable& variable) const {
    if (status == NC_NOERR || status == NC_ERANGE) return;
    if (const auto filter = missingFilter(id_, variable.id)) {
        throw Failure{fmt::format("variable {} is compressed with a filter that this machine's "
                                  "HDF5 lacks",
                                  variable.name),
                      *filter, "none, or deflate (zlib)", filterHint()};
    }
    throw Failure{fmt::format("variable {} cannot be read: {}", variable.name, nc_strerror(status)),
                  {},
                  {},
                  "the file is damaged: copy it again, or leave this time out"};
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

std::vector<std::string> NcFile::readStrings(const NcVariable& variable) const {
    const LibraryLock lock;
    std::vector<char*> texts(variable.axes.empty() ? 1 : variable.axes.front().length);
    require(nc_get_var_string(id_, variable.id, texts.data()), variable.name);
    std::vector<std::string> copies;
    for (const char* text : texts) copies.emplace_back(text == nullptr ? "" : text);
    nc_free_string(texts.size(), texts.data());
    return copies;
}

}  // namespace nc
