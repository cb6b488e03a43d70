// classic_layout.cpp: parses the header of a classic NetCDF file.
#include "readers/netcdf/classic_layout.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>

namespace nc {
namespace {

constexpr std::uint64_t kFloat = 5;          // NC_FLOAT
constexpr std::uint64_t kMinEntryBytes = 4;  // of the smallest entry that a list can have
// NC_MAX_NAME and NC_MAX_VAR_DIMS: the library would write anything longer past the caller's array.
constexpr std::uint64_t kMaxName = 256, kMaxRank = 1024;

/// Bytes of one value of an external type; 0 for a type that does not exist.
std::uint64_t bytesOf(std::uint64_t type) {
    constexpr std::array<std::uint64_t, 12> kBytes{0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
    return type < kBytes.size() ? kBytes[type] : 0;
}

/// Names, attributes and record variables are padded to multiples of four bytes.
std::uint64_t padded(std::uint64_t bytes) {
    return (bytes + 3) / 4 * 4;
}

}  // namespace

/// Parser of big-endian numbers. After the first that is missing or impossible, `broken_` is set
/// and everything reads as zero.
class ClassicHeader {
  public:
    explicit ClassicHeader(const std::string& path) : in_(path, std::ios::binary | std::ios::ate) {
        left_ = in_ ? static_cast<std::uint64_t>(in_.tellg()) : 0;
        in_.seekg(0);
    }

    std::optional<ClassicLayout> read() {
        std::array<char, 4> magic{};
        in_.read(magic.data(), magic.size());
        left_ -= std::min<std::uint64_t>(left_, magic.size());
        version_ = static_cast<unsigned char>(magic[3]);
        if (!in_ || std::string_view(magic.data(), 3) != "CDF") return {};
        if (version_ != 1 && version_ != 2 && version_ != 5) return {};
        ClassicLayout layout;
        layout.records_ = count();
        readDimensions();
        skipAttributes();
        readVariables(layout);
        if (broken_) return {};
        return layout;
    }

  private:
    /// Advances within the file; sets `broken_` if fewer bytes are left.
    void consume(std::uint64_t bytes) {
        if (bytes > left_) broken_ = true;
        if (!broken_) left_ -= bytes;
    }
    std::uint64_t number(int bytes) {
        std::array<unsigned char, 8> raw{};
        in_.read(reinterpret_cast<char*>(raw.data()), bytes);
        consume(static_cast<std::uint64_t>(bytes));
        if (!in_) broken_ = true;
        std::uint64_t value = 0;
        for (int i = 0; i < bytes; ++i) value = value << 8U | raw[static_cast<std::size_t>(i)];
        return broken_ ? 0 : value;
    }
    std::uint64_t word() { return number(4); }
    /// CDF-5 has 8-byte counts and lengths.
    std::uint64_t count() { return number(version_ == 5 ? 8 : 4); }
    /// Number of entries of a list; more than the rest of the file can hold is an error.
    std::uint64_t listLength() {
        const std::uint64_t n = count();
        if (n > left_ / kMinEntryBytes) broken_ = true;
        return broken_ ? 0 : n;
    }
    void skip(std::uint64_t bytes) {
        consume(bytes);
        if (!broken_) in_.seekg(static_cast<std::streamoff>(bytes), std::ios::cur);
    }
    void skipName() {
        const std::uint64_t length = count();
        if (length == 0 || length > kMaxName) broken_ = true;
        skip(padded(length));
    }

    /// Each list begins with a tag, which is redundant here.
    void readDimensions() {
        word();
        const std::uint64_t n = listLength();
        for (std::uint64_t i = 0; i < n && !broken_; ++i) {
            skipName();
            lengths_.push_back(count());
        }
    }
    void skipAttributes() {
        word();
        const std::uint64_t n = listLength();
        for (std::uint64_t i = 0; i < n && !broken_; ++i) {
            skipName();
            const std::uint64_t bytes = bytesOf(word());
            const std::uint64_t values = count();
            if (bytes == 0 || values > left_) broken_ = true;
            skip(padded(bytes * values));
        }
    }
    void readVariables(ClassicLayout& layout) {
        word();
        const std::uint64_t n = listLength();
        for (std::uint64_t i = 0; i < n && !broken_; ++i) readVariable(layout);
        std::uint64_t records = 0;
        for (const auto& variable : layout.variables_) {
            if (!variable.record) continue;
            ++records;
            layout.recordBytes_ += padded(variable.bytes);
        }
        // A lone record variable is stored without padding.
        if (records == 1) {
            for (const auto& variable : layout.variables_) {
                if (variable.record) layout.recordBytes_ = variable.bytes;
            }
        }
    }
    void readVariable(ClassicLayout& layout) {
        skipName();
        ClassicLayout::Variable variable;
        std::uint64_t cells = 1;
        const std::uint64_t rank = listLength();
        if (rank > kMaxRank) broken_ = true;
        for (std::uint64_t axis = 0; axis < rank && !broken_; ++axis) {
            const std::uint64_t dimension = count();
            if (dimension >= lengths_.size()) broken_ = true;
            const std::uint64_t length = broken_ ? 1 : lengths_[dimension];
            if (length == 0 && axis == 0) {  // the unlimited dimension
                variable.record = true;
            } else {
                cells *= length;
            }
            if (cells > std::uint64_t{1} << 48U) broken_ = true;
        }
        skipAttributes();
        const std::uint64_t type = word();
        if (bytesOf(type) == 0) broken_ = true;
        variable.floats = type == kFloat;
        variable.bytes = cells * bytesOf(type);
        count();  // vsize: redundant, and wrong for variables above 4 GiB
        variable.begin = number(version_ == 1 ? 4 : 8);
        layout.variables_.push_back(variable);
    }

    std::ifstream in_;
    std::uint64_t left_ = 0;  ///< bytes of the file that have not been parsed yet
    int version_ = 0;
    bool broken_ = false;
    std::vector<std::uint64_t> lengths_;
};

std::optional<ClassicLayout> ClassicLayout::of(const std::string& path) {
    return ClassicHeader(path).read();
}

std::uint64_t ClassicLayout::beginOf(const Variable& variable, std::uint64_t record) const {
    return variable.begin + (variable.record ? record * recordBytes_ : 0);
}

std::uint64_t ClassicLayout::bytesNeeded(std::size_t index, std::uint64_t record) const {
    const Variable& variable = variables_.at(index);
    return beginOf(variable, record) + variable.bytes;
}

std::optional<std::uint64_t> ClassicLayout::floatsAt(std::size_t index,
                                                     std::uint64_t record) const {
    const Variable& variable = variables_.at(index);
    if (!variable.floats) return {};
    return beginOf(variable, record);
}

std::uint64_t ClassicLayout::bytesOfAll() const {
    std::uint64_t bytes = 0;
    for (std::size_t i = 0; i < variables_.size(); ++i) {
        if (variables_[i].record && records_ == 0) continue;
        bytes = std::max(bytes, bytesNeeded(i, records_ > 0 ? records_ - 1 : 0));
    }
    return bytes;
}

}  // namespace nc
