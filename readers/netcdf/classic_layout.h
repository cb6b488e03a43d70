// classic_layout.h: where a NetCDF-3 file keeps its data, so that a truncated file is noticed and
// floats can be read without the library, which serves only one thread at a time.
//
// The NetCDF library returns zeros for data beyond the end of a classic file. A storm without rain
// would look the same, so the header is also parsed here, for the offsets that the library does not
// give. This happens first, because the library trusts the sizes in the header. Format: NetCDF
// User's Guide, appendix B.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace nc {

/// Offsets and sizes of the variables of one file. `index` is the id of a variable in the library.
class ClassicLayout {
  public:
    /// Parses the header of a CDF-1, CDF-2 or CDF-5 file; nothing if the file is of another kind or
    /// its header is damaged.
    static std::optional<ClassicLayout> of(const std::string& path);

    /// Least size of the file for variable `index` to be complete at `record`, which is 0 for
    /// variables without records.
    std::uint64_t bytesNeeded(std::size_t index, std::uint64_t record) const;

    /// Byte at which variable `index` begins at `record`; nothing if it does not hold floats.
    std::optional<std::uint64_t> floatsAt(std::size_t index, std::uint64_t record) const;
    bool hasRecords(std::size_t index) const { return variables_.at(index).record; }

    /// Least size of the file for all variables to be complete at all records.
    std::uint64_t bytesOfAll() const;

  private:
    struct Variable {
        std::uint64_t begin = 0;
        std::uint64_t bytes = 0;  ///< of one record, or of all values if there are no records
        bool record = false;
        bool floats = false;
    };

    std::uint64_t beginOf(const Variable& variable, std::uint64_t record) const;

    friend class ClassicHeader;
    std::vector<Variable> variables_;
    std::uint64_t recordBytes_ = 0;
    std::uint64_t records_ = 0;
};

}  // namespace nc
