// field_reader.h: rows of fields, x running east and y north whatever the order of the message.
//
// What it keeps of a field is small: places within packed data, and the rows of the last request,
// because the fields that are derived from one are asked for in turn.
#pragma once
#include <map>
#include <memory>

#include "readers/grib/grid.h"
#include "readers/grib/packing.h"
#include "readers/grib/scratch_file.h"
#include "readers/grib/sections.h"

namespace grib {

/// Columns [lower, upper) in x and y.
struct Columns {
    std::array<std::size_t, 2> lower{}, upper{};
    std::size_t length(std::size_t axis) const { return upper[axis] - lower[axis]; }
    std::size_t count() const { return length(0) * length(1); }
};

class FieldReader {
  public:
    /// `fields` all have this grid; both must outlive the reader.
    FieldReader(const InputFile& file, const std::vector<Field>& fields, const Grid& grid)
        : file_(file), fields_(fields), grid_(grid) {}

    /// Fills `values` with the columns of a field, x fastest; NaN where missing. Throws Failure
    /// that names the message.
    void read(std::size_t field, const Columns& columns, std::span<float> values);

    /// Forgets what it keeps, for another time.
    void clear();

  private:
    struct Open {
        std::unique_ptr<LineUnpacker> unpacker;  ///< null where ecCodes unpacks
        std::unique_ptr<Mapping> bitmap, data;
        bool unpacked = false;        ///< whole, in the scratch file
        std::uint64_t scratchAt = 0;  ///< rows from south to north
        std::size_t keptRow = 0;      ///< the first of `kept`
        std::vector<float> kept;      ///< whole rows
    };
    Open& opened(std::size_t field);
    void map(Open& open, const Field& field);
    void rows(Open& open, const Field& field, std::size_t first, std::span<float> values);
    void unpackWhole(Open& open, const Field& field);
    void readLines(Open& open, const Field& field, std::size_t first, std::span<float> values);
    std::vector<float> linesOf(Open& open, const Field& field);

    const InputFile& file_;
    const std::vector<Field>& fields_;
    const Grid& grid_;
    std::map<std::size_t, Open> open_;
    ScratchFile scratch_;
    std::uint64_t mappedBytes_ = 0;
};

}  // namespace grib
