// codes.h: the only door to ecCodes, which has no threads: calls wait for each other.
#pragma once
#include <string>

#include "readers/grib/bytes.h"

namespace grib {

/// All values of a message in the order of its points; NaN where the bitmap says missing. Throws
/// Failure with ecCodes' own words, among them that it was built without a form of packing.
std::vector<float> unpackWithCodes(const Bytes& message, unsigned form);

/// What the tables of ecCodes know of a parameter; empty where they do not.
struct ParameterText {
    std::string shortName, name, units, standardName;
};
ParameterText textWithCodes(const Bytes& message);

}  // namespace grib
