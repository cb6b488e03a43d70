// grib_packer_maker.h: complex packing with spatial differencing as NCEP's files have it, for
// messages that ecCodes wrote: ecCodes 2.28 itself packs neither differences nor missing values.
//
// Data templates 7.2 and 7.3 of WMO No. 306, volume I.2.
#pragma once
#include <optional>
#include <span>

#include "tests/readers/grib_maker.h"

struct ComplexPacking {
    int order = 2;    ///< of spatial differencing; 0: none (template 5.2)
    int missing = 0;  ///< 1 or 2: marks for missing values within the data; 0: none may be missing
    int bits = 16;    ///< of the range of values
};

/// The message with other values in complex packing. `values` are in the order of the message,
/// those of the points that its bitmap has, or all of them; nothing where missing.
GribMessage packedComplex(const GribMessage& simple, std::span<const std::optional<double>> values,
                          const ComplexPacking& how);

/// The message with another section of a number, given without its length and number.
GribMessage withSection(const GribMessage& message, int number, std::span<const std::uint8_t> body);
