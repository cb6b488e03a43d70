// classic_layout.h: where a NetCDF-3 file keeps its data, so that a truncated one is noticed and
// floats can be read past the library, which serves one thread at a time.
//
// The NetCDF library fills with zeros what lies past the end of a classic file. A storm without
// rain would look the same, so the header is read here as well, for the offsets that the library
// does not give, and first, because the library trusts the sizes that it finds there. Layout:
// NetCDF user guide, appendix B.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace wrf {

class ClassicLayout {
  public:
    /// Reads the header of a CDF-1, CDF-2 or CDF-5 file; nothing when the file is not of that kind
    /// or the header is broken.
    static std::optional<ClassicLayout> of(const std::string& path);

    /// Bytes that the file must have for variable `index` to be whole at `record` (0 for variables
    /// without records).
    std::uint64_t bytesNeeded(std::size_t index, std::uint64_t record) const;

    /// Where variable `index` begins at `record`, when it holds floats.
    std::optional<std::uint64_t> floatsAt(std::size_t index, std::uint64_t record) const;
    bool hasRecords(std::size_t index) const { return variables_.at(index).record; }

    /// Bytes that the whole file must have.
    std::uint64_t bytesOfAll() const;

  private:
    struct Variable {
        std::uint64_t begin = 0;
        std::uint64_t bytes = 0;  ///< of one record, or of everything without records
        bool record = false;
        bool floats = false;
    };

    std::uint64_t beginOf(const Variable& variable, std::uint64_t record) const;

    friend class ClassicHeader;
    std::vector<Variable> variables_;
    std::uint64_t recordBytes_ = 0;
    std::uint64_t records_ = 0;
};

}  // namespace wrf
