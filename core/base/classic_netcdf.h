// classic_netcdf.h: small NetCDF files of the classic format with 64-bit offsets, as text of bytes.
//
// Enough for maps: fixed dimensions, variables of floats or doubles, attributes of text or numbers.
// [NetCDFUG] "NetCDF Classic Format Specification", version 2 (CDF-2), which every NetCDF library
// reads.
#pragma once
#include <string>
#include <variant>
#include <vector>

namespace neph {

/// A name with a text or numbers.
struct NetcdfAttribute {
    std::string name;
    std::variant<std::string, std::vector<double>> value;
};

struct NetcdfDimension {
    std::string name;
    int length = 1;
};

/// Values with the last dimension fastest.
struct NetcdfVariable {
    std::string name;
    std::vector<int> dimensions{};  ///< indices into those of the file; none: a single value
    std::vector<NetcdfAttribute> attributes{};
    std::variant<std::vector<float>, std::vector<double>> values;
};

struct NetcdfContents {
    std::vector<NetcdfDimension> dimensions;
    std::vector<NetcdfAttribute> attributes;
    std::vector<NetcdfVariable> variables;  ///< each with as many values as its dimensions say
};

/// The bytes of the file.
std::string formatNetcdf(const NetcdfContents& contents);

}  // namespace neph
