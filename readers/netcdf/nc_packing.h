// nc_packing.h: from the numbers that a NetCDF variable stores to values: packed integers of every
// type, missing values and valid ranges, by the conventions of the NetCDF User's Guide, appendix A.
#pragma once
#include <netcdf.h>

#include <optional>
#include <span>
#include <vector>

namespace nc {

class NcPacking {
  public:
    NcPacking() = default;
    /// Reads scale_factor, add_offset, _Unsigned, _FillValue, missing_value, valid_range, valid_min
    /// and valid_max. The caller holds the lock of the library.
    NcPacking(int file, int variable, nc_type type);

    /// Whether scale_factor or add_offset is there.
    bool packed() const { return packed_; }

    /// Values of stored numbers; NaN where a number is missing or outside the valid range.
    void unpack(std::span<const double> stored, std::span<float> values) const;
    /// The same in place, for variables that are stored as floats.
    void unpack(std::span<float> values) const;
    /// The same in place, without rounding to floats.
    void unpack(std::span<double> values) const;

  private:
    double wrapped(double number) const;
    double valueOf(double stored) const;
    bool isMissing(double number, double value) const;

    bool packed_ = false;
    double scale_ = 1.0, offset_ = 0.0;
    double wrap_ = 0.0;      ///< 2^bits if the sign bit means something else than the type says
    bool toSigned_ = false;  ///< numbers of the upper half are negative; else negative ones wrap
    std::vector<double> missing_;        ///< stored numbers
    std::vector<double> missingValues_;  ///< unpacked, where the attribute can be nothing else
    double least_, most_;                ///< of stored numbers, or of values
    bool limitsValues_ = false;          ///< the range is one of unpacked values
    bool limited_ = false;
};

}  // namespace nc
