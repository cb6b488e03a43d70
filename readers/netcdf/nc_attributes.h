// nc_attributes.h: attributes of NetCDF files. The caller holds the lock of the library
// (nc_file.h).
#pragma once
#include <netcdf.h>

#include <optional>
#include <string>
#include <vector>

namespace nc {

/// A text attribute, as characters or as one string, without surrounding blanks; nothing if absent
/// or not text. `variable` may be NC_GLOBAL.
std::optional<std::string> textAttribute(int file, int variable, const char* name);

/// All numbers of an attribute; none if it is absent, longer than any list of missing values, or
/// text.
std::vector<double> numbersAttribute(int file, int variable, const char* name);

/// An attribute that is a single number; nothing if absent or of another kind.
std::optional<double> numberAttribute(int file, int variable, const char* name);

/// Whether an attribute is stored as float or double.
bool isRealAttribute(int file, int variable, const char* name);

}  // namespace nc
