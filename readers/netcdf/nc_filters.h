// nc_filters.h: compression filters of NetCDF-4 files that the machine's HDF5 may lack.
#pragma once
#include <optional>
#include <string>

namespace nc {

/// The first filter of a variable that cannot be undone here, such as "LZF (id 32000)"; nothing if
/// all can. The caller holds the lock of the library.
std::optional<std::string> missingFilter(int file, int variable);

/// What to do about it.
std::string filterHint();

/// Whether a variable is compressed with deflate, after the shuffle filter or without, and passes
/// no other filter. The caller holds the lock of the library.
bool onlyDeflated(int file, int variable);

}  // namespace nc
